// SPDX-License-Identifier: BSD-3-Clause
#include "sim/levels.hpp"

#include "sim/named.hpp"

namespace objectness::sim {

namespace {

// Trays and shelves are looked at as tables are, totes from over them with the camera turned in any way.
constexpr ViewRange kFromAbove{65, 90, 90, 180}, kFromTheFront{10, 40, 30, 3}, kFromTheTable{20, 75, 35, 8};

std::vector<Level> everydayLevels() {
  const std::vector<std::string> low{"plate", "plate", "pan", "lid",    "knife",  "fork", "spoon",
                                     "knife", "fork",  "pen", "marker", "marker", "book", "book"};
  const std::vector<std::string> mixed{"box",  "box",    "cylinder", "can",    "mug",         "bowl",
                                       "bowl", "bottle", "jar",      "packet", "fruit",       "banana",
                                       "book", "marker", "open box", "hammer", "screwdriver", "spoon"};
  const std::vector<std::string> picked{"box",    "packet", "can",    "lying can", "jar",    "bottle",     "cylinder",
                                        "banana", "fruit",  "hammer", "marker",    "packet", "screwdriver"};
  const std::vector<std::string> shelved{"box",    "box", "cylinder", "can",  "can",
                                         "bottle", "jar", "book",     "bowl", "mug"};
  const std::vector<std::string> stacked{"can", "can", "can", "box", "box", "packet", "cylinder"};
  const std::vector<std::string> hollow{"bowl", "bowl", "plate", "plate", "pan", "mug", "can"};
  std::vector<Level> all{
      {"plates", "low things: plates, pans, lids, cutlery, pens, books", 3, 10, low, {1, 0.7, 0, 0.3, 0}, 0.01, 0.3, 1},
      {"tray", "things on a tray with a rim", 3, 9, mixed, {1, 0.5, 1, 0.3, 0}, 0.005, 0.15, 1},
      {"tote", "things in an open box with high walls, from above", 3, 12, picked, {1, 0, 1.5, 0.4, 0}, 0.004, 0.15, 1},
      {"shelf", "things on a board with back and sides", 3, 9, shelved, {1, 0.7, 1.2, 0.5, 0.3}, 0.005, 0.1, 1},
      {"stacks", "cans on cans and boxes on boxes, in line", 3, 9, stacked, {1, 0.3, 0.3, 0, 0, 3}, 0.01, 0.15, 1},
      {"contents", "things in bowls, on plates and in pans", 3, 10, hollow, {1, 0.2, 0, 0, 0, 0, 3}, 0.01, 0.2, 1}};
  for (Level& level : all) level.everyday = true, level.view = kFromTheTable;
  all[1].stage = StageKind::kTray;
  all[2].stage = StageKind::kTote, all[2].view = kFromAbove;
  all[3].stage = StageKind::kShelf, all[3].view = kFromTheFront;
  all[5].fillings = {"fruit", "fruit", "packet", "can"};
  return all;
}

}  // namespace

const char* toString(StageKind kind) {
  switch (kind) {
    case StageKind::kTray:
      return "tray";
    case StageKind::kTote:
      return "tote";
    case StageKind::kShelf:
      return "shelf";
    default:
      return "table";
  }
}

const std::vector<Level>& levels() {
  static const std::vector<std::string> every{"box", "cylinder", "cone", "sphere", "bowl", "mug", "bottle"};
  static const std::vector<std::string> to_stack{"box", "box", "box", "cylinder", "mug", "bowl"};
  static const std::vector<std::string> to_lean_at{"box", "box", "cylinder", "mug", "bottle"};
  // clang-format off
  static const std::vector<Level> all{
      {"boxes", "boxes that stand apart", 2, 8, {"box"}, {1, 0, 0, 0, 0}, 0.03, 0.6, 1},
      {"shapes", "things of all kinds that stand apart", 2, 8, every, {1, 0, 0, 0, 0}, 0.03, 0.6, 1},
      {"occluded", "things of all kinds behind one another", 3, 8, every, {1, 2, 0, 0, 0}, 0.01, 0.15, 0.7},
      {"touching", "things side by side with gaps of up to 2 mm", 3, 8, every, {1, 0, 2, 0, 0}, 0.01, 0.15, 1},
      {"stacked", "things on top of boxes and cylinders", 3, 8, to_stack, {1, 0, 0, 2, 0}, 0.01, 0.15, 1},
      {"leaning", "books and boards that lean at other things", 2, 8, to_lean_at, {1, 0, 0, 0, 1}, 0.01, 0.15, 1},
      {"clutter", "all of this, close together", 10, 20, every, {1, 1, 1.5, 1, 0.5}, 0.003, 0, 1}};
  // clang-format on
  static const std::vector<Level> both = [] {
    std::vector<Level> joined = all;
    for (const Level& level : everydayLevels()) joined.push_back(level);
    return joined;
  }();
  return both;
}

const Level* findLevel(const std::string& name) { return findNamed(levels(), name); }

std::string levelNames() { return namesOf(levels()); }

}  // namespace objectness::sim
