// SPDX-License-Identifier: BSD-3-Clause
#include "selection/scene_points.hpp"

#include <cstdint>
#include <unordered_set>

#include "selection/cell_key.hpp"

namespace objectness {
namespace {

/// Which cells have been seen: a bit for each where the scene is small enough, as it mostly is.
class SeenCells {
 public:
  SeenCells(const Cell& low, const Cell& high) : low_(low), size_(high - low + Cell::Ones()) {
    constexpr double kMostCells = 1 << 27;  // 16 MiB of bits
    if (size_.cast<double>().prod() <= kMostCells) bits_.resize(size_.prod());
  }

  /// Whether it is the first time.
  bool insert(const Cell& cell) {
    if (bits_.empty()) return keys_.insert(keyOf(cell)).second;
    const Cell at = cell - low_;
    const auto bit = bits_[(at.x() * size_.y() + at.y()) * size_.z() + at.z()];
    if (bit) return false;
    bits_[(at.x() * size_.y() + at.y()) * size_.z() + at.z()] = true;
    return true;
  }

 private:
  Cell low_, size_;
  std::vector<bool> bits_;
  std::unordered_set<std::uint64_t> keys_;
};

}  // namespace

std::vector<Eigen::Vector3f> thinPoints(const std::vector<Eigen::Vector3f>& points, double spacing_m, double top_m) {
  std::vector<Eigen::Vector3f> thinned;
  if (points.empty()) return thinned;
  Eigen::Vector3f low = points.front(), high = low;
  for (const auto& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  SeenCells seen(cellOf(low, spacing_m), cellOf(high, spacing_m));
  for (const auto& p : points) {
    if (p.z() <= top_m && seen.insert(cellOf(p, spacing_m))) thinned.push_back(p);
  }
  return thinned;
}

}  // namespace objectness
