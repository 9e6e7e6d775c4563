// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/grouping/group_cues.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "group_parts.hpp"
#include "objectness_segmentation/common/parallel.hpp"
#include "objectness_segmentation/grouping/group_box.hpp"

namespace objectness {
namespace {

// Samples of all that is seen: the cues are shares, a few thousand points tell them to a percent.
constexpr std::size_t kPoints = 2500, kEdges = 1500;
constexpr int kOutlinePixels = 200;  // of a piece
constexpr std::size_t kFaces = 3;    // pieces whose normals a tilted box may follow
constexpr float kFlat = 0.95f;       // length of the mean normal of a flat piece
constexpr double kMinSize_m = 0.005;

/// In the table frame, as are the points.
OrientedBox boxOf(const GroupParts& parts, const std::vector<int>& group) {
  std::vector<Eigen::Vector3f> points, directions;
  std::vector<std::pair<float, int>> by_area;
  for (const int k : group) {
    points.insert(points.end(), parts.points[k].begin(), parts.points[k].end());
    const Piece& piece = parts.evidence.pieces.pieces[k];
    if (piece.smooth_pixels > 0 && piece.mean_normal.norm() > kFlat) by_area.emplace_back(-piece.area_m2, k);
  }
  std::sort(by_area.begin(), by_area.end());
  const Eigen::Matrix3f R = parts.T_camera_table.linear().transpose();
  for (std::size_t i = 0; i < std::min(kFaces, by_area.size()); ++i) {
    directions.push_back((R * parts.evidence.pieces.pieces[by_area[i].second].mean_normal).normalized());
  }
  return tightBox(points, directions, kMinSize_m);
}

}  // namespace

GroupParts::GroupParts(const GroupEvidence& given) : evidence(given) {
  const auto& pieces = evidence.pieces.pieces;
  std::size_t pixels = 0, edge_pixels = 0;
  for (const Piece& piece : pieces) {
    pixels += piece.pixels.size();
    for (const int pixel : piece.pixels) edge_pixels += evidence.edges.kinds(pixel) != 0;
  }
  const std::size_t stride = 1 + pixels / kPoints, stride_of_edges = 1 + edge_pixels / kEdges;
  edge_stride = static_cast<float>(stride_of_edges);
  const Eigen::Isometry3f T_table_camera = evidence.table.T_table_camera.cast<float>();
  T_camera_table = T_table_camera.inverse();
  eye = T_table_camera.translation();
  points.resize(pieces.size());
  edges.resize(pieces.size());
  std::size_t edge = 0;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    for (std::size_t i = 0; i < pieces[k].pixels.size(); ++i) {
      const int pixel = pieces[k].pixels[i];
      const bool is_edge = evidence.edges.kinds(pixel) && edge++ % stride_of_edges == 0;
      if (i % stride != 0 && !is_edge) continue;
      const Eigen::Vector3f p = T_table_camera * evidence.frame.points[pixel];
      if (i % stride == 0) points[k].push_back(p);
      if (is_edge) edges[k].push_back(p);
    }
  }
  for (const auto& members : points) points_ball.push_back(ballAround(members));
  for (const auto& members : edges) edges_ball.push_back(ballAround(members));
  const auto outlines = outlinePixels(evidence.pieces, kOutlinePixels);
  const int width = evidence.frame.width();
  hull.resize(pieces.size());
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    std::vector<cv::Point> outline;
    for (const int pixel : outlines[k]) outline.emplace_back(pixel % width, pixel / width);
    if (!outline.empty()) cv::convexHull(outline, hull[k]);
  }
}

std::vector<GroupHypothesis> describeGroups(const GroupEvidence& evidence, const std::vector<std::vector<int>>& groups,
                                            int threads) {
  const GroupParts parts(evidence);
  std::vector<GroupHypothesis> described(groups.size());
  parallelFor(static_cast<int>(groups.size()), threads, [&](int i) {
    Members members{groups[i], std::vector<char>(evidence.pieces.count(), 0)};
    for (const int k : groups[i]) members.inside[k] = 1;
    GroupHypothesis& hypothesis = described[i];
    hypothesis.pieces = groups[i];
    const OrientedBox box = boxOf(parts, groups[i]);
    hypothesis.box = {evidence.table.T_table_camera.inverse() * box.T_camera_box, box.size_m};
    addLinkCues(evidence, members, hypothesis.cues);
    addOutlineCues(evidence, members, hypothesis.cues);
    addBoxCues(parts, members, box, hypothesis.cues);
    addVolumeCues(parts, members, box, hypothesis.cues);
  });
  return described;
}

}  // namespace objectness
