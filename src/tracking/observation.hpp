// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <unordered_map>

#include "objectness_segmentation/scene/frame.hpp"
#include "objectness_segmentation/tracking/tracker.hpp"

namespace objectness {

/// The depth image of one frame with the pose of its camera, to be looked up from the fixed frame.
struct PosedDepthImage {
  PinholeCamera camera;
  cv::Mat_<float> depth_m;  ///< NaN: nothing measured
  Eigen::Isometry3d T_camera_fixed = Eigen::Isometry3d::Identity();

  PosedDepthImage() = default;
  PosedDepthImage(const Frame& frame, const Eigen::Isometry3d& T_fixed_camera);
};

/// A surface as the cells of a lattice in the fixed frame that hold points of it.
class SurfaceCells {
 public:
  void add(const Eigen::Vector3d& p, int frame);
  /// Takes over the cells of a later look at the same thing; those not seen since `oldest` are forgotten.
  void merge(const SurfaceCells& newer, int oldest);
  /// Share of these cells that have one of the other surface in or next to them: cells are as wide as the error of the
  /// camera's pose and the depth may be.
  double shareWithin(const SurfaceCells& other) const;
  /// Share of the cells that the view looks through: what is measured there lies clearly behind them.
  double shareSeenThrough(const PosedDepthImage& view) const;

 private:
  std::unordered_map<std::uint64_t, int> last_seen_;  ///< frame number by cell
};

/// What a segment looks like to the tracker, in the fixed frame.
struct Observation {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d sorted_size_m = Eigen::Vector3d::Zero();
  double radius_m = 0;  ///< of the sphere about the centre that holds the box
  SurfaceCells surface;
};

Observation makeObservation(const Frame& frame, const Segment& segment, const Eigen::Isometry3d& T_fixed_camera,
                            int number);

/// How much speaks for one thing behind both.
struct Agreement {
  double gain = 0;     ///< what the assignment sums up; 0: they are not the same
  double quality = 0;  ///< 0 to 1
  bool moved = false;  ///< agrees by size and place, not by surface
};

/// in_place: both may be in the same place. Otherwise only motion explains the match: one has left its place, or the
/// place of the other was empty before.
Agreement agree(const Observation& before, const Observation& now, bool in_place, const TrackingConfig& config);

/// Whether the view shows that the thing is not where it was seen in another frame.
bool isElsewhere(const Observation& observation, const PosedDepthImage& view);

}  // namespace objectness
