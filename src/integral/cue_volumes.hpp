// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "integral/cue_voxels.hpp"
#include "integral/integral_volume.hpp"

namespace objectness {

/// The integral volume of one superpixel, on its own bounding box in x and y (SuperpixelVoxels).
class SuperpixelVolume {
 public:
  SuperpixelVolume() = default;
  explicit SuperpixelVolume(const SuperpixelVoxels& superpixel) { assign(superpixel); }
  void assign(const SuperpixelVoxels& superpixel) {
    x0_ = superpixel.x0, y0_ = superpixel.y0;
    volume_.assign(superpixel.voxels);
  }

  /// Voxels of the superpixel in the box (any box of the grid).
  int count(int x0, int x1, int y0, int y1, int height) const {
    x0 = std::max(x0 - x0_, 0), x1 = std::min(x1 - x0_, volume_.nx());
    y0 = std::max(y0 - y0_, 0), y1 = std::min(y1 - y0_, volume_.ny());
    return x0 < x1 && y0 < y1 ? volume_.count(x0, x1, y0, y1, height) : 0;
  }
  int total() const { return volume_.total(); }

  /// Its bounding box, half-open, in the grid.
  int left() const { return x0_; }
  int right() const { return x0_ + volume_.nx(); }
  int front() const { return y0_; }
  int back() const { return y0_ + volume_.ny(); }

  /// Sums at corner (x, y) of the grid, which must be within the bounding box; heights as in IntegralVolume.
  const std::uint16_t* column(int x, int y) const { return volume_.column(x - x0_, y - y0_); }
  const IntegralVolume& volume() const { return volume_; }

 private:
  int x0_ = 0, y0_ = 0;
  IntegralVolume volume_;
};

/// All integral volumes of one angle. Everything is counted in voxels: it makes near and far objects alike, and it is
/// the only unit in which Eq. 5 subtracts points from a volume.
struct CueVolumes {
  Grid grid;
  Eigen::Vector3d viewpoint = Eigen::Vector3d::Zero();  ///< the camera's centre, grid coordinates (voxels)
  IntegralVolume edges;                                 ///< an edge point of any kind inside, Sec. 3.1
  IntegralVolume occupied;                              ///< V: a point inside, Sec. 2.3
  IntegralVolume filled;                                ///< V or V_O: occupied or occluded
  std::vector<SuperpixelVolume> superpixels;            ///< one per label that has a voxel in the grid, Sec. 3.3
};

/// Sums up one angle's voxels into `volumes`, whose memory is kept. ring_z: how far over the grid boxes may reach
/// (b_eps of Eq. 2), voxels.
void integrate(const CueVoxels& voxels, const Table& table, int ring_z, CueVolumes& volumes);

}  // namespace objectness
