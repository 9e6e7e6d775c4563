// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "objectness_segmentation/common/status.hpp"

namespace objectness {

/// A regression forest: the mean of its trees.
struct Forest {
  struct Node {
    int cue = -1;         ///< -1: a leaf
    float threshold = 0;  ///< cue <= threshold: left
    int left = 0, right = 0;
    float value = 0;  ///< of a leaf
  };
  std::vector<std::string> cues;  ///< names, in the order predict() takes them
  std::vector<std::vector<Node>> trees;

  /// values: one per cue. 0 when there is no tree.
  float predict(const std::vector<float>& values) const;
};

/// {"cues": [name...], "trees": [[[cue, threshold, left, right] | [value], ...], ...]}, the first node of a tree its
/// root and children after their parents.
nlohmann::json toJson(const Forest& forest);

/// kBadInput when the JSON is no forest of these cues: predict() cannot then run out of a tree or go round in it.
Result<Forest> parseForest(const nlohmann::json& json, const std::vector<std::string>& cues);

}  // namespace objectness
