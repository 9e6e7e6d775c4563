// SPDX-License-Identifier: BSD-3-Clause
#include "cues/pcl_edges.hpp"

#include <pcl/features/organized_edge_detection.h>
#include <pcl/point_types.h>

#include <cmath>
#include <limits>

namespace objectness {
namespace {

// PCL's own defaults, which the paper's edges were made with.
constexpr float kRelativeDepthStep = 0.02f;
constexpr float kCannyLow = 0.4f, kCannyHigh = 1.1f;
constexpr int kGapSearchPx = 50;

using Detector = pcl::OrganizedEdgeFromNormals<pcl::PointXYZ, pcl::Normal, pcl::Label>;

/// Near or far side of the largest depth difference around (u, v), looking across missing depth. PCL's own answer
/// cannot be relied on: some versions swap the two kinds.
uchar sideOfJump(const Frame& frame, int u, int v) {
  const float z = frame.points[v * frame.width() + u].z();
  float dominant = 0;
  for (int dv = -1; dv <= 1; ++dv) {
    for (int du = -1; du <= 1; ++du) {
      if (du == 0 && dv == 0) continue;
      for (int k = 1; k <= kGapSearchPx; ++k) {
        const int x = u + k * du, y = v + k * dv;
        if (x < 0 || y < 0 || x >= frame.width() || y >= frame.height()) break;
        const float other = frame.points[y * frame.width() + x].z();
        if (std::isnan(other)) continue;
        if (std::abs(z - other) > std::abs(dominant)) dominant = z - other;
        break;
      }
    }
  }
  return dominant > 0 ? kOccluded : kOccluding;
}

}  // namespace

cv::Mat_<uchar> findPclEdges(const Frame& frame, const Normals& normals) {
  const int width = frame.width(), height = frame.height();
  const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>(width, height));
  const pcl::PointCloud<pcl::Normal>::Ptr cloud_normals(new pcl::PointCloud<pcl::Normal>(width, height));
  for (int i = 0; i < frame.size(); ++i) {
    cloud->points[i].getVector3fMap() = frame.points[i];
    cloud_normals->points[i].getNormalVector3fMap() = normals.normal[i];
  }
  cloud->is_dense = cloud_normals->is_dense = false;

  Detector detector;
  detector.setInputCloud(cloud);
  detector.setInputNormals(cloud_normals);
  detector.setEdgeType(Detector::EDGELABEL_NAN_BOUNDARY | Detector::EDGELABEL_OCCLUDING | Detector::EDGELABEL_OCCLUDED |
                       Detector::EDGELABEL_HIGH_CURVATURE);
  detector.setDepthDisconThreshold(kRelativeDepthStep);
  detector.setMaxSearchNeighbors(kGapSearchPx);
  detector.setHCCannyLowThreshold(kCannyLow);
  detector.setHCCannyHighThreshold(kCannyHigh);
  pcl::PointCloud<pcl::Label> labels;
  std::vector<pcl::PointIndices> by_kind;
  detector.compute(labels, by_kind);

  constexpr int kDepthEdge = Detector::EDGELABEL_OCCLUDING | Detector::EDGELABEL_OCCLUDED;
  cv::Mat_<uchar> kinds = cv::Mat_<uchar>::zeros(height, width);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const int pixel = v * width + u;
      const auto label = labels.points[pixel].label;
      if (std::isnan(frame.points[pixel].z())) continue;
      if (label & Detector::EDGELABEL_HIGH_CURVATURE) kinds(pixel) |= kHighCurvature;
      if (label & Detector::EDGELABEL_NAN_BOUNDARY) kinds(pixel) |= kBorder;
      if (label & kDepthEdge) kinds(pixel) |= sideOfJump(frame, u, v);
    }
  }
  return kinds;
}

}  // namespace objectness
