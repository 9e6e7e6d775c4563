// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "objectness_segmentation/scene/table.hpp"

namespace objectness {

struct SeenPoint {
  Eigen::Vector3f place;
  Eigen::Vector3f normal;  ///< towards the camera; zero where there is none
  float upright = 0;       ///< length of the normal's part along the table
  bool has_normal = false;
};

/// What the camera sees of one object, some hundred points of it: table frame, metres.
struct SeenThing {
  std::vector<SeenPoint> points;
  Eigen::Vector3f eye = Eigen::Vector3f::Zero();  ///< of the camera
  double base_m = 0;                              ///< height of what it stands on
  double top_m = 0;                               ///< height of its top
  bool level_top = false;                         ///< its top is a level face that is seen
  double sigma_m = 0;                             ///< of a depth reading at its distance

  double height() const { return top_m - base_m; }
};

/// pixels: of the object, of measured points. The blurred fringe where depth falls from the object to what is behind it
/// is left out: surface that is seen at grazing angle and is not level. A level top is as high as its points in the
/// median, any other as high as all but a few. Without points the thing is empty.
SeenThing seeThing(const Frame& frame, const Normals& normals, const Table& table, const std::vector<int>& pixels,
                   double base_m);

}  // namespace objectness
