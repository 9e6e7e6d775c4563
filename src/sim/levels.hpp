// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace objectness::sim {

/// The range that camera poses are drawn from: distance from what the camera looks at, angle below the horizon, turn
/// from the front of the table and roll, either way.
constexpr double kMinDistance_m = 0.6, kMaxDistance_m = 1.6, kMinTilt_deg = 20, kMaxTilt_deg = 60;
struct ViewRange {
  double min_tilt_deg = kMinTilt_deg, max_tilt_deg = kMaxTilt_deg, max_turn_deg = 35, max_roll_deg = 3;
};

/// What the things stand on: the table itself, or something with a rim that stands on it.
enum class StageKind {
  kTable,
  kTray,  ///< a low rim all around
  kTote,  ///< an open box with high walls
  kShelf  ///< a board with a back and sides, some with another board over it, some raised over the table
};

/// "tray", "tote" or "shelf"; "table".
const char* toString(StageKind kind);

/// How difficult a scene is: what is on the table and how it is put there.
struct Level {
  std::string name, description;
  int min_objects, max_objects;
  std::vector<std::string> kinds;  ///< drawn from; some more than once
  /// How the objects are put down, as relative chances; the second object gets the largest but `apart`'s.
  struct Chances {
    double apart, behind, beside, on, leaning;
    double flush = 0;   ///< on one of the same kind and size, in line with it
    double within = 0;  ///< one of `fillings` in a bowl, plate or pan
  } chances;
  double min_gap_m;     ///< between what is not meant to touch
  double min_visible;   ///< least share of every object that is not covered
  double most_covered;  ///< at least one object shows no more of itself than this
  /// Everyday things in everyday places, other things around the table; not of the levels that `all` means.
  bool everyday = false;
  std::vector<std::string> fillings = {};
  StageKind stage = StageKind::kTable;
  ViewRange view = {};
};

/// From easy to hard; the everyday ones last.
const std::vector<Level>& levels();

/// Null when there is none of that name.
const Level* findLevel(const std::string& name);

/// The names, separated by ", ".
std::string levelNames();

}  // namespace objectness::sim
