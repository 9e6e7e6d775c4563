// SPDX-License-Identifier: BSD-3-Clause
#include "selection/bit_cost.hpp"

#include <algorithm>

#include "selection/cost_change.hpp"

namespace objectness {

BitCost::BitCost(const BitProblem& problem, const SelectionConfig& config)
    : problem_(problem),
      config_(config),
      words_(problem.layout.words()),
      none_(words_, ~std::uint64_t{0}),
      one_(words_, 0),
      two_(words_, 0),
      active_(problem.hypotheses.size(), false),
      settled_(problem.hypotheses.size()) {
  held_.bits.assign(words_, 0);
  beside_.bits.assign(words_, 0);
  for (const BitHypothesis& h : problem.hypotheses) {
    points_.push_back(
        countCommon(h.inside.words.data(), h.inside.words.data(), h.inside.groups, problem.layout.group_words));
  }
}

double BitCost::flipDelta(int i) const {
  if (last_.box != i) last_ = {i, countDelta(i)};
  return last_.delta;
}

double BitCost::countDelta(int i) const {
  const BitHypothesis& h = problem_.hypotheses[i];
  const int group_words = problem_.layout.group_words;
  const bool leaves = active_[i];
  const HeldCounts in =
      countHeld(h.inside.words.data(), h.inside.groups, group_words, sets(), counters(beside_), leaves ? 1 : 0);
  const long more = points_[i] - in.none - in.one - in.two;
  const long around = countCommon(h.surroundings.words.data(), none_.data(), h.surroundings.groups, group_words);
  CostChange change;
  change.step = leaves ? -1 : 1;
  // A point's second box makes it count twice, each further one once more.
  change.multiple = leaves ? -(2L * in.two + more) : 2L * in.one + in.two + more;
  change.unexplained = leaves ? in.unexplained - around : around - in.unexplained;
  const long own = leaves ? -in.one : in.none;
  // Points that the others lose to this box, or win from it.
  const std::uint64_t* contested = leaves ? two_.data() : one_.data();
  bool own_added = false;
  for (const int j : actives_) {
    if (!own_added && j >= i) {
      change.objectness += h.objectness * static_cast<double>(own);
      own_added = true;
    }
    const PointBits& other = problem_.hypotheses[j].inside;
    const std::uint64_t groups = in.shared & other.groups;
    if (j == i || groups == 0) continue;
    const long shared = countCommon(h.inside.words.data(), other.words.data(), contested, groups, group_words);
    if (shared != 0)
      change.objectness += problem_.hypotheses[j].objectness * static_cast<double>(leaves ? shared : -shared);
  }
  if (!own_added) change.objectness += h.objectness * static_cast<double>(own);
  return costOf(change, h.free_space, config_);
}

void BitCost::adjust(const PointBits& set, bool add, int most, Planes& planes) {
  while (most >> planes.count != 0) {
    planes.bits.resize(planes.bits.size() + words_, 0);
    ++planes.count;
  }
  (add ? increment : decrement)(set.words.data(), set.groups, problem_.layout.group_words, planes.count, words_,
                                planes.bits.data());
}

void BitCost::toggle(int i) {
  last_.box = -1;
  const BitHypothesis& h = problem_.hypotheses[i];
  const bool add = !active_[i];
  const auto at = std::lower_bound(actives_.begin(), actives_.end(), i);
  if (add) {
    actives_.insert(at, i);
  } else {
    actives_.erase(at);
  }
  active_[i] = add;
  const int most = static_cast<int>(actives_.size());
  adjust(h.inside, add, most, held_);
  findHeld(counters(held_), h.inside.groups, problem_.layout.group_words, none_.data(), one_.data(), two_.data());
  adjust(h.surroundings, add, most, beside_);
}

double BitCost::flip(int i) {
  const double delta = flipDelta(i);
  toggle(i);
  cost_ += delta;
  return delta;
}

void BitCost::undo(const std::vector<int>& flips, double cost) {
  for (const int i : flips) toggle(i);
  cost_ = cost;
}

bool BitCost::share(int i, int j) const {
  const PointBits &a = problem_.hypotheses[i].inside, &b = problem_.hypotheses[j].inside;
  const std::uint64_t groups = a.groups & b.groups;
  return groups != 0 && haveCommon(a.words.data(), b.words.data(), groups, problem_.layout.group_words);
}

std::vector<int> BitCost::rivals(int i, bool active) const {
  std::vector<int> found;
  if (active) {
    for (const int j : actives_) {
      if (j != i && share(i, j)) found.push_back(j);
    }
    return found;
  }
  for (int j = 0; j < size(); ++j) {
    if (j != i && !active_[j] && share(i, j)) found.push_back(j);
  }
  return found;
}

std::uint64_t BitCost::reach(int i) const {
  return problem_.hypotheses[i].inside.groups | problem_.hypotheses[i].surroundings.groups;
}

bool BitCost::settled(int i) const {
  if (!settled_[i].is) return false;
  for (std::size_t k = settled_[i].changes; k < changes_.size(); ++k) {
    if (changes_[k] & settled_[i].groups) return false;
  }
  return true;
}

void BitCost::settle(int i) {
  // A takeover flips the active rivals, too, a swap each of the others that could come in.
  std::uint64_t groups = reach(i);
  for (const int j : rivals(i, !active_[i])) groups |= reach(j);
  settled_[i] = {changes_.size(), groups, true};
}

void BitCost::changed(const std::vector<int>& flips) {
  std::uint64_t groups = 0;
  for (const int i : flips) groups |= reach(i);
  changes_.push_back(groups);
}

}  // namespace objectness
