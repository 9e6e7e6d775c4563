// SPDX-License-Identifier: BSD-3-Clause
#include "leader_clusters.hpp"

#include <algorithm>

namespace objectness {
namespace {

constexpr double kMostCells = 100;  // a side

}  // namespace

LeaderClusters::LeaderClusters(double radius_m, const Eigen::Vector3d& low, const Eigen::Vector3d& high)
    : radius_(radius_m),
      cell_(std::max(radius_m, (high - low).maxCoeff() / kMostCells)),
      low_(low.array() - cell_),
      size_(((high - low) / cell_).cast<int>().array() + 3),
      leaders_in_(static_cast<std::size_t>(size_.x()) * size_.y() * size_.z()) {}

int LeaderClusters::assign(const Eigen::Vector3d& centre) {
  const Eigen::Vector3i cell = ((centre - low_) / cell_).cast<int>();
  const auto index = [&](int x, int y, int z) { return (static_cast<std::size_t>(x) * size_.y() + y) * size_.z() + z; };
  int nearest = -1;
  double nearest_distance = radius_;
  for (int x = cell.x() - 1; x <= cell.x() + 1; ++x) {
    for (int y = cell.y() - 1; y <= cell.y() + 1; ++y) {
      for (int z = cell.z() - 1; z <= cell.z() + 1; ++z) {
        for (const Leader& leader : leaders_in_[index(x, y, z)]) {
          const double distance = (leader.centre - centre).norm();
          if (distance > nearest_distance) continue;
          if (distance == nearest_distance && nearest >= 0 && nearest < leader.cluster) continue;
          nearest = leader.cluster;
          nearest_distance = distance;
        }
      }
    }
  }
  if (nearest >= 0) return nearest;
  leaders_in_[index(cell.x(), cell.y(), cell.z())].push_back({centre, clusters_});
  return clusters_++;
}

}  // namespace objectness
