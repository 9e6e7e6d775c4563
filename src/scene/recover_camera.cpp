// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include "objectness_segmentation/scene/frame.hpp"

namespace objectness {
namespace {

constexpr int kMinPoints = 20;
constexpr double kMaxMedianResidualPx = 0.5;

/// Least squares of pixel = focal * tangent + centre along one image axis.
class AxisFit {
 public:
  void add(double tangent, double pixel) {
    ++n_;
    sum_t_ += tangent, sum_p_ += pixel, sum_tt_ += tangent * tangent, sum_tp_ += tangent * pixel;
  }
  /// False when all tangents agree, as in a cloud of one column.
  bool solve(double& focal, double& centre) const {
    const double determinant = n_ * sum_tt_ - sum_t_ * sum_t_;
    if (!(determinant > 1e-12 * n_ * n_)) return false;
    focal = (n_ * sum_tp_ - sum_t_ * sum_p_) / determinant;
    centre = (sum_p_ - focal * sum_t_) / n_;
    return true;
  }

 private:
  double n_ = 0, sum_t_ = 0, sum_p_ = 0, sum_tt_ = 0, sum_tp_ = 0;
};

bool usable(const Eigen::Vector3f& p) { return p.allFinite() && p.z() > 0; }

}  // namespace

Result<PinholeCamera> recoverCamera(const RawCloud& cloud) {
  const auto fail = [](const std::string& why) {
    return Result<PinholeCamera>::error(StatusCode::kBadCamera,
                                        why + "; give the camera that took it (--camera CAMERA.yaml)");
  };
  AxisFit fit_x, fit_y;
  int count = 0;
  for (int v = 0, i = 0; v < cloud.height; ++v) {
    for (int u = 0; u < cloud.width; ++u, ++i) {
      const Eigen::Vector3f& p = cloud.points[i];
      if (!usable(p)) continue;
      fit_x.add(p.x() / double(p.z()), u);
      fit_y.add(p.y() / double(p.z()), v);
      ++count;
    }
  }
  if (count < kMinPoints) {
    return fail("cannot recover the camera from a cloud of " + std::to_string(count) + " valid points");
  }

  PinholeCamera camera;
  camera.width = cloud.width, camera.height = cloud.height;
  if (!fit_x.solve(camera.fx, camera.cx) || !fit_y.solve(camera.fy, camera.cy)) {
    return fail("cannot recover the camera: all valid points lie in one row or column");
  }
  std::vector<float> residuals;
  residuals.reserve(count);
  for (int v = 0, i = 0; v < cloud.height; ++v) {
    for (int u = 0; u < cloud.width; ++u, ++i) {
      const Eigen::Vector3f& p = cloud.points[i];
      if (usable(p)) residuals.push_back((camera.project(p.cast<double>()) - Eigen::Vector2d(u, v)).norm());
    }
  }
  const auto median = residuals.begin() + residuals.size() / 2;
  std::nth_element(residuals.begin(), median, residuals.end());
  if (!(*median <= kMaxMedianResidualPx) || camera.fx <= 0 || camera.fy <= 0) {
    std::ostringstream why;
    why << "the cloud's grid is no pinhole view in the optical frame (x right, y down, z forward): the best camera has "
           "fx "
        << camera.fx << ", fy " << camera.fy << " and misses the median pixel by " << *median << " px";
    return fail(why.str());
  }
  const Status status = validate(camera);
  if (!status.ok()) return Result<PinholeCamera>::error(status);
  return {{}, camera};
}

}  // namespace objectness
