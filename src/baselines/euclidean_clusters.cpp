// SPDX-License-Identifier: BSD-3-Clause
#include "baselines/euclidean_clusters.hpp"

#include <pcl/filters/voxel_grid.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/extract_clusters.h>

#include <array>
#include <map>

namespace objectness {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Voxel = std::array<int, 3>;

/// As pcl::VoxelGrid finds it.
Voxel voxelOf(const Eigen::Vector3f& p, float inverse_voxel) {
  const Eigen::Vector3i cell = (p.array() * inverse_voxel).floor().cast<int>();
  return {cell.x(), cell.y(), cell.z()};
}

Cloud::Ptr thinned(const Cloud::Ptr& points, float voxel_m) {
  Cloud::Ptr thin(new Cloud());
  pcl::VoxelGrid<pcl::PointXYZ> grid;
  grid.setInputCloud(points);
  grid.setLeafSize(voxel_m, voxel_m, voxel_m);
  grid.filter(*thin);
  return thin;
}

/// Of each point, 0 = none.
std::vector<int> cluster(const Cloud::Ptr& points, double distance_m) {
  std::vector<int> labels(points->size(), 0);
  pcl::search::KdTree<pcl::PointXYZ>::Ptr tree(new pcl::search::KdTree<pcl::PointXYZ>());
  tree->setInputCloud(points);
  pcl::EuclideanClusterExtraction<pcl::PointXYZ> extraction;
  extraction.setClusterTolerance(distance_m);
  extraction.setSearchMethod(tree);
  extraction.setInputCloud(points);
  std::vector<pcl::PointIndices> clusters;
  extraction.extract(clusters);
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    for (const int i : clusters[k].indices) labels[i] = static_cast<int>(k) + 1;
  }
  return labels;
}

/// The labels of the voxels, for the points that fell into them.
std::vector<int> labelsOfPoints(const Cloud& points, const Cloud& thin, const std::vector<int>& thin_labels,
                                float voxel_m) {
  const float inverse_voxel = 1 / voxel_m;
  std::map<Voxel, int> label_of;
  for (std::size_t i = 0; i < thin.size(); ++i) {
    label_of[voxelOf(thin.points[i].getVector3fMap(), inverse_voxel)] = thin_labels[i];
  }
  std::vector<int> labels(points.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto found = label_of.find(voxelOf(points.points[i].getVector3fMap(), inverse_voxel));
    if (found != label_of.end()) labels[i] = found->second;  // a mean may be rounded out of its voxel
  }
  return labels;
}

}  // namespace

std::vector<int> labelEuclideanClusters(const Frame& frame, const cv::Mat_<uchar>& mask,
                                        const EuclideanConfig& config) {
  std::vector<int> labels(frame.size(), 0);
  Cloud::Ptr points(new Cloud());
  std::vector<int> pixels;
  for (int i = 0; i < frame.size(); ++i) {
    if (!mask(i / frame.width(), i % frame.width())) continue;
    pixels.push_back(i);
    points->push_back(pcl::PointXYZ(frame.points[i].x(), frame.points[i].y(), frame.points[i].z()));
  }
  if (pixels.empty()) return labels;
  std::vector<int> of_points;
  if (config.voxel_m > 0) {
    const float voxel_m = static_cast<float>(config.voxel_m);
    const Cloud::Ptr thin = thinned(points, voxel_m);
    of_points = labelsOfPoints(*points, *thin, cluster(thin, config.cluster_distance_m), voxel_m);
  } else {
    of_points = cluster(points, config.cluster_distance_m);
  }
  for (std::size_t i = 0; i < pixels.size(); ++i) labels[pixels[i]] = of_points[i];
  return labels;
}

}  // namespace objectness
