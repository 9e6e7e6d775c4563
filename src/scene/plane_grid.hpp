// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/surface_samples.hpp"

namespace objectness {

/// Axes of the table frame of a plane; see Table::T_table_camera.
Eigen::Isometry3d tableFrame(const Plane& plane);

/// Where the samples of a view meet a plane, on a grid of square cells in the plane's own x and y.
struct PlaneGrid {
  Eigen::Isometry3d T_table_camera = Eigen::Isometry3d::Identity();
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  double cell_m = 0.02;
  int rows = 0, columns = 0;
  cv::Mat_<uchar> on_plane;      ///< 255 = a sample lies on the plane here
  cv::Mat_<uchar> seen_through;  ///< 255 = samples lie behind the plane on rays that cross it here: certainly no table
  cv::Mat_<uchar> covered;       ///< 255 = a sample lies over the plane here, or hides it
  cv::Mat_<uchar> feet;          ///< 255 = a sample lies a little over the plane here, as the foot of a thing does
  int samples_on_plane = 0;

  bool empty() const { return on_plane.empty(); }
  /// Cell of a point of the plane; false outside the grid.
  bool cell(double x, double y, cv::Point& result) const {
    const double column = (x - origin.x()) / cell_m, row = (y - origin.y()) / cell_m;
    if (!(column >= 0 && row >= 0 && column < columns && row < rows)) return false;
    result = {static_cast<int>(column), static_cast<int>(row)};
    return true;
  }
};

/// The same for any number of threads.
PlaneGrid makePlaneGrid(const SurfaceSamples& samples, const Plane& plane, double cell_m, int threads = 1);

/// The table's extent: cells on the plane without specks, the shadows behind things bridged, holes filled, but nothing
/// that was seen through; the largest connected part. Same size as the grid, values as TableExtent::cells.
cv::Mat_<uchar> extentOf(const PlaneGrid& grid);

/// Marks where things stand beyond the extent as if the table went on there (TableExtent::kBeyond): they come down to
/// the plane, and the view goes through the plane neither around their feet nor on the way to them, as it does in front
/// of what stands behind a table.
void markBeyond(const PlaneGrid& grid, cv::Mat_<uchar>& extent);

}  // namespace objectness
