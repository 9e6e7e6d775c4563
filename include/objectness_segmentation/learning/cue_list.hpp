// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace objectness {

// A struct of cues lists its numbers in `cues(self, visit)`, visit(name, value) each: the columns of a model.

template <class Cues>
std::vector<std::string> cueNames() {
  std::vector<std::string> names;
  const Cues none{};
  Cues::cues(none, [&](const char* name, float) { names.emplace_back(name); });
  return names;
}

template <class Cues>
std::vector<float> cueValues(const Cues& cues) {
  std::vector<float> values;
  values.reserve(40);
  Cues::cues(cues, [&](const char*, float value) { values.push_back(value); });
  return values;
}

}  // namespace objectness
