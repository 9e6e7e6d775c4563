// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "common/angles.hpp"

namespace objectness::sim {

/// Random numbers that are the same on every platform: the standard fixes what its generator and its seed_seq yield,
/// but not what its distributions make of it. (Nor does it fix in which order the arguments of a call are computed:
/// draw each number in a statement, or in braces, of its own.)
class Random {
 public:
  explicit Random(std::uint32_t seed) : generator_(seed) {}
  /// Independent of any other list of seeds.
  explicit Random(const std::vector<std::uint32_t>& seeds) {
    std::seed_seq sequence(seeds.begin(), seeds.end());
    generator_.seed(sequence);
  }

  std::uint32_t bits() { return generator_(); }
  double uniform(double low, double high) { return low + (high - low) * (generator_() / 4294967296.0); }
  /// low..high, both included.
  int integer(int low, int high) { return low + static_cast<int>(uniform(0, 1) * (high - low + 1)); }
  bool chance(double probability) { return uniform(0, 1) < probability; }
  template <class T>
  const T& pick(const std::vector<T>& from) {
    return from[integer(0, static_cast<int>(from.size()) - 1)];
  }

  /// Mean 0, deviation 1 (Box and Muller, who give two at a time).
  double gaussian() {
    if (has_second_) {
      has_second_ = false;
      return second_;
    }
    const double radius = std::sqrt(-2 * std::log((generator_() + 1.0) / 4294967296.0));
    const double angle = 2 * kPi * generator_() / 4294967296.0;
    has_second_ = true;
    second_ = radius * std::sin(angle);
    return radius * std::cos(angle);
  }

 private:
  std::mt19937 generator_;
  double second_ = 0;
  bool has_second_ = false;
};

}  // namespace objectness::sim
