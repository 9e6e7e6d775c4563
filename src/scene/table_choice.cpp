// SPDX-License-Identifier: BSD-3-Clause
#include "scene/table_choice.hpp"

#include <algorithm>
#include <cmath>

#include "common/parallel.hpp"

namespace objectness {
namespace {

constexpr double kMinLegsM = 0.3, kMinTableM2 = 0.15;  // of a table that stands on a floor
constexpr int kMinCarried = 50;
constexpr double kFloorWeight = 0.6;

}  // namespace

TableChoice::TableChoice(const SurfaceSamples& samples, double focal, const std::vector<Plane>& planes,
                         const TableConfig& config)
    : samples_(samples),
      focal_(focal),
      planes_(planes),
      config_(config),
      seen_(planes.size()),
      under_(planes.size()),
      judged_(planes.size(), 0) {}

bool TableChoice::isTilted(int plane) const {
  if (!config_.up_known) return false;
  const Eigen::Vector3d up(config_.up_x, config_.up_y, config_.up_z);
  return planes_[plane].normal.dot(up.normalized()) < std::cos(config_.max_tilt_deg * M_PI / 180);
}

int TableChoice::tilted() const {
  int count = 0;
  for (std::size_t i = 0; i < planes_.size(); ++i) count += isTilted(static_cast<int>(i));
  return count;
}

double TableChoice::largest_m2() const {
  double largest = 0;
  for (const SeenPlane& seen : seen_) largest = std::max(largest, seen.evidence.area_m2);
  return largest;
}

bool TableChoice::mayBeTable(int plane) const {
  const TableEvidence& evidence = seen_[plane].evidence;
  const double hidden_m2 = evidence.area_m2 > 0 && !under_[plane].empty() ? evidence.hidden_m2 : 0;
  return !isTilted(plane) && evidence.area_m2 + hidden_m2 >= config_.min_area_m2;
}

void TableChoice::see(int threads) {
  const int count = static_cast<int>(planes_.size());
  parallelFor(count, threads, [&](int i) {
    if (!isTilted(i)) seen_[i] = seePlane(samples_, planes_[i]);
  });
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < count; ++k) {
      const bool large = seen_[k].evidence.area_m2 >= config_.min_area_m2;
      if (k != i && large && liesUnder(planes_[k], planes_[i], seen_[i].middle)) under_[i].push_back(k);
    }
  }
}

void TableChoice::judge(int plane) {
  seen_[plane].evidence = judgeTable(samples_, planes_[plane], seen_[plane], focal_);
  judged_[plane] = 1;
}

/// The top of a thing carries less than what the thing stands on.
bool TableChoice::isTopOfThing(int plane) const {
  const auto carriesMore = [&](int k) { return seen_[k].evidence.carried > seen_[plane].evidence.carried; };
  return std::any_of(under_[plane].begin(), under_[plane].end(), carriesMore);
}

/// A plane well under one that may be a table: what stands on a floor are first of all the table's own legs.
bool TableChoice::isFloor(int plane) const {
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    const TableEvidence& over = seen_[i].evidence;
    if (!judged_[i] || over.seen_m2 < kMinTableM2 || over.carried < kMinCarried) continue;
    const auto& under = under_[i];
    const bool is_under = std::find(under.begin(), under.end(), plane) != under.end();
    if (is_under && planes_[plane].height(seen_[i].middle.cast<float>()) > kMinLegsM) return true;
  }
  return false;
}

int TableChoice::best(int threads) {
  see(threads);
  const int count = static_cast<int>(planes_.size());
  // The most promising plane first: cheap bounds then reject most others.
  std::vector<double> bounds(planes_.size(), 0);
  int first = -1;
  for (int i = 0; i < count; ++i) {
    if (!mayBeTable(i)) continue;
    bounds[i] = seen_[i].evidence.score(planes_[i], !under_[i].empty());
    if (first < 0 || bounds[i] > bounds[first]) first = i;
  }
  if (first < 0) return -1;
  judge(first);
  const double enough = seen_[first].evidence.score(planes_[first]);
  std::vector<char> wanted(planes_.size(), 0);
  const auto judgeWanted = [&] {
    parallelFor(count, threads, [&](int i) {
      if (wanted[i] && !judged_[i]) judge(i);
    });
  };
  for (int i = 0; i < count; ++i) wanted[i] = mayBeTable(i) && bounds[i] >= enough;
  judgeWanted();
  const std::vector<char> candidates = wanted;
  for (int i = 0; i < count; ++i) {
    for (const int k : under_[i]) wanted[k] |= candidates[i];
  }
  judgeWanted();

  // Of what carries more than all that it lies over, the hidden part is no evidence against it: a gripper over a small
  // table does not make the floor one.
  int best = -1;
  double best_score = 0;
  for (int i = 0; i < count; ++i) {
    if (!candidates[i]) continue;
    const bool hidden_counts = !under_[i].empty() && !isTopOfThing(i);
    if (!hidden_counts && seen_[i].evidence.area_m2 < config_.min_area_m2) continue;
    const double score = (isFloor(i) ? kFloorWeight : 1) * seen_[i].evidence.score(planes_[i], hidden_counts);
    if (score > best_score) best_score = score, best = i;
  }
  return best;
}

}  // namespace objectness
