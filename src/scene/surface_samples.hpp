// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "objectness_segmentation/scene/table.hpp"
#include "scene/plane_sums.hpp"

namespace objectness {

/// Every stride-th pixel of a frame in both directions: enough to find planes in, whatever the image size.
struct SurfaceSamples {
  struct Sample {
    Eigen::Vector3f point;   ///< NaN = invalid
    Eigen::Vector3f normal;  ///< NaN = none
    float sigma_m = 0;       ///< depth noise at the point

    bool valid() const { return point.z() > 0; }
    bool hasNormal() const { return normal.x() == normal.x(); }
    /// How far from a plane its points may lie: three sigma, but no less than 6 mm.
    float tolerance() const { return std::max(0.006f, 3.0f * sigma_m); }
  };
  int width = 0, height = 0, stride = 1;
  std::vector<Sample> samples;  ///< width * height, row-major
};

/// At most about `count` samples of the frame.
SurfaceSamples sampleSurface(const Frame& frame, const Normals& normals, const DepthNoise& noise, int count,
                             int threads = 1);

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
  explicit PlaneFitter(const PlaneSums& sums = {}) : sums_(sums) {}
  void add(const Eigen::Vector3f& point, double weight) { sums_.add(point.x(), point.y(), point.z(), weight); }
  /// False when the points do not span a plane.
  bool solve(Plane& plane) const;

 private:
  PlaneSums sums_;
};

}  // namespace objectness
