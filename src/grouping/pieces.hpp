// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "objectness_segmentation/cues/superpixels.hpp"
#include "objectness_segmentation/grouping/grouping_config.hpp"

namespace objectness {

/// What objects are put together from: a superpixel with the rough points around it, or a rough part without one.
struct Piece {
  std::vector<int> pixels;                                ///< ascending
  int smooth_pixels = 0;                                  ///< of these, in the superpixel; 0: a rough part
  float area_m2 = 0;                                      ///< as seen: the sum of (z / f)^2
  Eigen::Vector3f centroid = Eigen::Vector3f::Zero();     ///< camera frame, metres
  Eigen::Vector3f mean_normal = Eigen::Vector3f::Zero();  ///< camera frame, shorter than 1 the more it bends
};

/// A partition of (nearly all) object points. Piece i < superpixels.count is superpixel i + 1.
struct Pieces {
  cv::Mat_<int> label;  ///< H x W, -1 = none, else index into pieces
  std::vector<Piece> pieces;

  int count() const { return static_cast<int>(pieces.size()); }
};

/// Gives every object point to the superpixel nearest along the surface; connected rests become pieces of their own.
Pieces findPieces(const Frame& frame, const Normals& normals, const ObjectPoints& object_points,
                  const Superpixels& superpixels, const PiecesConfig& config, int threads = 1);

/// findPieces() in two steps. The first leaves the pieces without what describePieces() fills in: all but their number.
Pieces labelPieces(const Frame& frame, const ObjectPoints& object_points, const Superpixels& superpixels,
                   const PiecesConfig& config, int threads = 1);
void describePieces(const Frame& frame, const Normals& normals, const Superpixels& superpixels, Pieces& pieces);

}  // namespace objectness
