// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "baselines/baselines_config.hpp"
#include "objectness_segmentation/scene/object_points.hpp"

namespace objectness {

/// A frame cut by the plane that most of its points lie on.
struct PlaneCut {
  Plane plane;
  ObjectPoints points;  ///< mask: what is to be clustered; on_table: the inliers of the plane
};

/// Passthrough by depth, then one plane by RANSAC (pcl::PassThrough; pcl::SACSegmentation with pcl::SACMODEL_PLANE,
/// seeded with a constant). kNoTable when there is none.
Result<PlaneCut> cutByPlane(const Frame& frame, const RansacPlaneConfig& config);

}  // namespace objectness
