// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/cues/edges.hpp"

namespace objectness {

/// The four kinds of edges of the whole image as pcl::OrganizedEdgeFromNormals finds them.
cv::Mat_<uchar> findPclEdges(const Frame& frame, const Normals& normals);

}  // namespace objectness
