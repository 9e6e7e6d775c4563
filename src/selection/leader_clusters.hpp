// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace objectness {

/// Leader clustering of paper Sec. 4.1: a box joins the nearest leader within the radius, or leads a cluster of its
/// own.
class LeaderClusters {
 public:
  /// All centres will lie between low and high.
  LeaderClusters(double radius_m, const Eigen::Vector3d& low, const Eigen::Vector3d& high);

  struct Nearest {
    int cluster = -1;     ///< of the first clusters if several are equally near; -1: none within the radius
    double distance = 0;  ///< of its leader
  };
  /// Among the clusters there are. May be called by several threads at once.
  Nearest nearest(const Eigen::Vector3d& centre) const;

  /// Assigns the next box, given its nearest leader among the first `count` clusters, and returns its cluster. Clusters
  /// are numbered in the order of their leaders.
  int assign(const Eigen::Vector3d& centre, const Nearest& known, int count);

  int count() const { return static_cast<int>(leaders_.size()); }

 private:
  struct Leader {
    Eigen::Vector3d centre;
    int cluster;
  };
  std::size_t indexOf(const Eigen::Vector3i& cell) const;
  Eigen::Vector3i cellOf(const Eigen::Vector3d& centre) const;
  void choose(const Leader* first, const Leader* last, const Eigen::Vector3d& centre, Nearest& nearest) const;

  double radius_, cell_;
  Eigen::Vector3d low_;
  Eigen::Vector3i size_;                         ///< cells, no smaller than the radius; an empty one all around
  std::vector<Leader> leaders_;                  ///< by cluster
  std::vector<std::vector<Leader>> leaders_at_;  ///< by cell: those in it and in the cells around it, by cluster
};

}  // namespace objectness
