// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "objectness_segmentation/common/status.hpp"
#include "objectness_segmentation/config.hpp"
#include "objectness_segmentation/learning/learned_objectness.hpp"
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
  InputConfig input = {};       ///< how its frames are read
  /// In the place of `run`, of a method that is told the truth: true_labels as in labels.png, of the frame's size.
  std::function<Segmentation(const Frame&, const cv::Mat_<ushort>& true_labels)> run_knowing = {};
  /// Begins a FrameSequence, whose frames are then handed to what it returns, in their order. Empty: `run` for each.
  std::function<std::function<Segmentation(const Frame&)>(int fuse_frames)> follow = {};
  int fuse_frames = 0;  ///< of a scene with frames before it; 0: these are not looked at
};

/// The names makeMethods() knows, the default one first.
std::vector<std::string> methodNames();

/// Those of them that are ways to segment: without `oracle` and `clustering`, which tell what others are worth.
std::vector<std::string> usualMethodNames();

/// Methods by name. Each runs with `config` but for what makes it that method (pipeline.method);
/// `objectness`, `oracle` and `clustering` with `model`, none: the built-in one.
/// kBadConfig: an unknown name.
Result<std::vector<Method>> makeMethods(const std::vector<std::string>& names, const Config& config,
                                        const std::optional<LearnedObjectness>& model = {});

}  // namespace objectness::evaluation
