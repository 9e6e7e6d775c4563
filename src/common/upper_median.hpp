// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

namespace objectness {

/// The median, of an even number of values the upper one in the middle. values: not empty, no NaN; reordered.
template <class T>
T upperMedian(std::vector<T>& values) {
  const auto middle = values.begin() + values.size() / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace objectness
