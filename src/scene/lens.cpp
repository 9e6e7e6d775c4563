// SPDX-License-Identifier: BSD-3-Clause
#include "scene/lens.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

namespace objectness {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
// Steps of the search for the angle where a lens model turns back.
constexpr int kRadiusSteps = 256;
// Samples of the view along each side.
constexpr int kViewSteps = 16;
// Neighbouring pixels whose depths differ by more are not of one surface.
constexpr float kMaxDepthRatio = 1.03F;

bool isFisheye(const LensDistortion& lens) { return lens.model == "equidistant" || lens.model == "fisheye"; }

/// Where the raw image shows the given rays, pixels.
std::vector<cv::Point2d> project(const std::vector<cv::Point3d>& rays, const PinholeCamera& camera,
                                 const LensDistortion& lens) {
  const cv::Matx33d intrinsics(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
  const cv::Vec3d zero(0, 0, 0);
  std::vector<cv::Point2d> pixels;
  if (isFisheye(lens)) {
    cv::fisheye::projectPoints(rays, pixels, zero, zero, intrinsics, lens.D);
  } else {
    cv::projectPoints(rays, zero, zero, intrinsics, lens.D, pixels);
  }
  return pixels;
}

cv::Point3d rayOf(const PinholeCamera& camera, double u, double v) {
  const Eigen::Vector3d ray = camera.ray(u, v);
  return {ray.x(), ray.y(), 1};
}

double radiusOf(const cv::Point3d& ray) { return std::hypot(ray.x, ray.y); }

double largestRadius(const PinholeCamera& camera) {
  double largest = 0;
  for (const double u : {0.0, camera.width - 1.0}) {
    for (const double v : {0.0, camera.height - 1.0}) largest = std::max(largest, radiusOf(rayOf(camera, u, v)));
  }
  return largest;
}

/// The distance of a ray from the axis (its tangent) from which on the model's image no longer moves outwards: beyond,
/// the polynomial says nothing about the lens.
double reachOf(const PinholeCamera& camera, const LensDistortion& lens) {
  const double largest = largestRadius(camera);
  std::vector<cv::Point3d> rays;
  for (int i = 0; i <= kRadiusSteps; ++i) rays.emplace_back(largest * i / kRadiusSteps, 0, 1);
  const std::vector<cv::Point2d> pixels = project(rays, camera, lens);
  for (int i = 1; i <= kRadiusSteps; ++i) {
    if (!(pixels[i].x > pixels[i - 1].x)) return rays[i - 1].x;
  }
  return std::numeric_limits<double>::infinity();
}

bool isDepth(float z) { return z > 0 && std::isfinite(z); }

/// The depth at a place between pixels. Inverse depth is linear on a plane: it is interpolated where the four pixels
/// around are of one surface. Elsewhere the nearest pixel counts.
float depthAt(const cv::Mat_<float>& depth, const cv::Point2f& at) {
  if (!(at.x >= 0 && at.y >= 0 && at.x <= depth.cols - 1 && at.y <= depth.rows - 1)) return 0;
  const int u = std::min(static_cast<int>(at.x), std::max(0, depth.cols - 2)),
            v = std::min(static_cast<int>(at.y), std::max(0, depth.rows - 2));
  const int u1 = std::min(u + 1, depth.cols - 1), v1 = std::min(v + 1, depth.rows - 1);
  const float corners[] = {depth(v, u), depth(v, u1), depth(v1, u), depth(v1, u1)};
  const auto [least, most] = std::minmax_element(std::begin(corners), std::end(corners));
  const bool all = std::all_of(std::begin(corners), std::end(corners), isDepth);
  if (!all || *most > kMaxDepthRatio * *least) {
    const float nearest = depth(static_cast<int>(std::lround(at.y)), static_cast<int>(std::lround(at.x)));
    return isDepth(nearest) ? nearest : 0;
  }
  const float x = at.x - static_cast<float>(u), y = at.y - static_cast<float>(v);
  return 1 / ((1 - y) * ((1 - x) / corners[0] + x / corners[1]) + y * ((1 - x) / corners[2] + x / corners[3]));
}

}  // namespace

Status validate(const LensDistortion& lens) {
  const auto bad = [](const std::string& message) { return Status::error(StatusCode::kBadCamera, message); };
  const bool polynomial = lens.model.empty() || lens.model == "plumb_bob" || lens.model == "rational_polynomial";
  if (!polynomial && !isFisheye(lens)) return bad("the distortion model '" + lens.model + "' is not known");
  const std::size_t count = lens.D.size();
  const bool count_fits =
      isFisheye(lens) ? count == 4 : count == 4 || count == 5 || count == 8 || count == 12 || count == 14;
  if (!count_fits) {
    return bad("the distortion model '" + lens.model + "' has " + std::to_string(count) + " coefficients, must be " +
               (isFisheye(lens) ? "4" : "4, 5, 8, 12 or 14"));
  }
  if (!std::all_of(lens.D.begin(), lens.D.end(), [](double value) { return std::isfinite(value); })) {
    return bad("a distortion coefficient is no finite number");
  }
  return {};
}

bool distorts(const LensDistortion& lens) {
  // A fisheye of zeros still is one.
  return isFisheye(lens) || std::any_of(lens.D.begin(), lens.D.end(), [](double value) { return value != 0; });
}

double largestShiftPx(const PinholeCamera& camera, const LensDistortion& lens) {
  const double reach = reachOf(camera, lens);
  std::vector<cv::Point3d> rays;
  std::vector<cv::Point2d> places;
  for (int i = 0; i <= kViewSteps; ++i) {
    for (int j = 0; j <= kViewSteps; ++j) {
      const cv::Point2d place((camera.width - 1.0) * j / kViewSteps, (camera.height - 1.0) * i / kViewSteps);
      const cv::Point3d ray = rayOf(camera, place.x, place.y);
      if (radiusOf(ray) >= reach) continue;
      rays.push_back(ray);
      places.push_back(place);
    }
  }
  if (rays.empty()) return 0;
  const std::vector<cv::Point2d> seen = project(rays, camera, lens);
  double largest = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) largest = std::max(largest, cv::norm(seen[i] - places[i]));
  return largest;
}

cv::Mat_<cv::Point2f> rawPixels(const PinholeCamera& camera, const LensDistortion& lens) {
  const double reach = reachOf(camera, lens);
  cv::Mat_<cv::Point2f> places(camera.height, camera.width, cv::Point2f(kNan, kNan));
  std::vector<cv::Point3d> rays(camera.width);
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) rays[u] = rayOf(camera, u, v);
    const std::vector<cv::Point2d> seen = project(rays, camera, lens);
    for (int u = 0; u < camera.width; ++u) {
      if (radiusOf(rays[u]) < reach) places(v, u) = cv::Point2f(seen[u]);
    }
  }
  return places;
}

cv::Mat_<float> rectifyDepth(const cv::Mat_<float>& raw, const cv::Mat_<cv::Point2f>& raw_pixels) {
  cv::Mat_<float> rectified(raw_pixels.size());
  for (int v = 0; v < rectified.rows; ++v) {
    for (int u = 0; u < rectified.cols; ++u) rectified(v, u) = depthAt(raw, raw_pixels(v, u));
  }
  return rectified;
}

cv::Mat rectifyColor(const cv::Mat& raw, const cv::Mat_<cv::Point2f>& raw_pixels) {
  cv::Mat_<cv::Point2f> places = raw_pixels.clone();
  const auto near = [](float place, int side) { return place > -1 && place < static_cast<float>(side); };
  for (cv::Point2f& place : places) {
    if (!near(place.x, raw.cols) || !near(place.y, raw.rows)) place = {-2, -2};
  }
  cv::Mat rectified;
  cv::remap(raw, rectified, places, cv::noArray(), cv::INTER_LINEAR);
  return rectified;
}

}  // namespace objectness
