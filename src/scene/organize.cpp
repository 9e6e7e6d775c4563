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

}  // namespace

Result<Frame> organize(const RawCloud& cloud, const PinholeCamera& camera) {
  Frame frame;
  frame.camera = camera;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  frame.points.assign(static_cast<std::size_t>(frame.size()), Eigen::Vector3f(nan, nan, nan));
  if (!cloud.colors.empty()) frame.color = cv::Mat_<cv::Vec3b>(camera.height, camera.width, cv::Vec3b(0, 0, 0));

  std::size_t finite = 0, on_pixel = 0;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const Eigen::Vector3f& p = cloud.points[i];
    if (!p.allFinite()) continue;
    ++finite;
    if (p.z() <= 0) continue;
    const Eigen::Vector2d pixel = camera.project(p.cast<double>());
    const Eigen::Vector2d centre(std::round(pixel.x()), std::round(pixel.y()));
    if (!(centre.x() >= 0 && centre.y() >= 0 && centre.x() < camera.width && centre.y() < camera.height)) continue;
    if ((pixel - centre).norm() <= kOnPixelRadiusPx) ++on_pixel;
    const std::size_t index =
        static_cast<std::size_t>(centre.y()) * camera.width + static_cast<std::size_t>(centre.x());
    Eigen::Vector3f& kept = frame.points[index];
    if (kept.z() <= p.z()) continue;  // false for NaN
    kept = p;
    if (!cloud.colors.empty())
      frame.color(static_cast<int>(centre.y()), static_cast<int>(centre.x())) = cloud.colors[i];
  }
  if (finite == 0) {
    return Result<Frame>::error(StatusCode::kNoValidPoints,
                                "none of the cloud's " + std::to_string(cloud.points.size()) + " points is finite");
  }
  if (on_pixel < kMinShareOnPixels * finite) {
    std::ostringstream why;
    why << "cloud is " << cloud.width << " x " << cloud.height << ", not organized, and only "
        << static_cast<int>(100.0 * on_pixel / finite) << " % of its points lie on pixels of the given camera ("
        << camera.width << " x " << camera.height << ", fx " << camera.fx << ", cx " << camera.cx << ", cy "
        << camera.cy << "): give the camera that took it";
    return Result<Frame>::error(StatusCode::kNotOrganized, why.str());
  }
  return {{}, std::move(frame)};
}

}  // namespace objectness
