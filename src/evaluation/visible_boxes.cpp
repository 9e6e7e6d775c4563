// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/visible_boxes.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "common/angles.hpp"

namespace objectness::evaluation {
namespace {

constexpr float kNeighbor_m = 0.02f;  // pixels of one surface are no farther apart
constexpr int kMinNeighbors = 4;      // of eight; a pixel with fewer hangs between surfaces

/// The owner of each pixel that lies on the owner's surface, -1 of all others.
cv::Mat_<int> surfacePixels(const Frame& frame, const cv::Mat_<int>& owners) {
  cv::Mat_<int> on_surface(owners.size(), -1);
  for (int v = 1; v + 1 < owners.rows; ++v) {
    for (int u = 1; u + 1 < owners.cols; ++u) {
      const int owner = owners(v, u);
      if (owner < 0) continue;
      const Eigen::Vector3f& p = frame.points[v * owners.cols + u];
      int neighbors = -1;  // the pixel itself
      for (int dv = -1; dv <= 1; ++dv) {
        for (int du = -1; du <= 1; ++du) {
          const Eigen::Vector3f& q = frame.points[(v + dv) * owners.cols + u + du];
          neighbors += owners(v + dv, u + du) == owner && (p - q).norm() < kNeighbor_m;
        }
      }
      if (neighbors >= kMinNeighbors) on_surface(v, u) = owner;
    }
  }
  return on_surface;
}

struct VisiblePoints {
  std::vector<cv::Point2f> footprint;
  double low_m = 0, high_m = 0;  ///< heights above the table
};

OrientedBox boxAround(const VisiblePoints& points, const Eigen::Isometry3d& T_table_camera) {
  const cv::RotatedRect rectangle = cv::minAreaRect(points.footprint);
  Eigen::Isometry3d T_table_box = Eigen::Isometry3d::Identity();
  T_table_box.translation() << rectangle.center.x, rectangle.center.y, 0.5 * (points.low_m + points.high_m);
  T_table_box.rotate(Eigen::AngleAxisd(rectangle.angle * kDegree, Eigen::Vector3d::UnitZ()));
  return {T_table_camera.inverse() * T_table_box,
          {rectangle.size.width, rectangle.size.height, points.high_m - points.low_m}};
}

}  // namespace

std::map<int, OrientedBox> visibleBoxes(const Frame& frame, const Table& table, const cv::Mat_<int>& owners,
                                        BoxBase base) {
  const cv::Mat_<int> on_surface = surfacePixels(frame, owners);
  std::map<int, VisiblePoints> points_of;
  for (int i = 0; i < frame.size(); ++i) {
    const int owner = on_surface(i / frame.width(), i % frame.width());
    if (owner < 0) continue;
    const Eigen::Vector3d p = table.T_table_camera * frame.points[i].cast<double>();
    VisiblePoints& points = points_of[owner];
    const bool first = points.footprint.empty();
    points.footprint.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()));
    points.high_m = first ? p.z() : std::max(points.high_m, p.z());
    points.low_m = base == BoxBase::kTable ? 0 : first ? p.z() : std::min(points.low_m, p.z());
  }
  std::map<int, OrientedBox> boxes;
  for (const auto& [owner, points] : points_of) {
    if (points.high_m > points.low_m) boxes[owner] = boxAround(points, table.T_table_camera);
  }
  return boxes;
}

}  // namespace objectness::evaluation
