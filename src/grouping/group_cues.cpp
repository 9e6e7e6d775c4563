// SPDX-License-Identifier: BSD-3-Clause
#include "grouping/group_cues.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "common/parallel.hpp"
#include "grouping/box_cues.hpp"
#include "grouping/group_box.hpp"
#include "grouping/link_cues.hpp"

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

GroupParts::GroupParts(const GroupEvidence& given, int threads) : evidence(given) {
  const auto& pieces = evidence.pieces.pieces;
  const int count = static_cast<int>(pieces.size());
  const auto isEdge = [&](int pixel) { return evidence.edges.kinds(pixel) != 0; };
  std::vector<std::size_t> edges_of(pieces.size());
  parallelFor(count, threads,
              [&](int k) { edges_of[k] = std::count_if(pieces[k].pixels.begin(), pieces[k].pixels.end(), isEdge); });
  // How many of the edges lie in the pieces before each.
  std::size_t pixels = 0, edge_pixels = 0;
  for (int k = 0; k < count; ++k) {
    pixels += pieces[k].pixels.size();
    edge_pixels += std::exchange(edges_of[k], edge_pixels);
  }
  const std::size_t stride = 1 + pixels / kPoints, stride_of_edges = 1 + edge_pixels / kEdges;
  edge_stride = static_cast<float>(stride_of_edges);
  const Eigen::Isometry3f T_table_camera = evidence.table.T_table_camera.cast<float>();
  T_camera_table = T_table_camera.inverse();
  eye = T_table_camera.translation();
  points.resize(pieces.size());
  edges.resize(pieces.size());
  points_ball.resize(pieces.size());
  edges_ball.resize(pieces.size());
  hull.resize(pieces.size());
  const auto outlines = outlinePixels(evidence.pieces, kOutlinePixels, threads);
  const int width = evidence.frame.width();
  parallelFor(count, threads, [&](int k) {
    std::size_t edge = edges_of[k];
    for (std::size_t i = 0; i < pieces[k].pixels.size(); ++i) {
      const int pixel = pieces[k].pixels[i];
      const bool is_edge = isEdge(pixel) && edge++ % stride_of_edges == 0;
      if (i % stride != 0 && !is_edge) continue;
      const Eigen::Vector3f p = T_table_camera * evidence.frame.points[pixel];
      if (i % stride == 0) points[k].push_back(p);
      if (is_edge) edges[k].push_back(p);
    }
    points_ball[k] = ballAround(points[k]);
    edges_ball[k] = ballAround(edges[k]);
    std::vector<cv::Point> outline;
    for (const int pixel : outlines[k]) outline.emplace_back(pixel % width, pixel / width);
    if (!outline.empty()) cv::convexHull(outline, hull[k]);
  });
}

std::vector<GroupHypothesis> describeGroups(const GroupEvidence& evidence, const std::vector<std::vector<int>>& groups,
                                            int threads) {
  const GroupParts parts(evidence, threads);
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
