// SPDX-License-Identifier: BSD-3-Clause
#include "segments/whole_boxes.hpp"

#include <algorithm>
#include <cmath>

#include "common/angles.hpp"
#include "common/parallel.hpp"
#include "common/share_below.hpp"
#include "segments/box_axes.hpp"
#include "segments/leaning_slab.hpp"
#include "segments/plan_rectangle.hpp"
#include "segments/round_fit.hpp"
#include "segments/seen_space.hpp"
#include "segments/supports.hpp"

namespace objectness {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::size_t kMinPoints = 20;  // with fewer the box of what is seen is all there is
constexpr double kMinSizeM = 0.005;

// How much better an axis must explain the normals than faces at right angles do, and how well the radii agree, in
// logarithms; chosen on simulated scenes of both sensors.
constexpr double kTurnWeight = 5, kSpreadWeight = 3, kLeastTurnDeg = 2, kLeastSpread = 0.3;
constexpr double kMaxFreeShare = 0.2;  // of a circle that is seen to be empty
constexpr int kCircle = 24;            // places on it
constexpr double kInsideM = 0.006;     // so far within its rim
constexpr double kMaxWider = 2;        // a circle may be this much wider than what is seen
constexpr double kMaxPastSide = 0.1;   // of it, past a side that nothing hides
constexpr double kMaxPastFoot = 0.25;  // of one that widens to its foot, which is seen in part
// What lies beyond the circle: a handle, or a sign that the thing is not round.
constexpr double kMinBeyond = 0.03, kMaxBeyond = 0.3, kMinOneSided = 0.8, kSureScore = 1.5;

constexpr double kMaxContinued = 1.2;  // of the other side
constexpr double kPastM = 0.012;       // past a side: is it its end?
constexpr double kStepM = 0.005, kBelowTopM = 0.003;
constexpr int kPlaces = 5;  // along a side
constexpr double kMinEnd = 0.5, kMaxTaken = 0.4;
constexpr int kMinHidden = 3;  // of kPlaces

/// A whole box in the table frame.
struct Whole {
  OrientedBox box;
  bool round = false;
};

OrientedBox uprightBox(const PlanRectangle& rectangle, const SeenThing& thing) {
  OrientedBox box;
  const Vector2d centre = rectangle.toPlan(0.5 * (rectangle.low + rectangle.high));
  box.T_camera_box.rotate(Eigen::AngleAxisd(rectangle.yaw_rad, Vector3d::UnitZ()));
  box.T_camera_box.translation() << centre, 0.5 * (thing.base_m + thing.top_m);
  box.size_m << rectangle.high - rectangle.low, thing.height();
  box.size_m = box.size_m.cwiseMax(kMinSizeM);
  return box;
}

/// Whether a circle is as wide as what is seen of the thing, across the view, or wider where others hide it.
bool fitsWidth(const RoundFit& fit, const SeenThing& thing, const SeenSpace& space) {
  const Vector2d away = fit.axis - thing.eye.head<2>().cast<double>();
  const Vector2d across = Vector2d(-away.y(), away.x()).normalized();
  std::vector<float> values;
  for (const SeenPoint& q : thing.points) {
    values.push_back(static_cast<float>(across.dot(q.place.head<2>().cast<double>() - fit.axis)));
  }
  const double low = shareBelow(0.005, values), high = shareBelow(0.995, values);
  const double diameter_m = 2 * fit.radius_m;
  if (diameter_m >= kMaxWider * (high - low)) return false;
  const double past_m = diameter_m * (fit.widest_m > thing.base_m ? kMaxPastSide : kMaxPastFoot);
  for (const auto& [side, seen_m] : {std::pair{-1, -low}, {1, high}}) {
    if (fit.radius_m - seen_m < past_m) continue;
    int hidden = 0;
    for (int i = 1; i <= kPlaces; ++i) {
      const Vector2d rim = fit.axis + side * 0.5 * (seen_m + fit.radius_m) * across;
      hidden += space.at({rim.x(), rim.y(), thing.base_m + i * thing.height() / (kPlaces + 1)}) == Seen::kBehindOther;
    }
    if (hidden < kMinHidden) return false;
  }
  return true;
}

bool isFree(const RoundFit& fit, const SeenThing& thing, const SeenSpace& space) {
  const double radius_m = std::max(0.5 * fit.radius_m, fit.radius_m - kInsideM);
  const double z = std::clamp(fit.widest_m, std::min(thing.base_m + 0.01, thing.top_m), thing.top_m);
  int free = 0;
  for (int i = 0; i < kCircle; ++i) {
    const double angle = 2 * kPi * i / kCircle;
    const Vector3d rim(radius_m * std::cos(angle), radius_m * std::sin(angle), 0);
    free += space.at(Vector3d(fit.axis.x(), fit.axis.y(), z) + rim) == Seen::kFree;
  }
  return free > kMaxFreeShare * kCircle;
}

std::optional<Whole> roundThing(const SeenThing& thing, const FaceDirection& faces, const SeenSpace& space) {
  const auto fit = fitRound(thing);
  if (!fit) return {};
  const double score = -kTurnWeight * std::log(std::max(1e-3, fit->turn_deg) / (faces.turn_deg + kLeastTurnDeg)) -
                       kSpreadWeight * std::log(std::max(kLeastSpread, fit->spread_m / thing.sigma_m));
  const bool one_sided = fit->beyond > kMinBeyond && fit->one_sided > kMinOneSided;
  if (score <= (one_sided ? kSureScore : 0)) return {};
  if (!fitsWidth(*fit, thing, space)) return {};
  if (isFree(*fit, thing, space)) return {};
  const bool body = one_sided && fit->beyond < kMaxBeyond;
  const Vector2d x = body ? fit->to_beyond : Vector2d(fit->axis - thing.eye.head<2>().cast<double>());
  PlanRectangle square;
  square.yaw_rad = std::atan2(x.y(), x.x());
  const Vector2d axis = square.toOwn(fit->axis);
  square.low = axis - Vector2d::Constant(fit->radius_m);
  square.high = axis + Vector2d::Constant(fit->radius_m);
  if (body) square.high.x() = std::max(square.high.x(), axis.x() + fit->reach_m);
  return Whole{uprightBox(square, thing), !body};
}

/// What is seen along a line across a side, kPlaces places of it.
struct Sides {
  int taken = 0;   ///< free, or of others
  int hidden = 0;  ///< behind others
};

Sides lookAlong(const PlanRectangle& rectangle, int axis, double at, double z, const SeenSpace& space) {
  Sides sides;
  const int other = 1 - axis;
  for (int i = 0; i < kPlaces; ++i) {
    Vector2d own;
    own[axis] = at;
    own[other] =
        rectangle.low[other] + (rectangle.high[other] - rectangle.low[other]) * (0.15 + 0.7 * i / (kPlaces - 1.0));
    const Vector2d plan = rectangle.toPlan(own);
    const Seen seen = space.at({plan.x(), plan.y(), z});
    sides.taken += seen == Seen::kFree || seen == Seen::kOther;
    sides.hidden += seen == Seen::kBehindOther;
  }
  return sides;
}

/// Moves the sides that go on where nobody looks.
PlanRectangle continued(PlanRectangle rectangle, const SeenThing& thing, const SeenSpace& space) {
  const double near_top_m = thing.top_m - kBelowTopM, middle_m = 0.5 * (thing.base_m + thing.top_m);
  for (const int axis : {0, 1}) {
    for (const int side : {-1, 1}) {
      double& end = side < 0 ? rectangle.low[axis] : rectangle.high[axis];
      const Sides past = lookAlong(rectangle, axis, end + side * kPastM, near_top_m, space);
      if (past.taken >= kMinEnd * kPlaces) continue;
      if (thing.level_top && past.hidden < kMinHidden) continue;  // the edge of the top is seen
      const double other = rectangle.high[1 - axis] - rectangle.low[1 - axis];
      double left = kMaxContinued * other - (rectangle.high[axis] - rectangle.low[axis]);
      while (left > 0) {
        const double next = end + side * std::min(left, kStepM);
        if (lookAlong(rectangle, axis, next, near_top_m, space).taken >= kMaxTaken * kPlaces) break;
        if (lookAlong(rectangle, axis, next, middle_m, space).taken >= kMaxTaken * kPlaces) break;
        end = next;
        left -= kStepM;
      }
    }
  }
  return rectangle;
}

Whole wholeThing(const SeenThing& thing, const Table& table, const SeenSpace& space) {
  const FaceDirection faces = faceDirection(thing);
  if (const auto round = roundThing(thing, faces, space)) return *round;
  if (const auto slab = fitLeaningSlab(thing)) {
    const OrientedBox named = nameAxes(*slab);
    OrientedBox box{table.T_table_camera.inverse() * named.T_camera_box, named.size_m};
    restBox(table, thing.base_m, box);
    return {{table.T_table_camera * box.T_camera_box, box.size_m}};
  }
  return {nameAxes(uprightBox(continued(seenRectangle(thing, faces), thing, space), thing))};
}

}  // namespace

void completeBoxes(const Frame& frame, const Normals& normals, const Table& table, const ObjectPoints& above,
                   const cv::Mat_<ushort>& labels, std::vector<Segment>& segments, int threads) {
  const std::vector<Support> supports = findSupports(frame, normals, table, above, segments);
  for (std::size_t k = 0; k < segments.size(); ++k) {
    segments[k].support = supports[k];
    segments[k].carried.clear();
  }
  for (std::size_t k = 0; k < segments.size(); ++k) {
    if (supports[k].segment >= 0) segments[supports[k].segment].carried.push_back(static_cast<int>(k));
  }
  const Eigen::Isometry3d T_camera_table = table.T_table_camera.inverse();
  parallelFor(static_cast<int>(segments.size()), threads, [&](int k) {
    Segment& segment = segments[k];
    segment.visible_box = segment.box;
    const SeenThing thing = seeThing(frame, normals, table, segment.pixels, segment.support.height_m);
    if (thing.points.size() < kMinPoints) {
      restBox(table, segment.support.height_m, segment.box);
      return;
    }
    const Whole whole = wholeThing(thing, table, SeenSpace(frame, table, labels, k + kFirstObjectLabel));
    segment.box = {T_camera_table * whole.box.T_camera_box, whole.box.size_m};
    segment.round = whole.round;
  });
}

}  // namespace objectness
