// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/scene/normals.hpp"

namespace objectness {

/// Replaces the normals by those of pcl::IntegralImageNormalEstimation; a pixel that either method leaves out has none.
/// Residuals and jumps stay those of the inverse-depth fit.
void replaceByPclNormals(const Frame& frame, Normals& normals);

}  // namespace objectness
