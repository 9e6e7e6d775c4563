// SPDX-License-Identifier: BSD-3-Clause
#include "selection/leader_clusters.hpp"

#include <algorithm>
#include <cmath>

namespace objectness {
namespace {

constexpr double kMostCells = 100;  // a side

}  // namespace

LeaderClusters::LeaderClusters(double radius_m, const Eigen::Vector3d& low, const Eigen::Vector3d& high)
    : radius_(radius_m),
      cell_(std::max(radius_m, (high - low).maxCoeff() / kMostCells)),
      low_(low.array() - cell_),
      size_(((high - low) / cell_).cast<int>().array() + 3),
      leaders_at_(static_cast<std::size_t>(size_.x()) * size_.y() * size_.z()) {}

std::size_t LeaderClusters::indexOf(const Eigen::Vector3i& cell) const {
  return (static_cast<std::size_t>(cell.x()) * size_.y() + cell.y()) * size_.z() + cell.z();
}

Eigen::Vector3i LeaderClusters::cellOf(const Eigen::Vector3d& centre) const {
  return ((centre - low_) / cell_).cast<int>();
}

void LeaderClusters::choose(const Leader* first, const Leader* last, const Eigen::Vector3d& centre,
                            Nearest& nearest) const {
  constexpr double kRounding = 1 + 1e-12;  // what is farther by more needs no root
  const auto limitOf = [](double distance) { return distance * distance * kRounding; };
  double limit = limitOf(nearest.cluster < 0 ? radius_ : nearest.distance);
  for (const Leader* leader = first; leader != last; ++leader) {
    const double squared = (leader->centre - centre).squaredNorm();
    if (squared > limit) continue;
    const double distance = std::sqrt(squared);
    if (nearest.cluster < 0 ? distance > radius_ : distance >= nearest.distance) continue;
    nearest = {leader->cluster, distance};
    limit = limitOf(distance);
  }
}

LeaderClusters::Nearest LeaderClusters::nearest(const Eigen::Vector3d& centre) const {
  const std::vector<Leader>& near = leaders_at_[indexOf(cellOf(centre))];
  Nearest nearest;
  choose(near.data(), near.data() + near.size(), centre, nearest);
  return nearest;
}

int LeaderClusters::assign(const Eigen::Vector3d& centre, const Nearest& known, int count) {
  Nearest nearest = known;
  choose(leaders_.data() + count, leaders_.data() + leaders_.size(), centre, nearest);
  if (nearest.cluster >= 0) return nearest.cluster;
  const Leader leader{centre, this->count()};
  const Eigen::Vector3i cell = cellOf(centre);
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) leaders_at_[indexOf(cell + Eigen::Vector3i(x, y, z))].push_back(leader);
    }
  }
  leaders_.push_back(leader);
  return leader.cluster;
}

}  // namespace objectness
