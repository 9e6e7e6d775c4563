// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

#include "grouping/ball.hpp"
#include "grouping/group_cues.hpp"

namespace objectness {

/// What is looked up again and again while groups are described: prepared once a frame.
struct GroupParts {
  GroupParts(const GroupEvidence& evidence, int threads);

  const GroupEvidence& evidence;
  // Per piece; points in the table frame, a sample of all.
  std::vector<std::vector<Eigen::Vector3f>> points, edges;
  std::vector<Ball> points_ball, edges_ball;  ///< around them
  std::vector<std::vector<cv::Point>> hull;   ///< convex, of the outline; pixels
  float edge_stride = 1;                      ///< pixels of edges that a sampled one stands for
  Eigen::Isometry3f T_camera_table = Eigen::Isometry3f::Identity();
  Eigen::Vector3f eye = Eigen::Vector3f::Zero();  ///< the camera, table frame
};

/// A group as a list and as flags per piece.
struct Members {
  const std::vector<int>& list;
  std::vector<char> inside;
};

}  // namespace objectness
