// SPDX-License-Identifier: BSD-3-Clause
#include "scene/organize.hpp"

#include <limits>

#include "scene/view_check.hpp"

namespace objectness {

Result<Frame> organize(const RawCloud& cloud, const PinholeCamera& camera) {
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
