// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/common/status.hpp"
#include "objectness_segmentation/cues/edges.hpp"
#include "objectness_segmentation/cues/superpixels.hpp"
#include "objectness_segmentation/scene/normals.hpp"
#include "objectness_segmentation/scene/object_points.hpp"
#include "objectness_segmentation/scene/table.hpp"

namespace objectness {

/// What is observed in a frame before anything is segmented. Every method, the learning and the baselines start from
/// it. When status is not ok(), what was found before the failure is kept.
struct SceneObservation {
  Status status;
  Normals normals;             ///< those of all later stages: refined once the table and its noise are known
  Table table;                 ///< paper Sec. 2
  ObjectPoints object_points;  ///< paper Sec. 2
  EdgeMap edges;               ///< paper Sec. 3.1; not for the baselines
  Superpixels superpixels;     ///< paper Sec. 3.3; not for the baselines
};

}  // namespace objectness
