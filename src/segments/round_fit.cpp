// SPDX-License-Identifier: BSD-3-Clause
#include "segments/round_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "common/angles.hpp"
#include "common/share_below.hpp"

namespace objectness {
namespace {

using Eigen::Vector2d;

constexpr float kWall = 0.35f;  // least part of a normal along the table
constexpr std::size_t kMinPoints = 25, kMinPairs = 10;
constexpr int kRounds = 8;  // of reweighting
constexpr double kFirstScaleM = 0.02, kLastScaleM = 0.004, kShrink = 0.7;
constexpr double kRadiusScaleM = 0.003, kNormalScaleM = 0.006, kNormalWeight = 0.3;
constexpr double kPairDzM = 0.01;    // neighbours in height are no farther apart
constexpr double kBounded = 0.3;     // what one point may cost: 1 / kBounded
constexpr std::size_t kTried = 200;  // points that places of the axis are tried with
constexpr double kFirstStepM = 0.008, kLastStepM = 0.0008;
constexpr int kMovesAStep = 4;
constexpr double kShare = 0.7;  // of normals and radii that are no worse than what is told of them
constexpr int kBands = 12;
constexpr std::size_t kMinInBand = 5;
constexpr double kFoot = 0.22;                            // of the height: its rim is blurred into the table
constexpr double kSlopeSpan = 0.25, kMaxContinued = 0.3;  // of the height
constexpr double kMinSlope = 0.15;                        // metres of radius a metre downwards
constexpr double kMostOfAll = 0.9, kMaxGain = 1.1;
constexpr double kBeyondM = 0.006, kReachShare = 0.97;

/// A point of a wall: its height, its place and the direction of its normal in the plan, and how upright it is there.
struct WallPoint {
  double z;
  Vector2d place, normal;
  double upright;
};

/// Cost of an error in units of its scale: bounded, so that a handle does not move the axis.
double bounded(double error) { return error * error / (1 + kBounded * error * error); }

double across(const Vector2d& normal, const Vector2d& v) { return normal.x() * v.y() - normal.y() * v.x(); }

std::vector<WallPoint> wallOf(const SeenThing& thing) {
  std::vector<WallPoint> wall;
  for (const SeenPoint& q : thing.points) {
    if (!q.has_normal || q.upright < kWall) continue;
    wall.push_back({q.place.z(), q.place.head<2>().cast<double>(),
                    q.normal.head<2>().cast<double>() / static_cast<double>(q.upright), q.upright});
  }
  return wall;
}

Vector2d whereNormalsMeet(const std::vector<WallPoint>& wall, const Vector2d& start) {
  Vector2d axis = start;
  double scale_m = kFirstScaleM;
  for (int round = 0; round < kRounds; ++round) {
    Eigen::Matrix2d A = 1e-6 * Eigen::Matrix2d::Identity();
    Vector2d b = 1e-6 * start;
    for (const WallPoint& q : wall) {
      const Vector2d side(-q.normal.y(), q.normal.x());
      const double error = side.dot(axis - q.place) / scale_m;
      const double weight = q.upright * q.upright / (1 + error * error);
      A += weight * side * side.transpose();
      b += weight * side * side.dot(q.place);
    }
    axis = A.ldlt().solve(b);
    scale_m = std::max(kLastScaleM, kShrink * scale_m);
  }
  return axis;
}

/// Calls visit(error) with the difference in radius of neighbours in height, across the surface. Inner and outer walls
/// have radii of their own. wall: in order of height.
template <class Visit>
void comparePairs(const std::vector<WallPoint>& wall, const Vector2d& axis, Visit&& visit) {
  std::array<double, 2> radius{-1, -1}, height{0, 0};
  for (const WallPoint& q : wall) {
    const Vector2d out = q.place - axis;
    const double r = out.norm();
    const int side = out.dot(q.normal) > 0;
    if (radius[side] >= 0 && q.z - height[side] < kPairDzM) visit((r - radius[side]) * q.upright);
    radius[side] = r;
    height[side] = q.z;
  }
}

double costOf(const std::vector<WallPoint>& wall, const Vector2d& axis) {
  double cost = 0;
  comparePairs(wall, axis, [&](double error) { cost += bounded(error / kRadiusScaleM); });
  for (const WallPoint& q : wall) {
    cost += kNormalWeight * bounded(across(q.normal, q.place - axis) * q.upright / kNormalScaleM);
  }
  return cost;
}

/// Moves the axis by ever smaller steps while that lowers the cost.
Vector2d refine(const std::vector<WallPoint>& wall, Vector2d axis) {
  double best = costOf(wall, axis);
  for (double step_m = kFirstStepM; step_m > kLastStepM; step_m /= 2) {
    for (int move = 0; move < kMovesAStep; ++move) {
      Vector2d next = axis;
      for (int i = 0; i < 8; ++i) {
        const Vector2d tried = axis + step_m * Vector2d(std::cos(i * kPi / 4), std::sin(i * kPi / 4));
        const double cost = costOf(wall, tried);
        if (cost < best) best = cost, next = tried;
      }
      if (next == axis) break;
      axis = next;
    }
  }
  return axis;
}

/// Height and median radius of the bands of the outer wall that have points, from below.
std::vector<Vector2d> profileOf(const SeenThing& thing, const std::vector<WallPoint>& wall, const Vector2d& axis) {
  std::array<std::vector<float>, kBands> radii;
  for (const WallPoint& q : wall) {
    const Vector2d out = q.place - axis;
    if (out.dot(q.normal) < 0) continue;
    const int band = static_cast<int>((q.z - thing.base_m) / thing.height() * kBands);
    radii[std::clamp(band, 0, kBands - 1)].push_back(static_cast<float>(out.norm()));
  }
  std::vector<Vector2d> profile;
  for (int band = 0; band < kBands; ++band) {
    if (radii[band].size() < kMinInBand) continue;
    profile.emplace_back(thing.base_m + (band + 0.5) * thing.height() / kBands, shareBelow(0.5, radii[band]));
  }
  return profile;
}

/// Radius that the wall has at its foot when it goes on as it does above, 0 where it does not widen.
double radiusAtFoot(const SeenThing& thing, const std::vector<Vector2d>& profile) {
  std::vector<float> slopes;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    for (std::size_t j = i + 1; j < profile.size(); ++j) {
      if (profile[j].x() > profile[0].x() + kSlopeSpan * thing.height()) break;
      slopes.push_back(static_cast<float>((profile[i].y() - profile[j].y()) / (profile[j].x() - profile[i].x())));
    }
  }
  if (slopes.empty()) return 0;
  const double slope = shareBelow(0.5, slopes);
  if (slope < kMinSlope) return 0;
  return profile[0].y() + slope * std::min(profile[0].x() - thing.base_m, kMaxContinued * thing.height());
}

void measureRadius(const SeenThing& thing, const std::vector<WallPoint>& wall, RoundFit& fit) {
  std::vector<Vector2d> profile = profileOf(thing, wall, fit.axis);
  const auto above = std::find_if(profile.begin(), profile.end(), [&](const Vector2d& band) {
    return band.x() >= thing.base_m + kFoot * thing.height();
  });
  if (profile.end() - above >= 2) profile.erase(profile.begin(), above);
  fit.widest_m = thing.top_m;
  for (const Vector2d& band : profile) {
    if (band.y() > fit.radius_m) fit.radius_m = band.y(), fit.widest_m = band.x();
  }
  const double at_foot = radiusAtFoot(thing, profile);
  if (at_foot > fit.radius_m) fit.radius_m = at_foot, fit.widest_m = thing.base_m;
  // Where only an inner wall or a rim is seen, bands of the outer wall fall short. A handle is no part of the rim.
  std::vector<float> all;
  for (const SeenPoint& q : thing.points) {
    const double radius = (q.place.head<2>().cast<double>() - fit.axis).norm();
    if (fit.radius_m == 0 || radius <= kMaxGain * fit.radius_m) all.push_back(static_cast<float>(radius));
  }
  if (!all.empty()) fit.radius_m = std::max<double>(fit.radius_m, shareBelow(kMostOfAll, all));
}

void measureBeyond(const SeenThing& thing, RoundFit& fit) {
  std::vector<float> distances;
  Vector2d sum = Vector2d::Zero();
  double total = 0;
  for (const SeenPoint& q : thing.points) {
    const Vector2d out = q.place.head<2>().cast<double>() - fit.axis;
    const double distance = out.norm();
    if (distance <= fit.radius_m + kBeyondM) continue;
    distances.push_back(static_cast<float>(distance));
    sum += out;
    total += distance;
  }
  if (distances.empty()) return;
  fit.beyond = static_cast<double>(distances.size()) / static_cast<double>(thing.points.size());
  fit.to_beyond = sum / static_cast<double>(distances.size());
  fit.one_sided = sum.norm() / total;
  fit.reach_m = shareBelow(kReachShare, distances);
}

}  // namespace

std::optional<RoundFit> fitRound(const SeenThing& thing) {
  std::vector<WallPoint> wall = wallOf(thing);
  if (wall.size() < kMinPoints) return {};
  Vector2d centre = Vector2d::Zero();
  for (const SeenPoint& q : thing.points) centre += q.place.head<2>().cast<double>();
  centre /= static_cast<double>(thing.points.size());

  std::stable_sort(wall.begin(), wall.end(), [](const WallPoint& a, const WallPoint& b) { return a.z < b.z; });
  std::vector<WallPoint> some;
  const std::size_t step = 1 + wall.size() / kTried;
  for (std::size_t i = 0; i < wall.size(); i += step) some.push_back(wall[i]);
  RoundFit fit;
  fit.axis = refine(some, whereNormalsMeet(some, centre));

  std::vector<float> errors, turns;
  comparePairs(wall, fit.axis, [&](double error) { errors.push_back(static_cast<float>(std::abs(error))); });
  if (errors.size() < kMinPairs) return {};
  fit.spread_m = shareBelow(kShare, errors);
  for (const WallPoint& q : wall) {
    const Vector2d out = q.place - fit.axis;
    const double sine = std::abs(across(q.normal, out)) / std::max(1e-6, out.norm());
    turns.push_back(static_cast<float>(std::asin(std::min(1.0, sine)) / kDegree));
  }
  fit.turn_deg = shareBelow(kShare, turns);
  measureRadius(thing, wall, fit);
  measureBeyond(thing, fit);
  return fit;
}

}  // namespace objectness
