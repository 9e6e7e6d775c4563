// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "scene/height_map.hpp"

namespace objectness {

/// A tray, tote or bin: a level floor that walls of one height enclose, with things on it.
struct Container {
  Eigen::Vector3d floor = Eigen::Vector3d::Zero();  ///< its height over the table at (x, y) is floor . (x, y, 1)
  std::vector<cv::Point2f> outline;                 ///< of the floor: convex, table frame, metres
  double wall_height_m = 0;                         ///< over the floor
  std::vector<int> pixels;                          ///< all that its walls enclose, and these

  double floorHeight(double x, double y) const { return floor.dot(Eigen::Vector3d(x, y, 1)); }
};

/// Containers among the connected parts of `mask`, what is over the table (aboveTable()), in the order of their first
/// pixels. The floor may lie on the table, over it by any height, or be the table itself.
///
/// Bowls and plates are none, for their floors are small: they are objects, as are containers that nothing is in.
std::vector<Container> findContainers(const Frame& frame, const Normals& normals, const Table& table,
                                      const HeightMap& map, const cv::Mat_<uchar>& mask);

/// H x W, 255 = a point of a container.
struct ContainerMasks {
  cv::Mat_<uchar> floor, all;  ///< all: the walls, too
};

/// Takes the floors and walls of containers out of `mask` and returns them; what stands on the floors stays, and is
/// judged by its height over the floor. `map`: containers become a part of the table's extent (HeightMap::inside).
ContainerMasks takeContainers(const Frame& frame, const Normals& normals, const Table& table,
                              const std::vector<Container>& containers, HeightMap& map, cv::Mat_<uchar>& mask);

}  // namespace objectness
