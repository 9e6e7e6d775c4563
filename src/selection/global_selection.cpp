// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/selection/global_selection.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

namespace objectness {
namespace {

/// Random numbers that are the same with every standard library: the distributions of <random> are not.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  int below(int count) { return static_cast<int>(static_cast<std::uint64_t>(engine_()) * count >> 32); }
  double unit() { return engine_() * (1.0 / 4294967296.0); }

 private:
  std::mt19937 engine_;
};

/// Runs the annealing and remembers the best selection ever met.
class Annealer {
 public:
  Annealer(const std::vector<CostHypothesis>& hypotheses, int points, const SelectionConfig& config, unsigned seed)
      : config_(config), cost_(hypotheses, points, config), random_(seed) {
    best_.active = cost_.active();
  }

  Selection run() {
    const int n = cost_.size();
    if (n == 0) return best_;
    const double cooling = config_.iterations > 1
        ? std::pow(config_.end_temperature / std::max(config_.start_temperature, config_.end_temperature),
                   1.0 / (config_.iterations - 1))
        : 1.0;
    double temperature = config_.start_temperature;
    for (int step = 0; step < config_.iterations; ++step, temperature *= cooling) {
      const int i = random_.below(n), j = random_.below(n);
      // A swap leaves one box for another in a single step; on its own, either flip may cost more than the swap gains.
      if (i != j && cost_.active()[i] != cost_.active()[j] && random_.unit() < 0.5) {
        trySwap(i, j, temperature);
      } else {
        tryFlip(i, temperature);
      }
    }
    descend();
    return best_;
  }

 private:
  bool accept(double delta, double temperature) {
    return delta <= 0 || (temperature > 0 && random_.unit() < std::exp(-delta / temperature));
  }

  void tryFlip(int i, double temperature) {
    if (!accept(cost_.flipDelta(i), temperature)) return;
    cost_.flip(i);
    remember();
  }

  void trySwap(int i, int j, double temperature) {
    const double first = cost_.flip(i);
    if (accept(first + cost_.flipDelta(j), temperature)) {
      cost_.flip(j);
      remember();
    } else {
      cost_.flip(i);
    }
  }

  void remember() {
    // The margin keeps rounding of the running sum from calling the same selection better.
    if (cost_.cost() < best_.cost - 1e-9) best_ = {cost_.active(), cost_.cost()};
  }

  /// From the best selection down to where neither a flip nor a swap gains.
  void descend() {
    for (int i = 0; i < cost_.size(); ++i) {
      if (cost_.active()[i] != best_.active[i]) cost_.flip(i);
    }
    for (bool improved = true; improved;) {
      improved = false;
      for (int i = 0; i < cost_.size(); ++i) {
        if (cost_.flipDelta(i) < -1e-9) {
          cost_.flip(i);
          improved = true;
        }
      }
      for (int i = 0; i < cost_.size(); ++i) {
        if (!cost_.active()[i]) continue;
        const double first = cost_.flip(i);
        int partner = i;
        double lowest = -1e-9;
        for (int j = 0; j < cost_.size(); ++j) {
          if (cost_.active()[j] || j == i) continue;
          const double delta = first + cost_.flipDelta(j);
          if (delta < lowest) {
            lowest = delta;
            partner = j;
          }
        }
        cost_.flip(partner);
        improved |= partner != i;
      }
    }
    remember();
  }

  const SelectionConfig config_;
  GlobalCost cost_;
  Random random_;
  Selection best_;
};

}  // namespace

Selection selectHypotheses(const std::vector<CostHypothesis>& hypotheses, int points, const SelectionConfig& config,
                           unsigned seed) {
  return Annealer(hypotheses, points, config, seed).run();
}

}  // namespace objectness
