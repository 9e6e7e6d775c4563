// SPDX-License-Identifier: BSD-3-Clause
#include "organize.hpp"

#include <cmath>
#include <limits>
#include <sstream>

namespace objectness {
namespace {

// A view of the camera has its points on the rays of pixel centres. Points from elsewhere (merged, subsampled, another
// camera) are spread evenly over the pixels, and a disk of this radius holds only 79 % of a pixel.
constexpr double kOnPixelRadiusPx = 0.5;
constexpr double kMinShareOnPixels = 0.9;

/// Where the camera sees a point.
struct SeenAt {
  bool inside = false, on_pixel = false;
  int u = 0, v = 0;
};

SeenAt lookAt(const Eigen::Vector3f& p, const PinholeCamera& camera) {
  if (!p.allFinite() || p.z() <= 0) return {};
  const Eigen::Vector2d pixel = camera.project(p.cast<double>());
  const Eigen::Vector2d centre(std::round(pixel.x()), std::round(pixel.y()));
  if (!(centre.x() >= 0 && centre.y() >= 0 && centre.x() < camera.width && centre.y() < camera.height)) return {};
  return {true, (pixel - centre).norm() <= kOnPixelRadiusPx, static_cast<int>(centre.x()),
          static_cast<int>(centre.y())};
}

/// kNotOrganized or kNoValidPoints when the cloud is no view of the camera.
Status checkIsView(const RawCloud& cloud, const PinholeCamera& camera) {
  std::size_t finite = 0, on_pixel = 0;
  for (const Eigen::Vector3f& p : cloud.points) {
    finite += p.allFinite();
    on_pixel += lookAt(p, camera).on_pixel;
  }
  if (finite == 0) {
    return Status::error(StatusCode::kNoValidPoints,
                         "none of the cloud's " + std::to_string(cloud.points.size()) + " points is finite");
  }
  if (on_pixel >= kMinShareOnPixels * finite) return {};
  std::ostringstream why;
  why << "cloud is " << cloud.width << " x " << cloud.height << ", not organized, and only "
      << static_cast<int>(100.0 * on_pixel / finite) << " % of its points lie on pixels of the given camera ("
      << camera.width << " x " << camera.height << ", fx " << camera.fx << ", cx " << camera.cx << ", cy " << camera.cy
      << "): give the camera that took it";
  return Status::error(StatusCode::kNotOrganized, why.str());
}

}  // namespace

Result<Frame> organize(const RawCloud& cloud, const PinholeCamera& camera) {
  // First, as the memory that the camera asks for may be much more than the cloud's.
  const Status view = checkIsView(cloud, camera);
  if (!view.ok()) return Result<Frame>::error(view);
  Frame frame;
  frame.camera = camera;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  frame.points.assign(static_cast<std::size_t>(frame.size()), Eigen::Vector3f(nan, nan, nan));
  if (!cloud.colors.empty()) frame.color = cv::Mat_<cv::Vec3b>(camera.height, camera.width, cv::Vec3b(0, 0, 0));
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const Eigen::Vector3f& p = cloud.points[i];
    const SeenAt seen = lookAt(p, camera);
    if (!seen.inside) continue;
    Eigen::Vector3f& kept = frame.points[static_cast<std::size_t>(seen.v) * camera.width + seen.u];
    if (kept.z() <= p.z()) continue;  // false for NaN
    kept = p;
    if (!cloud.colors.empty()) frame.color(seen.v, seen.u) = cloud.colors[i];
  }
  return {{}, std::move(frame)};
}

}  // namespace objectness
