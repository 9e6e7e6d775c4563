// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace objectness {

/// Leader clustering of paper Sec. 4.1: a box joins the nearest leader within the radius, or leads a cluster of its own.
class LeaderClusters {
 public:
  /// All centres will lie between low and high.
  LeaderClusters(double radius_m, const Eigen::Vector3d& low, const Eigen::Vector3d& high);

  /// The cluster of the next box: clusters are numbered as they are led.
  int assign(const Eigen::Vector3d& centre);

 private:
  struct Leader {
    Eigen::Vector3d centre;
    int cluster;
  };
  double radius_, cell_;
  Eigen::Vector3d low_;
  Eigen::Vector3i size_;  ///< cells, no smaller than the radius; an empty one all around
  std::vector<std::vector<Leader>> leaders_in_;
  int clusters_ = 0;
};

}  // namespace objectness
