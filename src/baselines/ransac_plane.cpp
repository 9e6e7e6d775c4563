// SPDX-License-Identifier: BSD-3-Clause
#include "baselines/ransac_plane.hpp"

#include <pcl/ModelCoefficients.h>
#include <pcl/PointIndices.h>
#include <pcl/filters/passthrough.h>
#include <pcl/segmentation/sac_segmentation.h>

#include <limits>

#include "baselines/organized_cloud.hpp"

namespace objectness {
namespace {

constexpr std::size_t kMinPoints = 3;

/// n . p + d = 0, the normal towards the camera.
Plane facingCamera(const std::vector<float>& coefficients) {
  Plane plane{Eigen::Vector3f(coefficients.data()).cast<double>(), coefficients[3]};
  const double length = plane.normal.norm();
  plane.normal /= length, plane.d /= length;
  if (plane.d < 0) plane.normal = -plane.normal, plane.d = -plane.d;
  return plane;
}

ObjectPoints cut(const Frame& frame, const Plane& plane, const std::vector<int>& kept, const std::vector<int>& inliers,
                 bool above_only) {
  const cv::Size size(frame.width(), frame.height());
  ObjectPoints points;
  points.height_m = cv::Mat_<float>(size, std::numeric_limits<float>::quiet_NaN());
  points.mask = cv::Mat_<uchar>::zeros(size);
  points.on_table = cv::Mat_<uchar>::zeros(size);
  points.container = cv::Mat_<uchar>::zeros(size);
  for (int i = 0; i < frame.size(); ++i) {
    if (frame.points[i].allFinite()) points.height_m(i) = static_cast<float>(plane.height(frame.points[i]));
  }
  for (const int i : kept) points.mask(i) = !above_only || points.height_m(i) > 0 ? 255 : 0;
  for (const int i : inliers) points.on_table(i) = 255, points.mask(i) = 0;
  return points;
}

}  // namespace

Result<PlaneCut> cutByPlane(const Frame& frame, const RansacPlaneConfig& config) {
  const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud = organizedCloud(frame);
  pcl::PassThrough<pcl::PointXYZ> pass;
  pass.setInputCloud(cloud);
  pass.setFilterFieldName("z");
  pass.setFilterLimits(static_cast<float>(config.min_depth_m), static_cast<float>(config.max_depth_m));
  const pcl::PointIndices::Ptr kept(new pcl::PointIndices());
  pass.filter(kept->indices);

  pcl::ModelCoefficients coefficients;
  pcl::PointIndices inliers;
  if (kept->indices.size() >= kMinPoints) {
    pcl::SACSegmentation<pcl::PointXYZ> search;
    search.setModelType(pcl::SACMODEL_PLANE);
    search.setMethodType(pcl::SAC_RANSAC);
    search.setOptimizeCoefficients(true);
    search.setMaxIterations(config.max_iterations);
    search.setDistanceThreshold(config.plane_distance_m);
    search.setInputCloud(cloud);
    search.setIndices(kept);
    search.segment(inliers, coefficients);
  }
  if (inliers.indices.empty()) {
    return Result<PlaneCut>::error(StatusCode::kNoTable, "RANSAC finds no plane in the points that pass by depth");
  }
  const Plane plane = facingCamera(coefficients.values);
  return {{}, {plane, cut(frame, plane, kept->indices, inliers.indices, config.above_only)}};
}

}  // namespace objectness
