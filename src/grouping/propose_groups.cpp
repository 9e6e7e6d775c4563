// SPDX-License-Identifier: BSD-3-Clause
#include "grouping/propose_groups.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "common/disjoint_sets.hpp"

namespace objectness {
namespace {

using Group = std::vector<int>;
constexpr float kMinLink = 0.15f;
constexpr std::size_t kBeam = 4;
constexpr std::size_t kMaxGrown = 7;

class Proposer {
 public:
  Proposer(int pieces, const std::vector<Link>& links)
      : count_(pieces), p_(pieces * pieces, 0.f), logit_(pieces * pieces, 0.f) {
    for (int k = 0; k < pieces; ++k) parts_.create();
    for (const Link& link : links) {
      if (link.probability >= kMinLink) parts_.join(link.first, link.second);
      const float p = std::clamp(link.probability, 0.02f, 0.98f), l = std::log(p / (1 - p));
      p_[at(link.first, link.second)] = p_[at(link.second, link.first)] = link.probability;
      logit_[at(link.first, link.second)] = logit_[at(link.second, link.first)] = l;
    }
  }

  std::vector<Group> run(const GroupLimits& limits, const GroupKinds& kinds) {
    for (int k = 0; k < count_; ++k) groups_.insert({k});
    if (kinds.dendrograms) {
      for (const int linkage : {0, 1, 2}) merge(linkage);
    }
    if (kinds.grown) {
      for (int k = 0; k < count_; ++k) grow(k);
      const std::vector<Group> base(groups_.begin(), groups_.end());
      for (const Group& group : base) vary(group);
    }
    return bestOfEachPart(limits);
  }

 private:
  int at(int a, int b) const { return a * count_ + b; }

  /// The groups of a part, by its root: pieces by themselves first, then the best ranked; of equals those that come
  /// first.
  std::map<int, std::vector<const Group*>> rankedByPart() {
    std::map<int, std::vector<std::pair<float, const Group*>>> ranked;
    for (const Group& group : groups_) ranked[parts_.root(group.front())].emplace_back(rank(group), &group);
    std::map<int, std::vector<const Group*>> by_part;
    for (auto& [part, groups] : ranked) {
      std::stable_sort(groups.begin(), groups.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
      for (const auto& [value, group] : groups) by_part[part].push_back(group);
    }
    return by_part;
  }

  std::vector<Group> bestOfEachPart(const GroupLimits& limits) {
    if (groups_.size() <= std::min(limits.of_a_part, limits.of_all)) return {groups_.begin(), groups_.end()};
    const auto by_part = rankedByPart();
    const auto total = [&](std::size_t cap) {
      std::size_t sum = 0;
      for (const auto& [part, groups] : by_part) sum += std::min(groups.size(), cap);
      return sum;
    };
    // The largest cap for each part with which the total holds, too.
    std::size_t low = 0, high = limits.of_a_part;
    while (low < high) {
      const std::size_t middle = low + (high - low + 1) / 2;
      if (total(middle) <= limits.of_all) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    std::vector<Group> best;
    for (const auto& [part, groups] : by_part) {
      for (std::size_t i = 0; i < groups.size() && (i < low || groups[i]->size() == 1); ++i) best.push_back(*groups[i]);
    }
    std::sort(best.begin(), best.end());
    return best;
  }

  float rank(const Group& group) const {
    if (group.size() == 1) return 1e9f;
    return inner(group) / group.size();
  }
  float inner(const Group& group) const {
    float sum = 0;
    for (std::size_t i = 0; i < group.size(); ++i)
      for (std::size_t j = i + 1; j < group.size(); ++j) sum += logit_[at(group[i], group[j])];
    return sum;
  }
  float gain(const Group& group, int k) const {
    float sum = 0;
    for (const int i : group) sum += logit_[at(i, k)];
    return sum;
  }
  float strongest(const Group& group, int k) const {
    float best = 0;
    for (const int i : group) best = std::max(best, p_[at(i, k)]);
    return best;
  }
  static Group with(const Group& group, int k) {
    Group larger = group;
    larger.insert(std::upper_bound(larger.begin(), larger.end(), k), k);
    return larger;
  }

  void merge(int linkage) {
    std::vector<Group> clusters;
    for (int k = 0; k < count_; ++k) clusters.push_back({k});
    while (clusters.size() > 1) {
      float best = linkage == 2 ? kMinLink : -1.f;
      std::size_t bi = 0, bj = 0;
      for (std::size_t i = 0; i < clusters.size(); ++i) {
        for (std::size_t j = i + 1; j < clusters.size(); ++j) {
          float sum = 0, most = 0;
          for (const int a : clusters[i]) {
            for (const int b : clusters[j]) sum += logit_[at(a, b)], most = std::max(most, p_[at(a, b)]);
          }
          if (most < kMinLink) continue;
          const float value = linkage == 0   ? sum
                              : linkage == 1 ? sum / (clusters[i].size() * clusters[j].size())
                                             : most;
          if (value > best) best = value, bi = i, bj = j;
        }
      }
      if (bi == bj) break;
      Group joined;
      std::merge(clusters[bi].begin(), clusters[bi].end(), clusters[bj].begin(), clusters[bj].end(),
                 std::back_inserter(joined));
      groups_.insert(joined);
      clusters[bi] = joined;
      clusters.erase(clusters.begin() + bj);
    }
  }

  void grow(int seed) {
    std::vector<Group> beam{{seed}};
    for (std::size_t size = 2; size <= kMaxGrown && !beam.empty(); ++size) {
      std::set<std::pair<float, Group>> next;
      for (const Group& group : beam) {
        for (int k = 0; k < count_; ++k) {
          if (std::binary_search(group.begin(), group.end(), k) || strongest(group, k) < kMinLink) continue;
          const Group larger = with(group, k);
          next.insert({-inner(larger), larger});
        }
      }
      beam.clear();
      for (const auto& [value, group] : next) {
        if (beam.size() == kBeam) break;
        beam.push_back(group);
        groups_.insert(group);
      }
    }
  }

  void vary(const Group& group) {
    if (group.size() > 2) {
      for (std::size_t i = 0; i < group.size(); ++i) {
        Group smaller = group;
        smaller.erase(smaller.begin() + i);
        bool connected = true;
        for (const int k : smaller) connected &= strongest(smaller, k) >= kMinLink;
        if (connected) groups_.insert(smaller);
      }
    }
    for (int k = 0; k < count_; ++k) {
      if (!std::binary_search(group.begin(), group.end(), k) && strongest(group, k) > 0.3f)
        groups_.insert(with(group, k));
    }
  }

  int count_;
  std::vector<float> p_, logit_;
  std::set<Group> groups_;
  DisjointSets parts_;
};

}  // namespace

std::vector<std::vector<int>> proposeGroups(int pieces, const std::vector<Link>& links, const GroupLimits& limits,
                                            const GroupKinds& kinds) {
  return Proposer(pieces, links).run(limits, kinds);
}

}  // namespace objectness
