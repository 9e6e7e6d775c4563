// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "integral/grid.hpp"
#include "objectness_segmentation/cues/edges.hpp"
#include "objectness_segmentation/cues/superpixels.hpp"
#include "objectness_segmentation/integral/volume_config.hpp"
#include "objectness_segmentation/scene/frame.hpp"
#include "objectness_segmentation/scene/table.hpp"

namespace objectness {

/// The points above the table in the table frame, with the cues they carry.
struct CuePoints {
  std::vector<Eigen::Vector3f> points;  ///< object points, table frame, metres; z >= 0
  std::vector<int> pixels;              ///< pixel index of each
  std::vector<int> labels;              ///< superpixel of each, 0 = not smooth
  std::vector<Eigen::Vector3f> edges;   ///< edge points of any kind, table frame, z >= 0
  int superpixels = 0;
  float top_m = 0;  ///< height of the highest object point
};

CuePoints collectCuePoints(const Frame& frame, const Table& table, const ObjectPoints& object_points,
                           const EdgeMap& edges, const Superpixels& superpixels);

/// The volume of interest seen at one angle: as far as the object points reach (paper Sec. 2), snapped to voxels and
/// `margin` voxels wider on each side, at least volume.min_extent_m wide, from the table up to the highest point but no
/// higher than max_height voxels and no lower than min_height and volume.min_height_m.
Grid makeGrid(const CuePoints& points, double angle_rad, const VolumeConfig& config, int margin, int min_height,
              int max_height);

/// The same from the bounds of the points in the turned frame and the highest point, metres.
Grid makeGrid(const Eigen::Vector2f& low, const Eigen::Vector2f& high, float top_m, double angle_rad,
              const VolumeConfig& config, int margin, int min_height, int max_height);

}  // namespace objectness
