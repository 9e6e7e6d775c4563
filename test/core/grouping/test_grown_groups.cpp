// SPDX-License-Identifier: BSD-3-Clause
// The groups that a beam grows, against a plain loop over all sets of pieces.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "grouping/propose_groups.hpp"

using namespace objectness;

namespace {

using Group = std::vector<int>;
constexpr std::size_t kLargest = 7;
constexpr float kLinked = 0.15f, kWellLinked = 0.3f;

/// Probabilities of the links between all pieces.
struct Pairs {
  int pieces;
  std::vector<float> probability;

  float of(int a, int b) const { return probability[a * pieces + b]; }
  float logOdds(int a, int b) const {
    const float p = std::min(0.98f, std::max(0.02f, of(a, b)));
    return std::log(p / (1 - p));
  }
  float sum(const Group& group) const {
    float sum = 0;
    for (std::size_t i = 0; i < group.size(); ++i) {
      for (std::size_t j = i + 1; j < group.size(); ++j) sum += logOdds(group[i], group[j]);
    }
    return sum;
  }
  float strongest(const Group& group, int piece) const {
    float most = 0;
    for (const int other : group) most = other == piece ? most : std::max(most, of(other, piece));
    return most;
  }
};

Pairs randomPairs(int pieces, std::mt19937& random) {
  Pairs pairs{pieces, std::vector<float>(pieces * pieces, 0.f)};
  for (int a = 0; a < pieces; ++a) {
    for (int b = a + 1; b < pieces; ++b) {
      pairs.probability[a * pieces + b] = pairs.probability[b * pieces + a] =
          static_cast<float>(random() % 1000) / 1000;
    }
  }
  return pairs;
}

std::vector<Link> linksOf(const Pairs& pairs) {
  std::vector<Link> links;
  for (int a = 0; a < pairs.pieces; ++a) {
    for (int b = a + 1; b < pairs.pieces; ++b) links.push_back({a, b, true, pairs.of(a, b)});
  }
  return links;
}

Group without(Group group, int piece) {
  group.erase(std::find(group.begin(), group.end(), piece));
  return group;
}

/// From every piece the `beam` best sets of each size that hold one of those a piece smaller, which a link connects to
/// the last one; then all these with one piece more or less.
std::vector<Group> plainGrown(const Pairs& pairs, std::size_t beam) {
  std::vector<std::vector<Group>> of_size(kLargest + 1);
  for (unsigned bits = 1; bits < 1u << pairs.pieces; ++bits) {
    Group set;
    for (int k = 0; k < pairs.pieces; ++k) {
      if (bits >> k & 1) set.push_back(k);
    }
    if (set.size() <= kLargest) of_size[set.size()].push_back(set);
  }
  std::set<Group> grown;
  for (int seed = 0; seed < pairs.pieces; ++seed) {
    std::set<Group> kept{{seed}};
    grown.insert({seed});
    for (std::size_t size = 2; size <= kLargest; ++size) {
      std::vector<std::pair<float, Group>> next;
      for (const Group& set : of_size[size]) {
        const bool reached = std::any_of(set.begin(), set.end(), [&](int k) {
          return pairs.strongest(set, k) >= kLinked && kept.count(without(set, k)) > 0;
        });
        if (reached) next.emplace_back(-pairs.sum(set), set);
      }
      std::sort(next.begin(), next.end());
      next.resize(std::min(next.size(), beam));
      kept.clear();
      for (const auto& [value, set] : next) kept.insert(set);
      grown.insert(kept.begin(), kept.end());
    }
  }
  std::set<Group> all = grown;
  for (const Group& group : grown) {
    for (int k = 0; k < pairs.pieces; ++k) {
      if (std::count(group.begin(), group.end(), k) == 0) {
        Group larger = group;
        larger.insert(std::upper_bound(larger.begin(), larger.end(), k), k);
        if (pairs.strongest(group, k) > kWellLinked) all.insert(larger);
      } else if (group.size() > 2) {
        const Group smaller = without(group, k);
        const bool linked = std::all_of(smaller.begin(), smaller.end(),
                                        [&](int other) { return pairs.strongest(smaller, other) >= kLinked; });
        if (linked) all.insert(smaller);
      }
    }
  }
  return {all.begin(), all.end()};
}

}  // namespace

TEST(GrownGroups, AreThoseOfABeamOfFour) {
  std::mt19937 random(7);
  for (int round = 0; round < 5; ++round) {
    const Pairs pairs = randomPairs(12, random);
    const std::vector<Group> groups = proposeGroups(12, linksOf(pairs), {100000, 100000}, {false, true});
    EXPECT_EQ(groups, plainGrown(pairs, 4));
    EXPECT_NE(groups, plainGrown(pairs, 3)) << "the width of the beam must count here";
    EXPECT_NE(groups, plainGrown(pairs, 5));
  }
}
