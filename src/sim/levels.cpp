// SPDX-License-Identifier: BSD-3-Clause
#include "sim/levels.hpp"

#include <algorithm>

namespace objectness::sim {

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
  return all;
}

const Level* findLevel(const std::string& name) {
  const auto found = std::find_if(levels().begin(), levels().end(), [&](const Level& l) { return l.name == name; });
  return found == levels().end() ? nullptr : &*found;
}

std::string levelNames() {
  std::string names;
  for (const Level& level : levels()) names += (names.empty() ? "" : ", ") + level.name;
  return names;
}

}  // namespace objectness::sim
