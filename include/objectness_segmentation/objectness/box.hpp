// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <tuple>

namespace objectness {

/// A box of the sampling, b(x, y, s_x, s_y, s_z, r_z) of paper Sec. 2.1, in voxels of the grid of its angle. It stands
/// on the table: its base is z = 0. Faces are half-open: it holds the voxels x0 <= x < x1, y0 <= y < y1, 0 <= z <
/// height.
struct Box {
  int angle = 0;  ///< index of r_z
  int x0 = 0, x1 = 0, y0 = 0, y1 = 0;
  int height = 0;

  int sizeX() const { return x1 - x0; }
  int sizeY() const { return y1 - y0; }
  long volume() const { return static_cast<long>(sizeX()) * sizeY() * height; }

  /// The order of enumeration: what ties in objectness are broken by.
  auto key() const { return std::make_tuple(angle, x0, y0, x1, y1, height); }
  friend bool operator==(const Box& a, const Box& b) { return a.key() == b.key(); }
};

/// The cues of one box, paper Eq. 1, 2, 4 and 5. What those of a segment of the default method are: see Segment.
struct CueValues {
  float edge_density = 0;  ///< delta_i, Eq. 1, clipped at max_edge_density
  float outer_edges = 0;   ///< delta_o, Eq. 2
  float straddling = 0;    ///< delta_l, Eq. 4
  float free_space = 0;    ///< delta_f, Eq. 5
  int free_voxels = 0;     ///< numerator of Eq. 5
};

struct ScoredBox {
  Box box;
  CueValues cues;
  float objectness = 0;  ///< delta, Eq. 6
};

/// Best objectness first, ties in the order of enumeration: the order of every list of boxes.
inline bool better(const ScoredBox& a, const ScoredBox& b) {
  return a.objectness != b.objectness ? a.objectness > b.objectness : a.box.key() < b.box.key();
}

/// A box in the world: centre and axes in the camera's optical frame. z points away from the table: along its normal
/// (boxes of the sampling), or, where boxes may be tilted, it is the axis nearest to the normal (tightBox()).
struct OrientedBox {
  Eigen::Isometry3d T_camera_box = Eigen::Isometry3d::Identity();
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();
};

struct RankedBox {
  OrientedBox box;
  double objectness = 0;  ///< as Segment::objectness
};

}  // namespace objectness
