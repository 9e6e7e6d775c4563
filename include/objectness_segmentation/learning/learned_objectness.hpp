// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "objectness_segmentation/learning/forest.hpp"

namespace objectness {

/// What was learned from scenes whose objects are known; see the tool learn_objectness.
struct LearnedObjectness {
  Forest contact;          ///< ContactCues -> probability that two pieces that touch are parts of one object
  Forest gap;              ///< GapCues -> the same for pieces that do not touch
  Forest group;            ///< GroupCues -> expected overlap (intersection over union) of a group with a true object
  std::string trained_on;  ///< which scenes, in words
};

/// The model that comes with the package.
const LearnedObjectness& defaultModel();

/// {"trained_on": text, "contact": forest, "gap": forest, "group": forest}. A model of other cues than this version's
/// is refused (kBadInput) with the names that differ.
Result<LearnedObjectness> parseModel(const std::string& json);
Result<LearnedObjectness> loadModel(const std::string& path);
std::string toJson(const LearnedObjectness& model);

}  // namespace objectness
