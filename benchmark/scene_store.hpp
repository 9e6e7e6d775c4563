// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "evaluation/scenes.hpp"
#include "objectness_segmentation/common/status.hpp"
#include "objectness_segmentation/scene/frame.hpp"

namespace objectness::benchmarks {

/// What a figure is about: a scene folder and what its truth says.
struct BenchmarkScene {
  evaluation::Scene source;
  int width = 0, height = 0;  ///< of its picture
  int objects = 0;
};

/// The scenes of `paths` as evaluate takes them. kBadInput names the first that cannot be used.
Result<std::vector<BenchmarkScene>> findBenchmarkScenes(const std::vector<std::string>& paths);

/// The scene as a frame. Only the one that was asked for last is kept, so that the memory does not grow with the list.
/// Throws std::runtime_error when it cannot be read.
const Frame& frameOf(const BenchmarkScene& scene);

}  // namespace objectness::benchmarks
