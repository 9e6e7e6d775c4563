// SPDX-License-Identifier: BSD-3-Clause
#include "scene/normals_pcl.hpp"

#include <pcl/features/integral_image_normal.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <limits>

namespace objectness {
namespace {

constexpr float kSmoothingSizePx = 10.0f;
constexpr float kMaxDepthChangeFactor = 0.01f;
constexpr int kSmallestSidePx = 3;  // PCL reads beyond smaller images

}  // namespace

void replaceByPclNormals(const Frame& frame, Normals& normals) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  pcl::PointCloud<pcl::Normal> estimated;
  if (frame.width() >= kSmallestSidePx && frame.height() >= kSmallestSidePx) {
    pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>(frame.width(), frame.height()));
    for (int i = 0; i < frame.size(); ++i) cloud->points[i].getVector3fMap() = frame.points[i];
    cloud->is_dense = false;
    pcl::IntegralImageNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
    estimation.setNormalEstimationMethod(estimation.COVARIANCE_MATRIX);
    estimation.setMaxDepthChangeFactor(kMaxDepthChangeFactor);
    estimation.setNormalSmoothingSize(kSmoothingSizePx);
    estimation.setInputCloud(cloud);
    estimation.compute(estimated);
  }
  for (std::size_t i = 0; i < normals.normal.size(); ++i) {
    if (normals.radius_px[i] == 0) continue;
    if (i < estimated.size() && estimated.points[i].getNormalVector3fMap().allFinite()) {
      normals.normal[i] = estimated.points[i].getNormalVector3fMap();
      if (normals.normal[i].dot(frame.points[i]) > 0) normals.normal[i] *= -1;
    } else {
      normals.normal[i].setConstant(nan);
      normals.residual_m[i] = normals.depth_m[i] = nan;
      normals.radius_px[i] = 0;
    }
  }
}

}  // namespace objectness
