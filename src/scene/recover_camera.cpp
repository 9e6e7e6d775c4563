// SPDX-License-Identifier: BSD-3-Clause
#include "scene/recover_camera.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include "common/upper_median.hpp"
#include "scene/frame_axes.hpp"
#include "scene/moved_view.hpp"

namespace objectness {
namespace {

constexpr int kMinPoints = 20;
constexpr double kMaxMedianResidualPx = 0.5;
// A camera that is given need not fit better than this (checkCameraFits()): up to here giving it may help.
constexpr double kMaxGivenMismatchPx = 3.0;

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

/// The camera that fits the grid best once the points are turned.
struct GridFit {
  int points = 0;  ///< in front of the camera
  bool solved = false;
  PinholeCamera camera;
  double residual_px = 0;  ///< median

  bool good() const {
    return solved && residual_px <= kMaxMedianResidualPx && camera.fx > 0 && camera.fy > 0 && validate(camera).ok();
  }
};

GridFit fitGrid(const RawCloud& cloud, const Eigen::Matrix3f& rotation) {
  GridFit fit;
  AxisFit fit_x, fit_y;
  for (int v = 0, i = 0; v < cloud.height; ++v) {
    for (int u = 0; u < cloud.width; ++u, ++i) {
      const Eigen::Vector3f p = rotation * cloud.points[i];
      if (!usable(p)) continue;
      fit_x.add(p.x() / double(p.z()), u);
      fit_y.add(p.y() / double(p.z()), v);
      ++fit.points;
    }
  }
  PinholeCamera& camera = fit.camera;
  camera.width = cloud.width, camera.height = cloud.height;
  fit.solved = fit.points >= kMinPoints && fit_x.solve(camera.fx, camera.cx) && fit_y.solve(camera.fy, camera.cy);
  if (!fit.solved) return fit;
  std::vector<float> residuals;
  residuals.reserve(fit.points);
  for (int v = 0, i = 0; v < cloud.height; ++v) {
    for (int u = 0; u < cloud.width; ++u, ++i) {
      const Eigen::Vector3f p = rotation * cloud.points[i];
      if (usable(p)) residuals.push_back((camera.project(p.cast<double>()) - Eigen::Vector2d(u, v)).norm());
    }
  }
  fit.residual_px = upperMedian(residuals);
  return fit;
}

/// Why the optical frame's fit failed, and what would help.
std::string reasonFor(const RawCloud& cloud, const GridFit& fit) {
  const std::string other_frame = otherFrameOf(cloud);
  if (!other_frame.empty()) return other_frame;
  const std::string give_camera = "; give the camera that took it (--camera CAMERA.yaml)";
  if (fit.points < kMinPoints) {
    return "cannot recover the camera from a cloud of " + std::to_string(fit.points) +
           " valid points in front of it (z forward)" + give_camera;
  }
  if (!fit.solved) return "cannot recover the camera: all valid points lie in one row or column" + give_camera;
  std::ostringstream why;
  why << "the cloud's grid is no pinhole view in the optical frame (x right, y down, z forward), nor in any other: the "
         "best camera has fx "
      << fit.camera.fx << ", fy " << fit.camera.fy << " and misses the median pixel by " << fit.residual_px << " px";
  why << (fit.residual_px <= kMaxGivenMismatchPx ? give_camera : "; clouds of spinning or fisheye sensors are none");
  return why.str();
}

}  // namespace

std::string otherFrameOf(const RawCloud& cloud) {
  for (const FrameAxes& axes : otherAxes()) {
    if (fitGrid(cloud, axes.R_optical_cloud).good()) return notOptical(cloud, axes.name);
  }
  if (isMovedView(cloud)) return notOptical(cloud, "it was turned or moved, as into the frame of a world or a robot");
  return "";
}

Result<PinholeCamera> recoverCamera(const RawCloud& cloud) {
  const GridFit fit = fitGrid(cloud, Eigen::Matrix3f::Identity());
  const bool fits = fit.solved && fit.residual_px <= kMaxMedianResidualPx && fit.camera.fx > 0 && fit.camera.fy > 0;
  if (!fits) return Result<PinholeCamera>::error(StatusCode::kBadCamera, reasonFor(cloud, fit));
  const Status status = validate(fit.camera);
  if (!status.ok()) return Result<PinholeCamera>::error(status);
  return {{}, fit.camera};
}

}  // namespace objectness
