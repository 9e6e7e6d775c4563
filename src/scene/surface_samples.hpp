// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/scene/table.hpp"

namespace objectness {

/// Every stride-th pixel of a frame in both directions: enough to find planes in, whatever the image size.
struct SurfaceSamples {
  struct Sample {
    Eigen::Vector3f point;   ///< NaN = invalid
    Eigen::Vector3f normal;  ///< NaN = none
    float sigma_m = 0;       ///< depth noise at the point

    bool valid() const { return point.z() > 0; }
    bool hasNormal() const { return normal.x() == normal.x(); }
    /// How far from a plane its points may lie.
    float tolerance() const;
  };
  int width = 0, height = 0, stride = 1;
  std::vector<Sample> samples;  ///< width * height, row-major
};

/// At most about `count` samples of the frame.
SurfaceSamples sampleSurface(const Frame& frame, const Normals& normals, const DepthNoise& noise, int count);

/// n . p + d in single precision, for loops over many points.
struct FastPlane {
  explicit FastPlane(const Plane& plane) : normal(plane.normal.cast<float>()), d(static_cast<float>(plane.d)) {}
  float height(const Eigen::Vector3f& p) const { return normal.dot(p) + d; }

  Eigen::Vector3f normal;
  float d;
};

/// Weighted least-squares plane of points, oriented towards the camera.
class PlaneFitter {
 public:
  void add(const Eigen::Vector3f& point, double weight);
  int count() const { return count_; }
  /// False when the points do not span a plane.
  bool solve(Plane& plane) const;

 private:
  int count_ = 0;
  double weight_ = 0;
  Eigen::Vector3d sum_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d products_ = Eigen::Matrix3d::Zero();
};

}  // namespace objectness
