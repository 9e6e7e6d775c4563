// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "objectness_segmentation/learning/forest.hpp"

namespace objectness {

struct ForestSettings {
  int trees = 60;
  int depth = 9;
  int min_samples = 12;    ///< a node of fewer is not split
  double cue_share = 0.4;  ///< of the cues tried at each node
  unsigned seed = 1;
};

/// What a forest learns from: a row of cues for each target.
struct Samples {
  std::vector<std::string> cues;
  std::vector<float> values;  ///< row by row, cues.size() each
  std::vector<float> targets;

  std::size_t size() const { return targets.size(); }
  /// row: one value per cue.
  void add(const std::vector<float>& row, float target);
};

/// Random regression forest by OpenCV's ml module (Breiman 2001). Same samples and seed: the same forest.
Forest trainForest(const Samples& samples, const ForestSettings& settings);

}  // namespace objectness
