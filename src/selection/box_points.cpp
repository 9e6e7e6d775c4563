// SPDX-License-Identifier: BSD-3-Clause
#include "selection/box_points.hpp"

#include <cmath>

#include "selection/set_kernel.hpp"

namespace objectness {
namespace {

constexpr int kBits = 64;
constexpr double kCellM = 0.02;  // points of a cell of the table have their bits together

/// Interleaves the bits of two numbers (Morton order): neighbouring cells get near numbers.
std::uint64_t interleave(std::uint32_t x, std::uint32_t y) {
  std::uint64_t code = 0;
  for (int bit = 0; bit < 32; ++bit) {
    code |= (std::uint64_t{x} >> bit & 1) << (2 * bit) | (std::uint64_t{y} >> bit & 1) << (2 * bit + 1);
  }
  return code;
}

}  // namespace

std::vector<Eigen::Vector3f> inBitOrder(std::vector<Eigen::Vector3f> points) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
  order.reserve(points.size());
  const auto cell = [](float metres) {
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(metres / kCellM)) + (1 << 20));
  };
  std::uint32_t last_x = 0, last_y = 0;
  std::uint64_t code = interleave(0, 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::uint32_t x = cell(points[i].x()), y = cell(points[i].y());
    if (x != last_x || y != last_y) code = interleave(last_x = x, last_y = y);
    order.emplace_back(code, static_cast<std::uint32_t>(i));
  }
  std::sort(order.begin(), order.end());
  std::vector<Eigen::Vector3f> sorted;
  sorted.reserve(points.size());
  for (const auto& [key, i] : order) sorted.push_back(points[i]);
  return sorted;
}

void BoxPoints::Rows::fill(const std::vector<double>& coordinates, int count, double shift, const PointLayout& layout) {
  last = count;
  words = layout.words();
  bits.assign((count + 1) * words, 0);
  // Of each group the first rows that have one, and all, of its points below them.
  std::vector<int> one(layout.groups, count + 1), all(layout.groups, 0);
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    // The first face that lies above the point; all later rows get it by the union below.
    const double place = coordinates[i] - shift;
    const int first = place < 0 ? 0 : place < count ? static_cast<int>(place) + 1 : count + 1;
    if (first <= count) bits[first * words + i / kBits] |= std::uint64_t{1} << (i % kBits);
    const std::size_t group = i / kBits / layout.group_words;
    one[group] = std::min(one[group], first);
    all[group] = std::max(all[group], first);
  }
  for (int row = 1; row <= count; ++row) {
    const std::uint64_t* __restrict above = &bits[(row - 1) * words];
    std::uint64_t* __restrict here = &bits[row * words];
    for (std::size_t word = 0; word < words; ++word) here[word] |= above[word];
  }
  before.assign(count + 1, 0);
  after.assign(count + 1, 0);
  for (int group = 0; group < layout.groups; ++group) {
    const std::uint64_t bit = std::uint64_t{1} << group;
    for (int row = one[group]; row <= count; ++row) before[row] |= bit;
    for (int row = 0; row < std::min(all[group], count + 1); ++row) after[row] |= bit;
  }
}

BoxPoints::BoxPoints(const std::vector<Eigen::Vector3f>& points, const PointLayout& layout, const Grid& grid,
                     double margin_m)
    : layout_(layout) {
  std::vector<double> x, y, z;
  x.reserve(points.size()), y.reserve(points.size()), z.reserve(points.size());
  for (const auto& p : points) {
    const Eigen::Vector3d q = grid.toGrid(p.cast<double>());
    x.push_back(q.x());
    y.push_back(q.y());
    z.push_back(q.z());
  }
  const double margin = margin_m / grid.voxel_m;
  x_low_.fill(x, grid.nx, -margin, layout);
  x_high_.fill(x, grid.nx, margin, layout);
  y_low_.fill(y, grid.ny, -margin, layout);
  y_high_.fill(y, grid.ny, margin, layout);
  z_high_.fill(z, grid.nz, margin, layout);
}

int BoxPoints::inside(const Box& box, int grow_xy, int grow_z, PointBits& points) const {
  const auto row = [](const Rows& rows, int face) { return std::clamp(face, 0, rows.last); };
  const int x0 = row(x_low_, box.x0 - grow_xy), x1 = row(x_high_, box.x1 + grow_xy);
  const int y0 = row(y_low_, box.y0 - grow_xy), y1 = row(y_high_, box.y1 + grow_xy);
  const int z1 = row(z_high_, box.height + grow_z);
  const std::uint64_t groups =
      x_low_.after[x0] & x_high_.before[x1] & y_low_.after[y0] & y_high_.before[y1] & z_high_.before[z1];
  return intersectRows(x_high_.below(x1), x_low_.below(x0), y_high_.below(y1), y_low_.below(y0), z_high_.below(z1),
                       groups, layout_.group_words, points.words.data(), points.groups);
}

}  // namespace objectness
