// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "objectness_segmentation/learning/forest.hpp"

namespace objectness {

/// A forest as cmake/embed_model.py writes it: the nodes of all trees one after the other.
struct EmbeddedForest {
  const char* const* cues;
  std::size_t cue_count;
  const int* tree_sizes;
  std::size_t tree_count;
  const Forest::Node* nodes;
};

struct EmbeddedModel {
  const char* trained_on;
  EmbeddedForest contact, gap, group;
};

/// cfg/objectness_model.json, built into the library so that there is nothing to find or to parse at run time.
extern const EmbeddedModel kDefaultModel;

}  // namespace objectness
