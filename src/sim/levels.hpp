// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace objectness::sim {

/// How difficult a scene is: what is on the table and how it is put there.
struct Level {
  std::string name, description;
  int min_objects, max_objects;
  std::vector<std::string> kinds;  ///< drawn from; some more than once
  /// How the objects are put down, as relative chances; the second object gets the largest but `apart`'s.
  struct Chances {
    double apart, behind, beside, on, leaning;
  } chances;
  double min_gap_m;     ///< between what is not meant to touch
  double min_visible;   ///< least share of every object that is not covered
  double most_covered;  ///< at least one object shows no more of itself than this
};

/// From easy to hard.
const std::vector<Level>& levels();

/// Null when there is none of that name.
const Level* findLevel(const std::string& name);

/// The names, parted by ", ".
std::string levelNames();

}  // namespace objectness::sim
