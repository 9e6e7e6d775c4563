// SPDX-License-Identifier: BSD-3-Clause
#include "objectness/cue_scores.hpp"

namespace objectness {

double visibleArea(const Box& box, const Eigen::Vector3d& viewpoint) {
  const double sx = box.sizeX(), sy = box.sizeY(), sz = box.height;
  double area = 0;
  if (viewpoint.x() < box.x0 || viewpoint.x() > box.x1) area += sy * sz;
  if (viewpoint.y() < box.y0 || viewpoint.y() > box.y1) area += sx * sz;
  // The bottom face lies on the table, whose upper side the camera sees.
  if (viewpoint.z() > box.height) area += sx * sy;
  return area;
}

double threeFaceArea(const Box& box) {
  const double sx = box.sizeX(), sy = box.sizeY(), sz = box.height;
  return sx * sy + sx * sz + sy * sz;
}

double edgeDensity(int edges, double area) { return area > 0 ? edges / area : 0; }

double outerEdges(int edges, int edges_expanded) {
  return edges_expanded > 0 ? static_cast<double>(edges) / edges_expanded : 0;
}

double straddling(int inside, int total) { return total > 0 ? static_cast<double>(inside) * inside / total : 0; }

double straddling(double sum_over_superpixels, int labelled) {
  return labelled > 0 ? sum_over_superpixels / labelled : 0;
}

double freeSpace(long volume, int filled, double area) {
  return area > 0 ? static_cast<double>(volume - filled) / area : 0;
}

}  // namespace objectness
