// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "scene/table_evidence.hpp"

namespace objectness {

/// Which of the planes of a view is the table. Holds references to what it is made from.
class TableChoice {
 public:
  TableChoice(const SurfaceSamples& samples, double focal, const std::vector<Plane>& planes, const TableConfig& config);

  /// The plane that looks most like a table; -1: none may be one.
  int best(int threads);

  // After best():
  const SeenPlane& seen(int plane) const { return seen_[plane]; }
  int tilted() const;         ///< planes that are tilted too much, where it is known which way is up
  double largest_m2() const;  ///< extent of the others

 private:
  bool isTilted(int plane) const;
  /// Large enough, by what is seen of it or may be hidden.
  bool mayBeTable(int plane) const;
  bool isTopOfThing(int plane) const;
  bool isFloor(int plane) const;
  void see(int threads);
  void judge(int plane);

  const SurfaceSamples& samples_;
  const double focal_;
  const std::vector<Plane>& planes_;
  const TableConfig& config_;
  std::vector<SeenPlane> seen_;
  std::vector<std::vector<int>> under_;  ///< by plane: those that it lies over, as a table over a floor
  std::vector<char> judged_;             ///< by plane: all of its evidence is known
};

}  // namespace objectness
