// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "objectness_segmentation/common/status.hpp"
#include "objectness_segmentation/result.hpp"
#include "objectness_segmentation/scene/frame.hpp"

namespace objectness::evaluation {

/// A way to segment a frame, with all that a reader of its results must know.
struct Method {
  std::string name;
  std::string description;  ///< a sentence
  std::string settings;     ///< every value it ran with; two methods of equal settings give equal results
  std::function<Segmentation(const Frame&)> run;
  bool proposes_boxes = false;  ///< fills Segmentation::proposals
};

/// The names makeMethods() knows, the default one first.
std::vector<std::string> methodNames();

/// Methods by name, each with `threads` worker threads (0: one per processor). kBadConfig: an unknown name.
Result<std::vector<Method>> makeMethods(const std::vector<std::string>& names, int threads);

}  // namespace objectness::evaluation
