// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace objectness {

/// The value that a share of them, 0 to 1, are not above; 0.5: the median, of an even number the lower one in the
/// middle. values: not empty; reordered.
template <class T>
T shareBelow(double share, std::vector<T>& values) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace objectness
