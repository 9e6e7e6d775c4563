// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "objectness_segmentation/scene/normals.hpp"

namespace objectness {

constexpr int kMinWindowPx = 3;        // normals of smaller windows are noise
constexpr double kGrazingSlope = 8.0;  // depth change per z / f of a surface seen at about 83 deg

/// The directions a bend is looked for in: right, down and the two diagonals, in pixels.
constexpr std::array<std::array<int, 2>, 4> kBendDirections{{{{1, 0}}, {{0, 1}}, {{1, 1}}, {{1, -1}}}};

/// How sharply the surface bends at a pixel: the angle between the normals one window radius to either side, as
/// 1 - cos(angle), so that it reads the same at any resolution, depth and window. 0 where it does not bend that way or
/// no normals can be compared; a window radius never reaches across a depth jump, so neither does this.
struct BendMap {
  cv::Mat_<float> convex;     ///< H x W, the sharpest of the four directions
  cv::Mat_<float> concave;    ///< H x W
  cv::Mat_<uchar> direction;  ///< H x W, index into kBendDirections of the sharper of the two
};

/// Bends of the pixels where `where` is set.
BendMap findBends(const Frame& frame, const Normals& normals, const cv::Mat_<uchar>& where, int threads = 1);

/// How far the surface steps to the side at a pixel, metres: the distance between the planes fitted to the windows that
/// end on either side of it, seen from both. A bend, convex or concave, is no step. 0 where no windows can be compared.
float stepAt(const Frame& frame, const Normals& normals, const cv::Mat_<uchar>& where, int u, int v);

/// stepAt() of the pixels of rows first..last-1 where `where` is set, 0 elsewhere.
void findStepsInRows(const Frame& frame, const Normals& normals, const cv::Mat_<uchar>& where, int first, int last,
                     cv::Mat_<float>& steps);

/// The ridge lines of the bends, one pixel wide: 255 where a bend of at least min_angle_deg is the sharpest within one
/// window radius across its line. Of the pixels where `where` is set; 0 elsewhere.
cv::Mat_<uchar> thinCreases(const BendMap& bends, const Normals& normals, const cv::Mat_<uchar>& where,
                            double min_angle_deg, int threads = 1);

/// An angle on the scale of BendMap.
double bendOf(double angle_deg);

}  // namespace objectness
