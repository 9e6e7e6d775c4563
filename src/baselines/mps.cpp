// SPDX-License-Identifier: BSD-3-Clause
#include "baselines/mps.hpp"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/organized_multi_plane_segmentation.h>

#include "baselines/organized_cloud.hpp"
#include "baselines/organized_clusters.hpp"
#include "common/angles.hpp"

namespace objectness {
namespace {

std::vector<pcl::PointIndices> findPlanes(const Frame& frame, const Normals& normals, const MpsConfig& config) {
  pcl::PointCloud<pcl::Normal>::Ptr given(new pcl::PointCloud<pcl::Normal>(frame.width(), frame.height()));
  for (int i = 0; i < frame.size(); ++i) given->points[i].getNormalVector3fMap() = normals.normal[i];
  pcl::OrganizedMultiPlaneSegmentation<pcl::PointXYZ, pcl::Normal, pcl::Label> planes;
  planes.setInputCloud(organizedCloud(frame));
  planes.setInputNormals(given);
  planes.setMinInliers(static_cast<unsigned>(config.min_plane_pixels));
  planes.setAngularThreshold(config.plane_angle_deg * kDegree);
  planes.setDistanceThreshold(config.plane_distance_m);
  planes.setMaximumCurvature(config.plane_max_curvature);
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers;
  planes.segment(models, inliers);
  return inliers;
}

/// Takes the points of planes out of `mask`.
void removePlanes(const std::vector<pcl::PointIndices>& planes, bool keep_object_planes, cv::Mat_<uchar>& mask) {
  for (const pcl::PointIndices& plane : planes) {
    const auto at = [&](int i) -> uchar& { return mask(i / mask.cols, i % mask.cols); };
    std::size_t standing = 0;
    for (const int i : plane.indices) standing += at(i) != 0;
    if (keep_object_planes && 2 * standing > plane.indices.size()) continue;
    for (const int i : plane.indices) at(i) = 0;
  }
}

}  // namespace

std::vector<int> labelMps(const Frame& frame, const Normals& normals, const cv::Mat_<uchar>& object_mask,
                          const MpsConfig& config) {
  cv::Mat_<uchar> mask = object_mask.clone();
  removePlanes(findPlanes(frame, normals, config), config.object_planes, mask);

  return labelOrganizedClusters(frame, mask, config.cluster_distance_m, config.depth_dependent);
}

}  // namespace objectness
