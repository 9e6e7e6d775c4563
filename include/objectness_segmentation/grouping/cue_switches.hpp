// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include "objectness_segmentation/learning/cue_list.hpp"

namespace objectness {

/// Which cues of a kind are used, a flag for each by the cue's own name. A disabled cue has the default value of its
/// struct in every sample, for links, groups, rules and learning alike. A forest that was learned with the cue then
/// sees that one value; to measure what a cue is worth, learn a model without it.
template <class Cues>
struct CueSwitches {
  static constexpr std::size_t kCount = sizeof(Cues) / sizeof(float);  // structs of cues hold nothing but cues

  CueSwitches() { on.fill(true); }

  std::array<bool, kCount> on;  ///< in the order of Cues::cues()

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    std::size_t k = 0;
    const Cues none{};
    Cues::cues(none, [&](const char* name, float) {
      visit(name, self.on[k++], "this cue is used; off: it has the same value everywhere");
    });
  }

  /// What is left of them.
  Cues operator()(Cues cues) const {
    std::array<float, kCount> neutral;
    std::size_t k = 0;
    const Cues none{};
    Cues::cues(none, [&](const char*, float value) { neutral[k++] = value; });
    k = 0;
    Cues::cues(cues, [&](const char*, float& value) {
      if (!on[k]) value = neutral[k];
      ++k;
    });
    return cues;
  }
};

}  // namespace objectness
