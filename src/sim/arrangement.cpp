// SPDX-License-Identifier: BSD-3-Clause
#include "sim/arrangement.hpp"

#include <algorithm>
#include <cmath>

#include "common/angles.hpp"

namespace objectness::sim {
namespace {

using Eigen::Vector2d;

constexpr int kTries = 60;  // to put down one thing
constexpr double kTableMargin_m = 0.01, kStageMargin_m = 0.002;
constexpr double kMaxTouchingGap_m = 0.002;
constexpr double kMaxGapBehind_m = 0.1, kMaxAside_deg = 25;
// What touches by construction is apart by this much of rounding at most.
constexpr double kRounding_m = 1e-9;
constexpr double kAnyGap_m = 1;  // what lies in a bowl is clear of it by construction, within its bound

/// One thing at a time; everything placed so far is in placed_.
class Arranger {
 public:
  Arranger(const Level& level, const Area& area, Random& random) : level_(level), area_(area), random_(random) {}

  bool putDown(double Level::Chances::*how) {
    for (int i = 0; i < kTries; ++i) {
      const std::optional<Placed> candidate = propose(how);
      if (!candidate) continue;
      placed_.push_back(*candidate);
      return true;
    }
    return false;
  }
  const std::vector<Placed>& placed() const { return placed_; }

 private:
  /// Nothing when this try does not fit.
  std::optional<Placed> propose(double Level::Chances::*how) {
    const double yaw = random_.uniform(-kPi, kPi);
    if (how == &Level::Chances::apart) {
      const Thing thing = drawThing();
      const Placed candidate = place(thing, drawPosition(), 0, yaw);
      return fits(candidate, nullptr, 0) ? std::optional(candidate) : std::nullopt;
    }
    const Placed& other = placed_[random_.integer(0, static_cast<int>(placed_.size()) - 1)];
    if (how == &Level::Chances::behind) {
      const double aside = random_.uniform(-kMaxAside_deg, kMaxAside_deg) * kPi / 180;
      const double gap_m = random_.uniform(level_.min_gap_m, kMaxGapBehind_m);
      const Placed candidate =
          placeBeside(drawThing(), yaw, other, area_.viewpoint.bearing(other.position()) + aside, gap_m);
      return fits(candidate, nullptr, 0) ? std::optional(candidate) : std::nullopt;
    }
    if (how == &Level::Chances::beside) return proposeBeside(yaw, other);
    if (how == &Level::Chances::within) {
      const std::optional<Placed> candidate =
          placeWithin(makeThing(random_.pick(level_.fillings), random_), other, random_);
      return candidate && fits(*candidate, &other, -kAnyGap_m) ? candidate : std::nullopt;
    }
    const std::optional<Placed> candidate = how == &Level::Chances::flush ? placeFlush(other, random_)
                                            : how == &Level::Chances::on
                                                ? placeOn(drawThing(), other, random_)
                                                : placeLeaning(makeSlab(random_), other, random_);
    return candidate && fits(*candidate, &other, -kRounding_m) ? candidate : std::nullopt;
  }

  std::optional<Placed> proposeBeside(double yaw, const Placed& other) {
    const Thing thing = drawThing();
    const bool parallel = random_.chance(0.5);  // faces side by side
    const double angle = random_.uniform(-kPi, kPi), gap_m = random_.uniform(0, kMaxTouchingGap_m);
    if (!thing.tight_sides || !other.thing.tight_sides || !other.upright) return {};
    const Eigen::Vector3d x = other.T_world_thing.linear().col(0);
    const Placed candidate = placeBeside(thing, parallel ? std::atan2(x.y(), x.x()) : yaw, other, angle, gap_m);
    // The bounds of handles are not tight: what is nearest must be the bodies.
    const bool touches = separation(candidate.bounds.front(), other.bounds.front()) <= kMaxTouchingGap_m;
    return touches && fits(candidate, &other, 0) ? std::optional(candidate) : std::nullopt;
  }

  Thing drawThing() { return makeThing(random_.pick(level_.kinds), random_); }

  Vector2d drawPosition() {
    if (area_.stage) {
      const double x = random_.uniform(-1, 1), y = random_.uniform(-1, 1);
      return (area_.stage->T_world_stage * Eigen::Vector3d(x * area_.stage->half.x(), y * area_.stage->half.y(), 0))
          .head<2>();
    }
    const double r = area_.radius_m * std::sqrt(random_.uniform(0, 1)), angle = random_.uniform(-kPi, kPi);
    return area_.viewpoint.target.head<2>() + r * Vector2d(std::cos(angle), std::sin(angle));
  }

  /// On the table, in view, and with the level's gap to everything but `partner`.
  bool fits(const Placed& candidate, const Placed* partner, double gap_to_partner_m) const {
    for (const ConvexBound& bound : candidate.bounds) {
      for (const Eigen::Vector3d& corner : bound.corners()) {
        if (!area_.covers(corner)) return false;
      }
    }
    if (!isInView(candidate, area_.viewpoint, area_.camera)) return false;
    return std::all_of(placed_.begin(), placed_.end(), [&](const Placed& other) {
      return gap(candidate, other) >= (&other == partner ? gap_to_partner_m : level_.min_gap_m);
    });
  }

  const Level& level_;
  const Area& area_;
  Random& random_;
  std::vector<Placed> placed_;
};

using Way = double Level::Chances::*;
const Way kWays[] = {&Level::Chances::apart,   &Level::Chances::behind, &Level::Chances::beside, &Level::Chances::on,
                     &Level::Chances::leaning, &Level::Chances::flush,  &Level::Chances::within};

Way drawWay(const Level::Chances& chances, Random& random) {
  double sum = 0;
  for (const Way way : kWays) sum += chances.*way;
  double left = random.uniform(0, sum);
  for (const Way way : kWays) {
    if (left < chances.*way) return way;
    left -= chances.*way;
  }
  return &Level::Chances::apart;
}

/// The way but `apart` with the largest chance; `apart` when there is none.
Way characteristicWay(const Level::Chances& chances) {
  const Way best =
      *std::max_element(std::begin(kWays) + 1, std::end(kWays), [&](Way a, Way b) { return chances.*a < chances.*b; });
  return chances.*best > 0 ? best : &Level::Chances::apart;
}

}  // namespace

bool Area::covers(const Eigen::Vector3d& point) const {
  return stage ? stage->holds(point, kStageMargin_m) : table.covers(point.head<2>(), kTableMargin_m);
}

std::vector<Placed> arrange(const Level& level, int count, const Area& area, Random& random) {
  Arranger arranger(level, area, random);
  for (int i = 0; i < count; ++i) {
    const Way way = i == 0   ? &Level::Chances::apart
                    : i == 1 ? characteristicWay(level.chances)
                             : drawWay(level.chances, random);
    if (arranger.putDown(way)) continue;
    if (i <= 1 || !arranger.putDown(&Level::Chances::apart)) break;
  }
  return arranger.placed();
}

}  // namespace objectness::sim
