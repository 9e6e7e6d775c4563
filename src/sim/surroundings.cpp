// SPDX-License-Identifier: BSD-3-Clause
#include "sim/surroundings.hpp"

#include <sstream>

namespace objectness::sim {
namespace {

constexpr double kChance = 0.3;  // of each

}  // namespace

Result<Surroundings> parseSurroundings(const std::string& text) {
  Surroundings wanted;
  if (text == "none") return {{}, wanted};
  std::istringstream in(text + ",");
  for (std::string word; std::getline(in, word, ',');) {
    bool known = false;
    Surroundings::visit(wanted, [&](const char* name, bool& field) {
      if (word != name) return;
      known = field = true;
    });
    if (!known) {
      return Result<Surroundings>::error(StatusCode::kBadConfig,
                                         "'" + word + "' is not arm, wall, rack or table (or none of them: none)");
    }
  }
  return {{}, wanted};
}

Surroundings drawSurroundings(Random& random) {
  Surroundings drawn;
  Surroundings::visit(drawn, [&](const char*, bool& field) { field = random.chance(kChance); });
  return drawn;
}

}  // namespace objectness::sim
