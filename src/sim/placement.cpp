// SPDX-License-Identifier: BSD-3-Clause
#include "sim/placement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "common/angles.hpp"

namespace objectness::sim {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kFar_m = 1;  // two things this far from each other have a gap
constexpr int kBisections = 50;
constexpr double kMostOffset = 0.15;  // of what is stacked from its support's middle, as a share of the support's width
constexpr double kMostOverhang = 1.3;  // of its width over the support's
constexpr double kMostFlushOffset_m = 0.003, kHighestStack_m = 0.45;
constexpr double kWallMargin_m = 0.001;                    // of what lies in a bowl from the bowl's wall
constexpr double kLeastLean_deg = 58, kMostLean_deg = 80;  // from the table
// A slab that touches its support at a smaller share of its length would tip over it.
constexpr double kLeastContact = 0.55;

// What rolls off a box, or lies on it by a small part of its length.
const std::set<std::string> kUnsteady{"sphere", "fruit",       "lying can", "marker",
                                      "pen",    "screwdriver", "hammer",    "banana"};
// What is piled up in line with others of its kind.
const std::set<std::string> kPiled{"box", "packet", "cylinder", "can"};

Vector2d direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

double yawOf(const Placed& placed) {
  const Vector3d x = placed.T_world_thing.linear().col(0);
  return std::atan2(x.y(), x.x());
}

}  // namespace

Placed place(const Thing& thing, const Isometry3d& T_world_thing) {
  Placed placed{thing, T_world_thing, true, {}};
  placed.upright = T_world_thing.linear()(2, 2) > 1 - 1e-9;
  for (const Part& part : thing.parts) {
    const Eigen::AlignedBox3d box = sim::bounds(part.shape);
    placed.bounds.push_back({T_world_thing * part.T_thing_part * Eigen::Translation3d(box.center()), box.sizes() / 2,
                             std::holds_alternative<Revolution>(part.shape)});
  }
  return placed;
}

Placed place(const Thing& thing, const Vector2d& position, double z, double yaw) {
  return place(thing, Isometry3d(Eigen::Translation3d(position.x(), position.y(), z) *
                                 Eigen::AngleAxisd(yaw, Vector3d::UnitZ())));
}

double gap(const Placed& a, const Placed& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const ConvexBound& one : a.bounds) {
    for (const ConvexBound& other : b.bounds) least = std::min(least, separation(one, other));
  }
  return least;
}

Placed placeBeside(const Thing& thing, double yaw, const Placed& neighbour, double angle, double gap_m) {
  const auto at = [&](double s) { return place(thing, Vector2d(neighbour.position() + s * direction(angle)), 0, yaw); };
  double near = 0, far = kFar_m;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = (near + far) / 2;
    (gap(at(middle), neighbour) >= gap_m ? far : near) = middle;
  }
  return at(far);
}

std::optional<Placed> placeOn(const Thing& thing, const Placed& support, Random& random) {
  const Vector2d& top = support.thing.top_half;
  const Vector3d size = thing.box().sizes();
  if (!support.upright || kUnsteady.count(thing.kind) ||
      size.head<2>().minCoeff() / 2 > kMostOverhang * top.minCoeff() ||
      size.head<2>().maxCoeff() / 2 > kMostOverhang * top.maxCoeff()) {
    return {};
  }
  const bool crosswise = (size.x() < size.y()) != (top.x() < top.y());
  const double x = 2 * top.x() * random.uniform(-kMostOffset, kMostOffset);
  const double y = 2 * top.y() * random.uniform(-kMostOffset, kMostOffset);
  const double yaw = yawOf(support) + (crosswise ? kPi / 2 : 0) + random.uniform(-0.25, 0.25);
  const Vector2d offset = Eigen::Rotation2Dd(yawOf(support)) * Vector2d(x, y);
  return place(thing, Vector2d(support.position() + offset), support.top_z(), yaw);
}

std::optional<Placed> placeFlush(const Placed& support, Random& random) {
  const Thing& thing = support.thing;
  const double x = random.uniform(-kMostFlushOffset_m, kMostFlushOffset_m);
  const double y = random.uniform(-kMostFlushOffset_m, kMostFlushOffset_m);
  const bool exact = random.chance(0.5);
  if (!kPiled.count(thing.kind) || !support.upright || support.top_z() + thing.height() > kHighestStack_m) return {};
  const Vector2d offset = exact ? Vector2d(0, 0) : Vector2d(x, y);
  return place(thing, Vector2d(support.position() + offset), support.top_z(), yawOf(support));
}

std::optional<Placed> placeWithin(const Thing& thing, const Placed& support, Random& random) {
  const double share = std::sqrt(random.uniform(0, 1)), angle = random.uniform(-kPi, kPi);
  const double yaw = random.uniform(-kPi, kPi);
  if (!support.upright || !support.thing.hollow) return {};
  const Hollow& hollow = *support.thing.hollow;
  const Eigen::AlignedBox3d box = thing.box();
  double room_m = hollow.floor_radius - kWallMargin_m;
  if (thing.kind == "fruit" && hollow.ball_radius > 0) {
    const double radius = box.sizes().z() / 2, below_m = hollow.ball_z - hollow.floor_z - radius;
    const double free_m = hollow.ball_radius - kWallMargin_m - radius;
    if (free_m < std::abs(below_m)) return {};
    room_m = std::min(room_m, std::sqrt(free_m * free_m - below_m * below_m));
  } else {
    const bool round = thing.parts.size() == 1 && std::holds_alternative<Revolution>(thing.parts.front().shape);
    room_m -= round ? box.max().x() : box.max().cwiseAbs().cwiseMax(box.min().cwiseAbs()).head<2>().norm();
  }
  if (room_m < 0) return {};
  const Vector2d offset = room_m * share * direction(angle);
  const double floor_z = support.T_world_thing.translation().z() + hollow.floor_z;
  return place(thing, Vector2d(support.position() + offset), floor_z, yaw);
}

std::optional<Placed> placeLeaning(const Thing& slab, const Placed& support, Random& random) {
  const bool is_box = support.thing.kind == "box";
  if (!support.upright || support.T_world_thing.translation().z() != 0 || !(is_box || support.thing.kind == "cylinder"))
    return {};
  const Vector3d half = support.thing.box().sizes() / 2, size = slab.box().sizes();
  const int side = random.integer(0, 3);
  const double angle = is_box ? yawOf(support) + side * kPi / 2 : random.uniform(-kPi, kPi);
  const double face_m = is_box && side % 2 == 1 ? half.y() : half.x();  // its distance from the middle
  const double half_width = is_box ? (side % 2 == 1 ? half.x() : half.y()) : size.x() / 2;
  const double sideways = random.uniform(-0.4, 0.4) * half_width;
  const double lean = random.uniform(kLeastLean_deg, kMostLean_deg) * kPi / 180;
  const double height = support.thing.height(), length = size.z(), thickness = size.y();

  const bool on_edge = length * std::sin(lean) > height;  // of the support
  if (on_edge && height / std::sin(lean) < kLeastContact * length) return {};
  if (length * std::cos(lean) < 1.2 * thickness * std::sin(lean)) return {};          // would fall over backwards
  const double foot_m = on_edge ? height / std::tan(lean) : length * std::cos(lean);  // from the face

  Vector3d out(0, 0, 0), along(0, 0, 1);
  out.head<2>() = direction(angle);
  const Vector3d tangent = along.cross(out);
  const Vector3d y = std::sin(lean) * out + std::cos(lean) * along;   // across the slab, away from the support
  const Vector3d z = -std::cos(lean) * out + std::sin(lean) * along;  // up the slab
  Vector3d foot = (face_m + foot_m) * out + sideways * tangent;
  foot.head<2>() += support.position();
  Isometry3d pose = Isometry3d::Identity();
  pose.linear() << y.cross(z), y, z;
  pose.translation() = foot + thickness / 2 * y;
  return place(slab, pose);
}

}  // namespace objectness::sim
