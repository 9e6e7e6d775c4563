// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>

namespace objectness {

/// A cell of a cubic lattice.
using Cell = Eigen::Matrix<std::int64_t, 3, 1>;

template <class Scalar>
Cell cellOf(const Eigen::Matrix<Scalar, 3, 1>& p, double size) {
  return (p.template cast<double>() / size).array().floor().template cast<std::int64_t>();
}

/// A cell as one number: 21 bits an axis, 10 km in cells of 5 mm.
inline std::uint64_t keyOf(const Cell& cell) {
  std::uint64_t key = 0;
  for (int axis = 0; axis < 3; ++axis)
    key = key << 21 | (static_cast<std::uint64_t>(cell[axis] + (1 << 20)) & 0x1FFFFF);
  return key;
}

}  // namespace objectness
