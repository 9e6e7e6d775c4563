// SPDX-License-Identifier: BSD-3-Clause
#include "sim/time_of_flight.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "common/angles.hpp"
#include "common/parallel.hpp"

namespace objectness::sim {
namespace {

using Eigen::Vector3d;

constexpr double kLight_m_s = 299792458;
constexpr int kSpread_px = 1;                         // of the lens, to each side: 3 x 3, binomial
constexpr double kLeastAgreement = 0.5;               // of the light of a pixel, 0 to 1; with less it has no depth
constexpr int kBounce_px = 24, kBounceStride_px = 4;  // other surfaces are looked for so far, on every such pixel
constexpr double kAlbedo = 0.6;                       // of a surface that passes light on

/// A surface as the light finds it.
struct LitPoint {
  Vector3d p, normal;    ///< camera's optical frame
  double distance = 0;   ///< from the camera, along the ray; 0: nothing there
  double amplitude = 0;  ///< of the light that comes back directly: cos(theta) / distance^2
  double area_m2 = 0;    ///< that a pixel sees of it
};

LitPoint litPoint(const SurfaceView& view, int v, int u) {
  const SurfacePixel& pixel = view.at(v, u);
  if (!pixel.body || !(pixel.depth_m > 0)) return {};
  const Vector3d p = view.camera.ray(u, v) * pixel.depth_m;
  const double distance = p.norm(), cosine = std::max(0.05, -pixel.normal.dot(p) / distance);
  const double pixel_m = pixel.depth_m / view.camera.fx;
  return {p, pixel.normal, distance, cosine / (distance * distance), pixel_m * pixel_m / cosine};
}

/// The first row or column within reach of one that is a whole number of strides away.
int firstBounce(int of) { return of - std::min(of, kBounce_px) / kBounceStride_px * kBounceStride_px; }

/// The light that one pixel's surface sends back, as a phasor: by itself, and lit by its neighbours in the picture.
std::complex<double> lightOf(const std::vector<LitPoint>& points, const cv::Size& size, int v, int u, double per_m) {
  const LitPoint& own = points[std::size_t(v) * size.width + u];
  if (own.distance == 0) return 0;
  std::complex<double> light = std::polar(own.amplitude, per_m * own.distance);
  // Diffuse light of one bounce: camera, q, p, camera.
  for (int y = firstBounce(v); y <= std::min(size.height - 1, v + kBounce_px); y += kBounceStride_px) {
    for (int x = firstBounce(u); x <= std::min(size.width - 1, u + kBounce_px); x += kBounceStride_px) {
      const LitPoint& other = points[std::size_t(y) * size.width + x];
      if (other.distance == 0) continue;
      const Vector3d between = other.p - own.p;
      const double here = own.normal.dot(between), there = -other.normal.dot(between);
      if (here <= 0 || there <= 0) continue;  // they do not face each other
      const double squared = between.squaredNorm();
      const double form = here * there / (kPi * squared * squared);
      const double received = kAlbedo * other.amplitude * form * other.area_m2 * kBounceStride_px * kBounceStride_px;
      light += std::polar(received, per_m * (other.distance + std::sqrt(squared) + own.distance) / 2);
    }
  }
  return light;
}

}  // namespace

cv::Mat_<double> timeOfFlightDepths(const SurfaceView& view, const DepthSensor& sensor, int threads) {
  const PinholeCamera& camera = view.camera;
  const cv::Size size(camera.width, camera.height);
  const double per_m = 4 * kPi * sensor.modulation_hz / kLight_m_s;  // radians of phase a metre of distance
  std::vector<LitPoint> points(size.area());
  std::vector<std::complex<double>> light(size.area());
  parallelFor(size.height, threads, [&](int v) {
    for (int u = 0; u < size.width; ++u) points[std::size_t(v) * size.width + u] = litPoint(view, v, u);
  });
  parallelFor(size.height, threads, [&](int v) {
    for (int u = 0; u < size.width; ++u) light[std::size_t(v) * size.width + u] = lightOf(points, size, v, u, per_m);
  });
  cv::Mat_<double> depth(size, 0.0);
  parallelFor(size.height, threads, [&](int v) {
    for (int u = 0; u < size.width; ++u) {
      const LitPoint& own = points[std::size_t(v) * size.width + u];
      if (own.distance == 0) continue;
      std::complex<double> sum = 0;
      double all = 0;
      for (int y = std::max(0, v - kSpread_px); y <= std::min(size.height - 1, v + kSpread_px); ++y) {
        for (int x = std::max(0, u - kSpread_px); x <= std::min(size.width - 1, u + kSpread_px); ++x) {
          const std::size_t q = std::size_t(y) * size.width + x;
          const double weight = (y == v ? 2 : 1) * (x == u ? 2 : 1);
          // Calibrated: a neighbour at the same depth has the same phase, although its ray is longer or shorter.
          const double calibration_m =
              view.at(y, x).depth_m / view.at(v, u).depth_m * own.distance - points[q].distance;
          sum += weight * light[q] * std::polar(1.0, per_m * calibration_m);
          all += weight * std::abs(light[q]);
        }
      }
      if (std::abs(sum) < kLeastAgreement * all) continue;
      // The phase is known up to whole turns; a second frequency of the sensor tells which.
      const double own_phase = per_m * own.distance;
      const double distance = own.distance + std::arg(sum * std::polar(1.0, -own_phase)) / per_m;
      const double wave = sensor.wiggle_m * std::sin(4 * per_m * distance);
      depth(v, u) = view.at(v, u).depth_m * (distance + wave) / own.distance;
    }
  });
  return depth;
}

}  // namespace objectness::sim
