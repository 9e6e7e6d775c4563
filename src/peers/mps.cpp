// SPDX-License-Identifier: BSD-3-Clause
#include "mps.hpp"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/euclidean_cluster_comparator.h>
#include <pcl/segmentation/organized_connected_component_segmentation.h>
#include <pcl/segmentation/organized_multi_plane_segmentation.h>

#include <limits>

#include "objectness_segmentation/common/angles.hpp"

namespace objectness {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// The frame's points where `mask` is not zero, NaN elsewhere; all of them without a mask.
Cloud::Ptr toCloud(const Frame& frame, const cv::Mat_<uchar>& mask = {}) {
  Cloud::Ptr cloud(new Cloud(frame.width(), frame.height(), pcl::PointXYZ(kNaN, kNaN, kNaN)));
  for (int i = 0; i < frame.size(); ++i) {
    if (mask.empty() || mask(i / frame.width(), i % frame.width())) {
      cloud->points[i].getVector3fMap() = frame.points[i];
    }
  }
  cloud->is_dense = false;
  return cloud;
}

std::vector<pcl::PointIndices> findPlanes(const Frame& frame, const Normals& normals, const MpsConfig& config) {
  pcl::PointCloud<pcl::Normal>::Ptr given(new pcl::PointCloud<pcl::Normal>(frame.width(), frame.height()));
  for (int i = 0; i < frame.size(); ++i) given->points[i].getNormalVector3fMap() = normals.normal[i];
  pcl::OrganizedMultiPlaneSegmentation<pcl::PointXYZ, pcl::Normal, pcl::Label> planes;
  planes.setInputCloud(toCloud(frame));
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

  // Points that are not to be clustered are taken out of the cloud. The comparator's own exclude labels mean opposite
  // things in different versions of PCL.
  using Comparator = pcl::EuclideanClusterComparator<pcl::PointXYZ, pcl::Label>;
  const Cloud::Ptr cloud = toCloud(frame, mask);
  const Comparator::Ptr comparator(new Comparator());
  comparator->setInputCloud(cloud);
  comparator->setDistanceThreshold(static_cast<float>(config.cluster_distance_m), config.depth_dependent);
  pcl::OrganizedConnectedComponentSegmentation<pcl::PointXYZ, pcl::Label> components(comparator);
  components.setInputCloud(cloud);
  pcl::PointCloud<pcl::Label> found;
  std::vector<pcl::PointIndices> indices;
  components.segment(found, indices);

  std::vector<int> labels(frame.size(), 0);
  for (std::size_t k = 0; k < indices.size(); ++k) {
    for (const int i : indices[k].indices) labels[i] = static_cast<int>(k) + 1;
  }
  return labels;
}

}  // namespace objectness
