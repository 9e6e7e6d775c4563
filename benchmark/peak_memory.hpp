// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "frame_methods.hpp"
#include "scene_store.hpp"

namespace objectness::benchmarks {

/// The most memory (MiB) that a process held which read one scene and segmented it once.
class PeakMemory {
 public:
  /// Measures all of the package's own methods in all scenes, each in a process of its own that calls runAlone(). A
  /// fork would not do: it shares the libraries' pages with its parent.
  void measure(const std::vector<BenchmarkScene>& scenes, const std::vector<FrameMethod>& methods);

  /// 0 where it was not measured or the process failed.
  double mib(const BenchmarkScene& scene, const FrameMethod& method) const;

 private:
  std::map<std::string, double> mib_;
};

/// Reads one scene and segments it once by the method "NAME/VOLUME"; what this program does with --alone.
bool runAlone(const std::string& method, const BenchmarkScene& scene);

}  // namespace objectness::benchmarks
