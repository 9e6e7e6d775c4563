// SPDX-License-Identifier: BSD-3-Clause
#include "segments/segments.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "common/parallel.hpp"
#include "segments/geodesic_assignment.hpp"

namespace objectness {
namespace {

/// The points in a box, by index.
std::vector<int> pointsIn(const SelectedBox& selected, const std::vector<Eigen::Vector3f>& points,
                          double margin_voxels) {
  const Box& b = selected.scored.box;
  const Grid& grid = selected.grid;
  // Most points lie nowhere near: a circle around the box tells.
  const Eigen::Vector2f centre = grid.toTable({0.5 * (b.x0 + b.x1), 0.5 * (b.y0 + b.y1), 0}).head<2>().cast<float>();
  const double half_diagonal = 0.5 * std::hypot(b.sizeX(), b.sizeY()) + std::sqrt(2.0) * margin_voxels;
  const float reach = static_cast<float>((half_diagonal + 0.1) * grid.voxel_m);
  std::vector<int> inside;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float dx = points[i].x() - centre.x(), dy = points[i].y() - centre.y();
    if (dx * dx + dy * dy > reach * reach) continue;
    const Eigen::Vector3d q = grid.toGrid(points[i].cast<double>());
    if (q.x() >= b.x0 - margin_voxels && q.x() < b.x1 + margin_voxels && q.y() >= b.y0 - margin_voxels &&
        q.y() < b.y1 + margin_voxels && q.z() < b.height + margin_voxels) {
      inside.push_back(static_cast<int>(i));
    }
  }
  return inside;
}

/// For each superpixel the box that holds most of its points, -1 where no box holds enough. in_box: per box the points
/// in it.
std::vector<int> followedBoxes(const CuePoints& points, const std::vector<std::vector<int>>& in_box, double min_share) {
  std::vector<int> size(points.superpixels + 1, 0), best(points.superpixels + 1, -1),
      best_count(points.superpixels + 1, 0);
  for (const int label : points.labels) ++size[label];
  for (std::size_t k = 0; k < in_box.size(); ++k) {
    std::vector<int> count(points.superpixels + 1, 0);
    for (const int i : in_box[k]) ++count[points.labels[i]];
    for (int s = 1; s <= points.superpixels; ++s) {
      if (count[s] <= best_count[s] || count[s] < min_share * size[s]) continue;
      best[s] = static_cast<int>(k);
      best_count[s] = count[s];
    }
  }
  return best;
}

/// The label that all pixels around this one share but those marked kOpen; 0 when there is none.
constexpr ushort kOpen = 65535;
ushort sharedLabel(const cv::Mat_<ushort>& labels, int u, int v) {
  ushort shared = kOpen;
  for (int y = std::max(0, v - 1); y <= std::min(labels.rows - 1, v + 1); ++y) {
    for (int x = std::max(0, u - 1); x <= std::min(labels.cols - 1, u + 1); ++x) {
      const ushort label = labels(y, x);
      if (label == kOpen) continue;
      if (shared != kOpen && shared != label) return 0;
      shared = label;
    }
  }
  return shared == kOpen ? 0 : shared;
}

void labelBridged(const std::vector<int>& bridged, cv::Mat_<ushort>& labels) {
  for (const int i : bridged) labels(i / labels.cols, i % labels.cols) = kOpen;
  std::vector<ushort> shared;
  shared.reserve(bridged.size());
  for (const int i : bridged) shared.push_back(sharedLabel(labels, i % labels.cols, i / labels.cols));
  for (std::size_t k = 0; k < bridged.size(); ++k) {
    labels(bridged[k] / labels.cols, bridged[k] % labels.cols) = shared[k];
  }
}

}  // namespace

OrientedBox orientedBox(const Box& box, const Grid& grid, const Eigen::Isometry3d& T_table_camera) {
  Eigen::Isometry3d T_table_box = Eigen::Isometry3d::Identity();
  T_table_box.translate(grid.toTable({0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1), 0.5 * box.height}));
  T_table_box.rotate(Eigen::AngleAxisd(grid.angle_rad, Eigen::Vector3d::UnitZ()));
  return {T_table_camera.inverse() * T_table_box, grid.voxel_m * Eigen::Vector3d(box.sizeX(), box.sizeY(), box.height)};
}

std::vector<Segment> cutSegments(const Frame& frame, const Eigen::Isometry3d& T_table_camera, const CuePoints& points,
                                 const std::vector<SelectedBox>& boxes, double margin_m, bool follow_superpixels,
                                 const SegmentsConfig& config, int threads) {
  const std::size_t count = points.points.size();
  std::vector<std::vector<int>> in_box(boxes.size());
  cv::Mat_<int> owner(frame.height(), frame.width(), -1);
  const auto ownerOf = [&](std::size_t i) -> int& {
    return owner(points.pixels[i] / frame.width(), points.pixels[i] % frame.width());
  };
  parallelFor(static_cast<int>(boxes.size()), threads,
              [&](int k) { in_box[k] = pointsIn(boxes[k], points.points, margin_m / boxes[k].grid.voxel_m); });
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    for (const int i : in_box[k]) {
      if (ownerOf(i) < 0) ownerOf(i) = static_cast<int>(k);
    }
  }
  if (follow_superpixels) {
    const std::vector<int> followed = followedBoxes(points, in_box, config.min_superpixel_share);
    cv::Mat_<uchar> open(frame.height(), frame.width(), static_cast<uchar>(0));
    for (std::size_t i = 0; i < count; ++i) {
      const int label = points.labels[i];
      if (label > 0) ownerOf(i) = followed[label];
      if (label == 0) open(points.pixels[i] / frame.width(), points.pixels[i] % frame.width()) = 255;
    }
    assignGeodesic(frame, open, {config.max_step_m, config.max_reach_m}, owner, threads);
  }

  std::vector<Segment> segments(boxes.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (ownerOf(i) >= 0) segments[ownerOf(i)].pixels.push_back(points.pixels[i]);
  }
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    segments[k].box = orientedBox(boxes[k].scored.box, boxes[k].grid, T_table_camera);
    segments[k].objectness = boxes[k].scored.objectness;
    segments[k].cues = boxes[k].scored.cues;
  }
  const auto small = [&](const Segment& s) { return s.pixels.size() < static_cast<std::size_t>(config.min_pixels); };
  segments.erase(std::remove_if(segments.begin(), segments.end(), small), segments.end());
  return segments;
}

void dropEmpty(std::vector<Segment>& segments) {
  std::vector<int> moved(segments.size(), -1);
  std::vector<Segment> kept;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    if (segments[k].pixels.empty()) continue;
    moved[k] = static_cast<int>(kept.size());
    kept.push_back(std::move(segments[k]));
  }
  for (Segment& segment : kept) {
    if (segment.support.kind == SupportKind::kSegment) {
      segment.support.segment = moved[segment.support.segment];
      if (segment.support.segment < 0) segment.support.kind = SupportKind::kOther;
    }
    std::vector<int> carried;
    for (const int other : segment.carried) {
      if (moved[other] >= 0) carried.push_back(moved[other]);
    }
    segment.carried = std::move(carried);
  }
  segments = std::move(kept);
}

void keepMeasured(const std::vector<int>& bridged, std::vector<Segment>& segments) {
  if (bridged.empty()) return;
  for (Segment& segment : segments) {
    std::vector<int> measured;
    std::set_difference(segment.pixels.begin(), segment.pixels.end(), bridged.begin(), bridged.end(),
                        std::back_inserter(measured));
    segment.pixels = std::move(measured);
  }
  dropEmpty(segments);
}

cv::Mat_<ushort> labelImage(const cv::Mat_<uchar>& on_table, const std::vector<int>& bridged,
                            const std::vector<Segment>& segments) {
  cv::Mat_<ushort> labels(on_table.size(), static_cast<ushort>(0));
  labels.setTo(1, on_table);
  for (std::size_t k = 0; k < segments.size(); ++k) {
    for (const int pixel : segments[k].pixels)
      labels(pixel / labels.cols, pixel % labels.cols) = static_cast<ushort>(k + kFirstObjectLabel);
  }
  labelBridged(bridged, labels);
  return labels;
}

}  // namespace objectness
