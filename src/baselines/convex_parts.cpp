// SPDX-License-Identifier: BSD-3-Clause
#include "baselines/convex_parts.hpp"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/cpc_segmentation.h>
#include <pcl/segmentation/lccp_segmentation.h>
#include <pcl/segmentation/supervoxel_clustering.h>

#include <cstdint>
#include <map>

namespace objectness {
namespace {

using Point = pcl::PointXYZRGBA;

/// The points above the table as a list, with the pixel of each.
struct ObjectCloud {
  pcl::PointCloud<Point>::Ptr points{new pcl::PointCloud<Point>()};
  pcl::PointCloud<pcl::Normal>::Ptr normals{new pcl::PointCloud<pcl::Normal>()};
  std::vector<int> pixels;
};

ObjectCloud collectPoints(const Frame& frame, const Normals& normals, const cv::Mat_<uchar>& mask, bool with_normal) {
  ObjectCloud cloud;
  for (int i = 0; i < frame.size(); ++i) {
    const int v = i / frame.width(), u = i % frame.width();
    if (!mask(v, u) || !frame.points[i].allFinite()) continue;
    if (with_normal && !normals.normal[i].allFinite()) continue;
    Point point;
    point.getVector3fMap() = frame.points[i];
    const cv::Vec3b bgr = frame.color.empty() ? cv::Vec3b(128, 128, 128) : frame.color(v, u);
    point.b = bgr[0], point.g = bgr[1], point.r = bgr[2], point.a = 255;
    cloud.points->push_back(point);
    pcl::Normal normal;
    normal.getNormalVector3fMap() = normals.normal[i];
    normal.curvature = 0;
    cloud.normals->push_back(normal);
    cloud.pixels.push_back(i);
  }
  return cloud;
}

/// Supervoxels, given to `segmenter`; its labels brought back to the pixels. A template, since PCL's segment() is not
/// virtual: by its base a CPCSegmentation would not cut.
template <class Segmenter>
std::vector<int> labelBy(Segmenter& segmenter, const Frame& frame, const Normals& normals,
                         const cv::Mat_<uchar>& object_mask, const LccpConfig& config) {
  std::vector<int> labels(frame.size(), 0);
  const ObjectCloud cloud = collectPoints(frame, normals, object_mask, config.own_normals);
  if (cloud.pixels.empty()) return labels;

  const float voxel_m = static_cast<float>(config.voxel_m), seed_m = static_cast<float>(config.seed_m);
  pcl::SupervoxelClustering<Point> clustering(voxel_m, seed_m);
  clustering.setUseSingleCameraTransform(config.single_camera_transform);
  clustering.setInputCloud(cloud.points);
  if (config.own_normals) clustering.setNormalCloud(cloud.normals);
  clustering.setColorImportance(static_cast<float>(config.color_importance));
  clustering.setSpatialImportance(static_cast<float>(config.spatial_importance));
  clustering.setNormalImportance(static_cast<float>(config.normal_importance));
  std::map<std::uint32_t, pcl::Supervoxel<Point>::Ptr> supervoxels;
  clustering.extract(supervoxels);
  if (supervoxels.empty()) return labels;
  std::multimap<std::uint32_t, std::uint32_t> adjacency;
  clustering.getSupervoxelAdjacency(adjacency);

  segmenter.setConcavityToleranceThreshold(static_cast<float>(config.concavity_deg));
  segmenter.setSmoothnessCheck(config.smoothness_check, voxel_m, seed_m, static_cast<float>(config.smoothness));
  segmenter.setSanityCheck(config.sanity_check);
  segmenter.setKFactor(static_cast<unsigned>(config.k_convexity));
  segmenter.setMinSegmentSize(static_cast<unsigned>(config.min_segment_supervoxels));
  segmenter.setInputSupervoxels(supervoxels, adjacency);
  segmenter.segment();

  const pcl::PointCloud<pcl::PointXYZL>::Ptr labeled = clustering.getLabeledCloud();
  segmenter.relabelCloud(*labeled);
  for (std::size_t i = 0; i < cloud.pixels.size(); ++i) {
    labels[cloud.pixels[i]] = static_cast<int>(labeled->points[i].label);
  }
  return labels;
}

}  // namespace

std::vector<int> labelLccp(const Frame& frame, const Normals& normals, const cv::Mat_<uchar>& object_mask,
                           const LccpConfig& config) {
  pcl::LCCPSegmentation<Point> lccp;
  return labelBy(lccp, frame, normals, object_mask, config);
}

std::vector<int> labelCpc(const Frame& frame, const Normals& normals, const cv::Mat_<uchar>& object_mask,
                          const CpcConfig& config) {
  pcl::CPCSegmentation<Point> cpc;
  cpc.setCutting(static_cast<unsigned>(config.max_cuts), static_cast<unsigned>(config.min_borders_for_cutting),
                 static_cast<float>(config.min_cut_score), config.local_constraints, config.directed_weights,
                 config.clean_cuts);
  cpc.setRANSACIterations(static_cast<unsigned>(config.ransac_iterations));
  return labelBy(cpc, frame, normals, object_mask, config.lccp);
}

}  // namespace objectness
