// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/common/range.hpp"
#include "objectness_segmentation/grouping/cue_switches.hpp"
#include "objectness_segmentation/grouping/cues.hpp"

namespace objectness {

struct PiecesConfig {
  double max_reach_m = 0.04;
  double max_step_m = 0.015;
  double min_area_m2 = 0.4e-4;
  int min_pixels = 30;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("max_reach_m", self.max_reach_m, Range{0, 0.5},
          "how far along the surface a point follows its nearest superpixel");
    visit("max_step_m", self.max_step_m, Range{0.001, 0.1}, "neighbouring pixels farther apart are not on one surface");
    visit("min_area_m2", self.min_area_m2, Range{0, 0.01}, "rough parts that show less surface are no pieces");
    visit("min_pixels", self.min_pixels, Range{1, 100000}, "rough parts of fewer pixels are no pieces");
  }
};

struct LinksConfig {
  double max_gap_m = 0.25;
  bool gaps = true;
  CueSwitches<ContactCues> contact_cues;  // their fields are groups of their own: see Config
  CueSwitches<GapCues> gap_cues;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("max_gap_m", self.max_gap_m, Range{0, 1}, "pieces farther apart are not parts of one object");
    visit("gaps", self.gaps,
          "pieces that do not touch can be linked over the gap; off: nothing is known of such pairs");
  }
};

/// Which groups are proposed beside the single pieces.
struct GroupKinds {
  bool dendrograms = true, grown = true;
};

struct GroupingConfig {
  bool learned = true;
  GroupKinds kinds;
  int max_groups = 1000;
  int max_all_groups = 4000;
  bool paper_cost = false;
  double weight_objectness = 30.0;
  double least_objectness = 0.4;
  bool standing = true;
  double weight_gaps = 0.5;
  double memory_objectness = 0.15;
  double memory_log_odds = 1.0;
  int exact_nodes = 200000;
  int iterations = 50000;
  bool compare_annealing = false;
  CueSwitches<GroupCues> cues;  // its fields are a group of their own: see Config

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("learned", self.learned,
          "links and groups are judged by the model; off: by rules set by hand and Eq. 6 of the group's box");
    visit("dendrograms", self.kinds.dendrograms, "groups are proposed that three ways of merging pieces pass through");
    visit("grown", self.kinds.grown,
          "groups are proposed that grow from each piece, and those with a piece more or less");
    visit("max_groups", self.max_groups, Range{1, 100000},
          "groups that are judged of each connected part of the scene, the best linked ones");
    visit("max_all_groups", self.max_all_groups, Range{1, 1000000}, "groups that are judged in all: bounds the time");
    visit("paper_cost", self.paper_cost,
          "groups are chosen by the paper's cost and annealing (selection), not by set packing");
    visit("weight_objectness", self.weight_objectness, Range{0, 1000},
          "of the objectness of a group, per piece, beside the log odds of its links");
    visit("least_objectness", self.least_objectness, Range{0, 1}, "a group under it is rather left out");
    visit("standing", self.standing,
          "what stands alone on the table, compact and well over the noise, is an object even if all of its groups are "
          "under least_objectness");
    visit("weight_gaps", self.weight_gaps, Range{0, 10}, "of links over a gap; links in contact count 1");
    visit("memory_objectness", self.memory_objectness, Range{0, 1},
          "frames that follow one another: what a group that was one object in the frame before has ahead, and one "
          "that was "
          "none lags behind");
    visit("memory_log_odds", self.memory_log_odds, Range{0, 10},
          "and links within it, of their log odds; links to others lose as much");
    visit("exact_nodes", self.exact_nodes, Range{0, 100000000},
          "branch and bound gives up after so many steps, and annealing tries to better what it found");
    visit("iterations", self.iterations, Range{0, 10000000}, "annealing: moves tried");
    visit("compare_annealing", self.compare_annealing,
          "annealing is tried in any case, to report how far from the best packing it ends; the choice stays the same");
  }
};

}  // namespace objectness
