// SPDX-License-Identifier: BSD-3-Clause
#include "box_points.hpp"

#include <cmath>

#include "set_kernel.hpp"

namespace objectness {
namespace {

constexpr int kBits = 64;
constexpr double kCellM = 0.02;  // points of a cell of the table have their bits together

/// The bits of two numbers by turns: neighbouring cells get near numbers.
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
  const auto cell = [](float metres) { return static_cast<std::uint32_t>(std::floor(metres / kCellM)) + (1u << 20); };
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

void BoxPoints::Rows::fill(const std::vector<double>& coordinates, int count, double shift, std::size_t words_a_row) {
  last = count;
  words = words_a_row;
  bits.assign((count + 1) * words, 0);
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    // The first face that lies above the point; all later rows get it by the union below.
    const double first = std::max(0.0, std::floor(coordinates[i] - shift) + 1);
    if (first <= count) bits[static_cast<std::size_t>(first) * words + i / kBits] |= std::uint64_t{1} << (i % kBits);
  }
  for (std::size_t word = words; word < bits.size(); ++word) bits[word] |= bits[word - words];
}

BoxPoints::RowGroups BoxPoints::groupsOf(const Rows& rows) const {
  RowGroups groups;
  for (int row = 0; row <= rows.last; ++row) {
    std::uint64_t before = 0, after = 0;
    const std::uint64_t* bits = rows.below(row);
    for (int word = 0; word < layout_.words(); ++word) {
      const int left = layout_.points - word * kBits;
      const std::uint64_t used = left >= kBits ? ~std::uint64_t{0} : left <= 0 ? 0 : (std::uint64_t{1} << left) - 1;
      const std::uint64_t group = std::uint64_t{1} << (word / layout_.group_words);
      if (bits[word] != 0) before |= group;
      if ((~bits[word] & used) != 0) after |= group;
    }
    groups.before.push_back(before);
    groups.after.push_back(after);
  }
  return groups;
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
  const std::size_t words = layout.words();
  x_low_.fill(x, grid.nx, -margin, words);
  x_high_.fill(x, grid.nx, margin, words);
  y_low_.fill(y, grid.ny, -margin, words);
  y_high_.fill(y, grid.ny, margin, words);
  z_high_.fill(z, grid.nz, margin, words);
  x_low_groups_ = groupsOf(x_low_);
  x_high_groups_ = groupsOf(x_high_);
  y_low_groups_ = groupsOf(y_low_);
  y_high_groups_ = groupsOf(y_high_);
  z_high_groups_ = groupsOf(z_high_);
}

int BoxPoints::inside(const Box& box, int grow_xy, int grow_z, PointBits& points) const {
  const auto row = [](const Rows& rows, int face) { return std::clamp(face, 0, rows.last); };
  const int x0 = row(x_low_, box.x0 - grow_xy), x1 = row(x_high_, box.x1 + grow_xy);
  const int y0 = row(y_low_, box.y0 - grow_xy), y1 = row(y_high_, box.y1 + grow_xy);
  const int z1 = row(z_high_, box.height + grow_z);
  const std::uint64_t groups = x_low_groups_.after[x0] & x_high_groups_.before[x1] & y_low_groups_.after[y0] &
                               y_high_groups_.before[y1] & z_high_groups_.before[z1];
  return intersectRows(x_high_.below(x1), x_low_.below(x0), y_high_.below(y1), y_low_.below(y0), z_high_.below(z1),
                       groups, layout_.group_words, points.words.data(), points.groups);
}

}  // namespace objectness
