// SPDX-License-Identifier: BSD-3-Clause
#include "sim/depth_sensor.hpp"

#include <algorithm>
#include <cmath>

#include "common/angles.hpp"
#include "common/parallel.hpp"
#include "sim/random.hpp"
#include "sim/stereo_matching.hpp"
#include "sim/time_of_flight.hpp"

namespace objectness::sim {
namespace {

using Eigen::Vector3d;

constexpr int kAxialWindow_px = 3, kLateralWindow_px = 9, kLossWindow_px = 3;
constexpr int kStereoWindow_px = 5, kWaveWindow_px = 25;
// The formulas of [N] have a pole at 90 deg.
constexpr double kSteepest_rad = 85 * kPi / 180;
// A surface is extended to a neighbour's ray only as far as this share of its depth.
constexpr double kMostExtension = 0.1;

/// theta / (pi / 2 - theta), which both deviations of [N] grow with.
double steepness(double theta) {
  const double limited = std::min(theta, kSteepest_rad);
  return limited / (kPi / 2 - limited);
}

/// Adds `window` numbers that follow each other, from every place on: count sums of numbers `stride` apart.
void addWindows(const double* from, int window, int count, std::size_t stride, double* sums) {
  double sum = 0;
  for (int i = 0; i < count + window - 1; ++i) {
    sum += from[i * stride];
    if (i >= window) sum -= from[(i - window) * stride];
    if (i >= window - 1) sums[(i - window + 1) * stride] = sum;
  }
}

/// Noise of unit deviation, the mean over a window of that side up to scale. Each `kind` is independent of the others.
cv::Mat_<double> smoothNoise(cv::Size size, int window, std::uint32_t seed, std::uint32_t kind) {
  Random random({seed, kind});
  cv::Mat_<double> noise(size.height + window - 1, size.width + window - 1);
  for (double& value : noise) value = random.gaussian();
  std::vector<double> sums(noise.total());
  for (int v = 0; v < noise.rows; ++v) addWindows(noise[v], window, size.width, 1, &sums[v * noise.step1()]);
  for (int u = 0; u < size.width; ++u) addWindows(&sums[u], window, size.height, noise.step1(), noise[0] + u);
  return noise(cv::Rect({0, 0}, size)) / window;  // window^2 numbers added have a deviation of window
}

/// Angle between a pixel's ray and its surface's normal.
double incidence(const SurfacePixel& pixel, const Vector3d& ray) {
  return pixel.body ? std::acos(std::clamp(-pixel.normal.dot(ray.normalized()), 0.0, 1.0)) : 0;
}

/// Whole pixels that an edge moves by; rounding them adds 1/12 to the variance, which is taken off before.
int lateralShift(double theta, double noise) {
  const double sigma = DepthSensor::lateralSigma(theta);
  return static_cast<int>(std::lround(std::sqrt(sigma * sigma - 1.0 / 12) * noise));
}

/// Depth of the plane through a pixel's surface where another ray meets it: moving sideways on a slope is no noise
/// along the ray, which has its own formula.
double extended(const SurfacePixel& pixel, const Vector3d& its_ray, const Vector3d& ray) {
  const double depth = pixel.depth_m * pixel.normal.dot(its_ray) / pixel.normal.dot(ray);
  return std::abs(depth - pixel.depth_m) < kMostExtension * pixel.depth_m ? depth : pixel.depth_m;
}

/// The measured depth of a surface at z, 0 when there is none.
double measure(const DepthSensor& sensor, double z, double theta, double axial, double loss) {
  const double start = sensor.grazing_start_deg * kPi / 180, end = sensor.grazing_end_deg * kPi / 180;
  const double lost_share = std::clamp((theta - start) / (end - start), 0.0, 1.0);
  if (std::erfc(-loss / std::sqrt(2)) / 2 < lost_share) return 0;  // the share of Gaussian noise below `loss`
  // [N] measured sensors that round: what is added before rounding is less by the share of the rounding.
  const double sigma = sensor.axialSigma(z, theta);
  if (sensor.kind == SensorKind::kTimeOfFlight) {
    const double noisy = z + sigma * axial;
    return noisy >= sensor.min_depth_m && noisy <= sensor.max_depth_m ? noisy : 0;
  }
  const double step = sensor.depthStep(z);
  const double noisy = z + std::sqrt(std::max(0.0, sigma * sigma - step * step / 12)) * axial;
  const double per_depth = sensor.camera.fx * sensor.baseline_m / sensor.disparity_step_px;  // steps at 1 m
  const double stepped = per_depth / std::round(per_depth / noisy);
  return stepped >= sensor.min_depth_m && stepped <= sensor.max_depth_m ? stepped : 0;
}

constexpr double kMaxDepth_mm = 65535;

}  // namespace

DepthSensor DepthSensor::stereo(const PinholeCamera& camera) {
  DepthSensor sensor;
  sensor.kind = SensorKind::kStereo;
  sensor.camera = camera;
  sensor.baseline_m = 0.05;
  sensor.disparity_step_px = 1.0 / 32;
  sensor.min_depth_m = 0.2;
  sensor.max_depth_m = 6;
  return sensor;
}

DepthSensor DepthSensor::timeOfFlight(const PinholeCamera& camera) {
  DepthSensor sensor;
  sensor.kind = SensorKind::kTimeOfFlight;
  sensor.camera = camera;
  sensor.baseline_m = 0;
  sensor.min_depth_m = 0.5;
  sensor.max_depth_m = 3.86;
  return sensor;
}

double DepthSensor::axialSigma(double z, double theta) const {
  if (kind == SensorKind::kTimeOfFlight) return tof_sigma_m * z / std::sqrt(std::cos(std::min(theta, kSteepest_rad)));
  if (kind == SensorKind::kStereo) return z * z / (camera.fx * baseline_m) * subpixel_px;
  const double steep = steepness(theta);
  return 0.0012 + 0.0019 * (z - 0.4) * (z - 0.4) + 0.0001 / std::sqrt(z) * steep * steep;
}

double DepthSensor::lateralSigma(double theta) { return 0.8 + 0.035 * steepness(theta); }

SceneImages takePicture(const SurfaceView& view, const DepthSensor& sensor, std::uint32_t seed, int threads) {
  const PinholeCamera& camera = view.camera;
  const cv::Size size(camera.width, camera.height);
  SceneImages picture{camera, cv::Mat_<ushort>(size, ushort{0}), view.color, cv::Mat_<ushort>(size, ushort{0})};
  const bool stereo = sensor.kind == SensorKind::kStereo && !sensor.ideal;
  const bool phases = sensor.kind == SensorKind::kTimeOfFlight && !sensor.ideal;
  const int windows_px[] = {stereo ? kStereoWindow_px : kAxialWindow_px, kLateralWindow_px, kLateralWindow_px,
                            kLossWindow_px, kWaveWindow_px};
  cv::Mat_<double> noise[5], matched;
  if (!sensor.ideal) {
    parallelFor(stereo ? 5 : 4, threads,
                [&](int kind) { noise[kind] = smoothNoise(size, windows_px[kind], seed, kind); });
  }
  if (stereo) {
    noise[0] = (noise[0] + noise[4]) * std::sqrt(0.5);
    matched = matchedDepths(view, sensor, threads);
  }
  if (phases) matched = timeOfFlightDepths(view, sensor, threads);
  const cv::Mat_<double>&axial = noise[0], &right = noise[1], &down = noise[2], &loss = noise[3];
  parallelFor(size.height, threads, [&](int v) {
    for (int u = 0; u < size.width; ++u) {
      const Vector3d ray = camera.ray(u, v);
      int from_u = u, from_v = v;
      if (!sensor.ideal && !phases) {
        const double theta = incidence(view.at(v, u), ray);
        from_u = std::clamp(u + lateralShift(theta, right(v, u)), 0, size.width - 1);
        from_v = std::clamp(v + lateralShift(theta, down(v, u)), 0, size.height - 1);
      }
      const SurfacePixel& from = view.at(from_v, from_u);
      if (!from.body || !from.lit) continue;
      double depth_m = from.depth_m;
      if (!sensor.ideal) {
        const Vector3d its_ray = camera.ray(from_u, from_v);
        const double blended = stereo || phases ? matched(from_v, from_u) - from.depth_m : 0;
        depth_m =
            measure(sensor, extended(from, its_ray, ray) + blended, incidence(from, its_ray), axial(v, u), loss(v, u));
      }
      const double depth_mm = std::round(depth_m * 1000);
      if (!(depth_mm >= 1 && depth_mm <= kMaxDepth_mm)) continue;
      picture.depth_mm(v, u) = static_cast<ushort>(depth_mm);
      picture.true_labels(v, u) = from.body->label;
    }
  });
  return picture;
}

SurfaceView viewSurfaces(const std::vector<Body>& bodies, const Eigen::Isometry3d& T_world_camera,
                         const DepthSensor& sensor) {
  std::optional<Vector3d> projector;
  if (!sensor.ideal && sensor.baseline_m > 0) projector = Vector3d(sensor.baseline_m, 0, 0);
  return viewSurfaces(bodies, T_world_camera, sensor.camera, projector);
}

SceneImages takePicture(const std::vector<Body>& bodies, const Eigen::Isometry3d& T_world_camera,
                        const DepthSensor& sensor, std::uint32_t seed) {
  return takePicture(viewSurfaces(bodies, T_world_camera, sensor), sensor, seed);
}

}  // namespace objectness::sim
