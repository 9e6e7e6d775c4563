// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/observation.hpp"

#include <algorithm>
#include <cmath>

#include "selection/cell_key.hpp"

namespace objectness {
namespace {

constexpr double kCellM = 0.015;
constexpr double kBehindM = 0.03;
constexpr double kElsewhereShare = 0.25;
constexpr std::size_t kMaxPoints = 3000;  // of a segment: enough to fill the cells of its surface

Eigen::Vector3d centreOf(std::uint64_t key) {
  const auto axis = [key](int shift) {
    return static_cast<double>(static_cast<std::int64_t>(key >> shift & 0x1FFFFF) - (1 << 20)) + 0.5;
  };
  return kCellM * Eigen::Vector3d(axis(42), axis(21), axis(0));
}

/// 1: boxes of the same size, whichever way they are turned.
double similarity(const Observation& a, const Observation& b) {
  const Eigen::Array3d smaller = a.sorted_size_m.array().min(b.sorted_size_m.array());
  const Eigen::Array3d larger = a.sorted_size_m.array().max(b.sorted_size_m.array()).max(1e-6);
  return std::cbrt((smaller / larger).prod());
}

}  // namespace

PosedDepthImage::PosedDepthImage(const Frame& frame, const Eigen::Isometry3d& T_fixed_camera)
    : camera(frame.camera), depth_m(frame.height(), frame.width()), T_camera_fixed(T_fixed_camera.inverse()) {
  std::transform(frame.points.begin(), frame.points.end(), depth_m.begin(), [](const auto& p) { return p.z(); });
}

void SurfaceCells::add(const Eigen::Vector3d& p, int frame) { last_seen_[keyOf(cellOf(p, kCellM))] = frame; }

void SurfaceCells::merge(const SurfaceCells& newer, int oldest) {
  for (const auto& [key, frame] : newer.last_seen_) last_seen_[key] = frame;
  for (auto cell = last_seen_.begin(); cell != last_seen_.end();) {
    cell = cell->second < oldest ? last_seen_.erase(cell) : std::next(cell);
  }
}

double SurfaceCells::shareWithin(const SurfaceCells& other) const {
  if (last_seen_.empty()) return 0;
  // Keys are 21 bits an axis: a step along an axis is a difference of keys.
  constexpr std::int64_t kSteps[] = {-1, 0, 1};
  std::size_t within = 0;
  for (const auto& cell : last_seen_) {
    const auto key = static_cast<std::int64_t>(cell.first);
    bool found = false;
    for (const std::int64_t x : kSteps) {
      for (const std::int64_t y : kSteps) {
        for (const std::int64_t z : kSteps) {
          found = found || other.last_seen_.count(static_cast<std::uint64_t>(key + x * (std::int64_t{1} << 42) +
                                                                             y * (std::int64_t{1} << 21) + z)) > 0;
        }
      }
    }
    within += found;
  }
  return static_cast<double>(within) / static_cast<double>(last_seen_.size());
}

double SurfaceCells::shareSeenThrough(const PosedDepthImage& view) const {
  constexpr double kReach[][2] = {{0, 0}, {-1, 0}, {1, 0}, {0, -1}, {0, 1}};
  std::size_t through = 0;
  for (const auto& cell : last_seen_) {
    const Eigen::Vector3d p = view.T_camera_fixed * centreOf(cell.first);
    if (p.z() <= kCellM) continue;
    const Eigen::Vector2d pixel = view.camera.project(p);
    const double reach_px = 0.5 * kCellM * view.camera.focal() / p.z();
    through += std::all_of(std::begin(kReach), std::end(kReach), [&](const double* step) {
      const double u = std::round(pixel.x() + step[0] * reach_px), v = std::round(pixel.y() + step[1] * reach_px);
      if (!(u >= 0 && v >= 0 && u < view.camera.width && v < view.camera.height)) return false;
      // False for NaN: nothing was measured.
      return view.depth_m(static_cast<int>(v), static_cast<int>(u)) > p.z() + kBehindM;
    });
  }
  return static_cast<double>(through) / std::max<std::size_t>(1, last_seen_.size());
}

Observation makeObservation(const Frame& frame, const Segment& segment, const Eigen::Isometry3d& T_fixed_camera,
                            int number) {
  Observation observation;
  observation.centre = T_fixed_camera * segment.box.T_camera_box.translation();
  observation.sorted_size_m = segment.box.size_m;
  std::sort(observation.sorted_size_m.data(), observation.sorted_size_m.data() + 3);
  observation.radius_m = 0.5 * segment.box.size_m.norm();
  const std::size_t step = 1 + segment.pixels.size() / kMaxPoints;
  for (std::size_t i = 0; i < segment.pixels.size(); i += step) {
    observation.surface.add(T_fixed_camera * frame.points[segment.pixels[i]].cast<double>(), number);
  }
  return observation;
}

bool isElsewhere(const Observation& observation, const PosedDepthImage& view) {
  return observation.surface.shareSeenThrough(view) > kElsewhereShare;
}

Agreement agree(const Observation& before, const Observation& now, bool in_place, const TrackingConfig& config) {
  const double distance = (before.centre - now.centre).norm();
  const double closeness = config.max_move_m > 0 ? std::max(0.0, 1 - distance / config.max_move_m) : 0;
  const double similar = similarity(before, now);
  if (in_place && distance < before.radius_m + now.radius_m + kCellM) {
    // The larger share: of a thing half hidden now or before, what is seen is all within its surface.
    const double now_within = now.surface.shareWithin(before.surface);
    const double before_within = before.surface.shareWithin(now.surface);
    const double overlap = std::max(now_within, before_within);
    if (overlap >= config.min_overlap) {
      return {0.25 + 0.5 * (now_within + before_within + similar) + 0.25 * closeness, overlap, false};
    }
  }
  if (closeness <= 0 || similar < config.min_similarity) return {};
  // Size before place: of two things that changed places each is still itself.
  const double distinct = (similar - config.min_similarity) / std::max(1e-9, 1 - config.min_similarity);
  return {0.25 + 0.5 * distinct + 0.25 * closeness, 0.5 * similar * (1 + closeness) / 2, true};
}

}  // namespace objectness
