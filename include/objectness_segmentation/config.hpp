// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "objectness_segmentation/cues/edges.hpp"
#include "objectness_segmentation/cues/superpixels.hpp"
#include "objectness_segmentation/grouping/grouping_config.hpp"
#include "objectness_segmentation/integral/volume_config.hpp"
#include "objectness_segmentation/method.hpp"
#include "objectness_segmentation/objectness/objectness_config.hpp"
#include "objectness_segmentation/scene/frame.hpp"
#include "objectness_segmentation/scene/normals.hpp"
#include "objectness_segmentation/scene/object_points.hpp"
#include "objectness_segmentation/scene/resolution_config.hpp"
#include "objectness_segmentation/scene/table.hpp"
#include "objectness_segmentation/search/search_config.hpp"
#include "objectness_segmentation/segments/segments_config.hpp"
#include "objectness_segmentation/segments/unmeasured.hpp"
#include "objectness_segmentation/selection/selection_config.hpp"
#include "objectness_segmentation/tracking/tracker.hpp"

namespace objectness {

struct RuntimeConfig {
  int threads = 2;
  int seed = 1;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("threads", self.threads, Range{0, 64},
          "worker threads, 0: one per processor; the result does not depend on it");
    visit("seed", self.seed, Range{0, 2147483647}, "seed of the annealing");
  }
};

/// Everything that can be set, a struct per stage in the order of the pipeline. A field's full name is "group.field",
/// as in the YAML presets ("objectness.weight_edges").
struct Config {
  PipelineConfig pipeline;
  InputConfig input;
  ResolutionConfig resolution;
  NormalsConfig normals;
  TableConfig table;
  ObjectPointsConfig object_points;
  EdgesConfig edges;
  SuperpixelsConfig superpixels;
  VolumeConfig volume;
  SearchConfig search;
  ObjectnessConfig objectness;
  FilterConfig filter;
  SelectionConfig selection;
  PiecesConfig pieces;
  LinksConfig links;
  GroupingConfig grouping;
  SegmentsConfig segments;
  BackgroundConfig background;
  UnmeasuredConfig unmeasured;
  TrackingConfig tracking;  ///< from frame to frame: not used by segment()
  RuntimeConfig runtime;

  template <class Self, class Visit>
  static void groups(Self& self, Visit&& visit) {
    visit("pipeline", self.pipeline);
    visit("input", self.input);
    visit("resolution", self.resolution);
    visit("normals", self.normals);
    visit("table", self.table);
    visit("object_points", self.object_points);
    visit("edges", self.edges);
    visit("superpixels", self.superpixels);
    visit("volume", self.volume);
    visit("search", self.search);
    visit("objectness", self.objectness);
    visit("filter", self.filter);
    visit("selection", self.selection);
    visit("pieces", self.pieces);
    visit("links", self.links);
    visit("contact_cues", self.links.contact_cues);
    visit("gap_cues", self.links.gap_cues);
    visit("grouping", self.grouping);
    visit("group_cues", self.grouping.cues);
    visit("segments", self.segments);
    visit("background", self.background);
    visit("unmeasured", self.unmeasured);
    visit("tracking", self.tracking);
    visit("runtime", self.runtime);
  }
};

/// Every value outside its range and every contradiction between fields, a sentence each that names the field, its
/// value and what is accepted; empty = valid.
std::vector<std::string> validate(const Config& config);

}  // namespace objectness
