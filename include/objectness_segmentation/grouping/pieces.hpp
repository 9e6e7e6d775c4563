// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "objectness_segmentation/common/range.hpp"
#include "objectness_segmentation/cues/superpixels.hpp"

namespace objectness {

struct PiecesConfig {
  double max_reach_m = 0.04;
  double max_step_m = 0.015;
  double min_area_m2 = 0.4e-4;
  int min_pixels = 30;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("max_reach_m", self.max_reach_m, Range{0, 0.5},
          "how far along the surface a point follows its nearest superpixel");
    visit("max_step_m", self.max_step_m, Range{0.001, 0.1}, "neighbouring pixels farther apart are not on one surface");
    visit("min_area_m2", self.min_area_m2, Range{0, 0.01}, "rough parts that show less surface are no pieces");
    visit("min_pixels", self.min_pixels, Range{1, 100000}, "rough parts of fewer pixels are no pieces");
  }
};

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
