// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace objectness {

// Labels of true label images (labels.png of a scene folder, SceneImages::true_labels): 0 void, 1 to 9 table and other
// background that no segment may be on, 20 to 29 the parts of object 0, 30 to 39 those of object 1, ... Label images of
// results have other ones (kFirstObjectLabel).
// In simulated scenes 1 is the table, and these are:
constexpr int kStageLabel = 2;   ///< a tray, tote or shelf
constexpr int kAroundLabel = 3;  ///< what stands around the table: an arm, a rack, ...
constexpr int kFirstTrueLabel = 20;
constexpr int kTrueLabelsPerObject = 10;

/// The first label of object 0, 1, ...: 20, 30, ...
constexpr int trueLabel(std::size_t object) {
  return kFirstTrueLabel + kTrueLabelsPerObject * static_cast<int>(object);
}

/// The object, 0, 1, ..., that a true label is of; -1 for void and table.
constexpr int trueObject(int label) {
  return label < kFirstTrueLabel ? -1 : (label - kFirstTrueLabel) / kTrueLabelsPerObject;
}

}  // namespace objectness
