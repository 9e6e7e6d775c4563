// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "selection/global_selection.hpp"

namespace objectness {

/// Random numbers that are the same with every standard library: the distributions of <random> are not.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  int below(int count) { return static_cast<int>(static_cast<std::uint64_t>(engine_()) * count >> 32); }
  double unit() { return engine_() * (1.0 / 4294967296.0); }

 private:
  std::mt19937 engine_;
};

/// Runs the annealing and remembers the best selection ever met. Cost is GlobalCost or BitCost, or what has their
/// interface: all of them do the same moves.
template <class Cost>
class Annealer {
 public:
  template <class Problem>
  Annealer(const Problem& problem, const SelectionConfig& config, unsigned seed)
      : config_(config), cost_(problem, config), random_(seed) {
    best_.active = cost_.active();
  }

  Selection run() {
    const int n = cost_.size();
    if (n == 0) return best_;
    const double end = std::min(config_.end_temperature, config_.start_temperature);
    const double cooling =
        config_.iterations > 1 ? std::pow(end / config_.start_temperature, 1.0 / (config_.iterations - 1)) : 1.0;
    double temperature = config_.start_temperature;
    for (int step = 0; step < config_.iterations; ++step, temperature *= cooling) {
      const int i = random_.below(n), j = random_.below(n), kind = random_.below(4);
      if (kind == 0 && cost_.active()[i] != cost_.active()[j]) {
        attempt({i, j}, temperature);
      } else if (kind == 1 && !cost_.active()[i]) {
        attempt(takeover(i), temperature);
      } else {
        attempt({i}, temperature);
      }
    }
    descend();
    return best_;
  }

 private:
  /// The flips that activate i in the place of all active boxes that hold points of it. One by one, a box that is
  /// better than the two that share its object would first have to be paid for twice.
  std::vector<int> takeover(int i) const {
    std::vector<int> flips = {i};
    for (const int rival : cost_.rivals(i, true)) flips.push_back(rival);
    return flips;
  }

  /// Does the flips if the change of cost that they would make is accepted. The last one is done only then.
  template <class Accept>
  bool flipIf(const std::vector<int>& flips, Accept&& accept) {
    const double before = cost_.cost();
    std::vector<int> done(flips.begin(), flips.end() - 1);
    double delta = 0;
    for (const int i : done) delta += cost_.flip(i);
    delta += cost_.flipDelta(flips.back());
    const bool accepted = accept(delta);
    if (accepted) {
      cost_.flip(flips.back());
    } else if (!done.empty()) {
      cost_.undo(done, before);
    }
    return accepted;
  }

  /// Does the flips if the temperature lets them pass.
  void attempt(const std::vector<int>& flips, double temperature) {
    const bool accepted = flipIf(flips, [&](double delta) {
      return delta <= 0 || (temperature > 0 && random_.unit() < std::exp(-delta / temperature));
    });
    if (accepted) remember();
  }

  void remember() {
    // The margin keeps rounding of the running sum from calling the same selection better.
    if (cost_.cost() < best_.cost - kRounding) best_ = {cost_.active(), cost_.cost()};
  }

  /// Does the flips if they gain.
  bool improve(const std::vector<int>& flips) {
    const bool gains = flipIf(flips, [](double delta) { return delta < -kRounding; });
    if (gains) cost_.changed(flips);
    return gains;
  }

  /// Leaves the active i for the rival that gains most, if one does.
  bool improveBySwap(int i) {
    const double before = cost_.cost(), first = cost_.flip(i);
    int partner = i;
    double lowest = -kRounding;
    for (const int j : cost_.rivals(i, false)) {
      const double delta = first + cost_.flipDelta(j);
      if (delta >= lowest) continue;
      lowest = delta;
      partner = j;
    }
    if (partner == i) {
      cost_.undo({i}, before);
    } else {
      cost_.flip(partner);
      cost_.changed({i, partner});
    }
    return partner != i;
  }

  /// From the best selection down to where no flip, takeover or swap gains.
  void descend() {
    const int n = cost_.size();
    for (int i = 0; i < n; ++i) {
      if (cost_.active()[i] != best_.active[i]) cost_.flip(i);
    }
    for (bool improved = true; improved;) {
      improved = false;
      for (int i = 0; i < n; ++i) {
        if (cost_.settled(i)) continue;
        bool gained = improve({i});
        gained |= cost_.active()[i] ? improveBySwap(i) : improve(takeover(i));
        if (!gained) cost_.settle(i);
        improved |= gained;
      }
    }
    remember();
  }

  static constexpr double kRounding = 1e-9;

  const SelectionConfig config_;
  Cost cost_;
  Random random_;
  Selection best_;
};

}  // namespace objectness
