// SPDX-License-Identifier: BSD-3-Clause
#include "reference/point_overlap.hpp"

#include <algorithm>
#include <cmath>

namespace objectness {
namespace {

constexpr int kBits = 64;

}  // namespace

void PointOverlap::Rows::fill(const std::vector<double>& coordinates, int count, double shift) {
  const std::size_t words = (coordinates.size() + kBits - 1) / kBits;
  rows.assign(count + 1, PointSet(words, 0));
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    // The first face that lies above the point; all later rows get it by the union below.
    const double first = std::max(0.0, std::floor(coordinates[i] - shift) + 1);
    if (first <= count) rows[static_cast<std::size_t>(first)][i / kBits] |= std::uint64_t{1} << (i % kBits);
  }
  for (int row = 1; row <= count; ++row) {
    for (std::size_t word = 0; word < words; ++word) rows[row][word] |= rows[row - 1][word];
  }
}

const PointSet& PointOverlap::Rows::below(int face) const {
  return rows[static_cast<std::size_t>(std::clamp(face, 0, static_cast<int>(rows.size()) - 1))];
}

PointOverlap::PointOverlap(const std::vector<Eigen::Vector3f>& points, const Grid& grid, double margin_m)
    : words_((points.size() + kBits - 1) / kBits) {
  std::vector<double> x, y, z;
  for (const auto& p : points) {
    const Eigen::Vector3d q = grid.toGrid(p.cast<double>());
    x.push_back(q.x());
    y.push_back(q.y());
    z.push_back(q.z());
  }
  const double margin = margin_m / grid.voxel_m;
  x_low_.fill(x, grid.nx, -margin);
  x_high_.fill(x, grid.nx, margin);
  y_low_.fill(y, grid.ny, -margin);
  y_high_.fill(y, grid.ny, margin);
  z_high_.fill(z, grid.nz, margin);
}

PointSet PointOverlap::inside(const Box& box, int grow_xy, int grow_z) const {
  const PointSet &x0 = x_low_.below(box.x0 - grow_xy), &x1 = x_high_.below(box.x1 + grow_xy);
  const PointSet &y0 = y_low_.below(box.y0 - grow_xy), &y1 = y_high_.below(box.y1 + grow_xy);
  const PointSet& z1 = z_high_.below(box.height + grow_z);
  PointSet set(words_);
  for (std::size_t i = 0; i < words_; ++i) set[i] = x1[i] & ~x0[i] & y1[i] & ~y0[i] & z1[i];
  return set;
}

}  // namespace objectness
