// SPDX-License-Identifier: BSD-3-Clause
#include "sim/around.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "common/angles.hpp"
#include "common/true_labels.hpp"
#include "sim/robot_arm.hpp"

namespace objectness::sim {
namespace {

using Eigen::Vector3d;

constexpr int kTries = 60;
constexpr double kClear_m = 0.015;      // of the arm from things
constexpr double kCameraClear_m = 0.2;  // of the arm from the camera
constexpr double kBoard_m = 0.02, kPost_m = 0.03;

/// Builds in a frame of the table: its middle on the floor, z up.
class Builder {
 public:
  Builder(const Area& area, Random& random)
      : area_(area),
        random_(random),
        table_z_(area.stage ? -area.stage->floor_m : 0),
        floor_z_(table_z_ - area.table.height_m),
        side_(area.viewpoint.T_world_camera.translation().x() > 0 ? -1 : 1) {}

  /// A wall beside the table, over there from the camera.
  void wall() {
    const double x = beside_m_ + random_.uniform(0.05, 0.5);
    box({0.1, 8, 3}, {side_ * (area_.table.width_m / 2 + x + 0.05), 0, 0}, {205, 212, 214});
  }

  void rack() {
    const double depth = random_.uniform(0.28, 0.4), width = random_.uniform(0.6, 1), height = random_.uniform(1, 1.8);
    const double x = side_ * (area_.table.width_m / 2 + random_.uniform(0.06, 0.3) + depth / 2);
    const double y = random_.uniform(-0.15, 0.35);
    beside_m_ = std::abs(x) - area_.table.width_m / 2 + depth / 2;
    const cv::Vec3b metal(150, 150, 155);
    for (const int i : {-1, 1}) {
      for (const int k : {-1, 1}) {
        box({kPost_m, kPost_m, height}, {x + i * (depth - kPost_m) / 2, y + k * (width + kPost_m) / 2, 0}, metal);
      }
    }
    const int boards = random_.integer(3, 4);
    for (int i = 0; i < boards; ++i) {
      const double z = 0.15 + (height - 0.3) * i / (boards - 1);
      box({depth, width, kBoard_m}, {x, y, z}, metal);
      for (const double place : {-0.3, 0.0, 0.3}) {
        if (random_.chance(0.6)) standAt({x, y + place * width, z + kBoard_m}, 0.2);
      }
    }
  }

  /// Another table behind the first. Returns where it ends, from the middle of the first.
  double table() {
    const double width = random_.uniform(0.8, 1.6), depth = random_.uniform(0.5, 0.8);
    const double height = area_.table.height_m + random_.uniform(-0.12, 0.12);
    const double x = random_.uniform(-0.4, 0.4), y = area_.table.depth_m / 2 + random_.uniform(0.08, 0.5) + depth / 2;
    box({width, depth, 0.03}, {x, y, height - 0.03}, {130, 160, 185});
    box({0.1, 0.1, height - 0.03}, {x, y, 0}, {90, 90, 90});
    for (const double place : {-0.35, -0.1, 0.15, 0.38}) {
      if (random_.chance(0.5)) standAt({x + place * width, y - 0.1 * depth, height}, 0.2);
    }
    return y + depth / 2;
  }

  /// Whether there was room for it.
  bool arm(const std::vector<Placed>& things) {
    std::vector<Placed> obstacles = things;
    if (area_.stage) {
      Thing walls{"", {}, false, {0, 0}};
      for (const Body& body : area_.stage->bodies) walls.parts.emplace_back(body.shape, body.T_world_body);
      obstacles.push_back(place(walls, Eigen::Isometry3d::Identity()));
    }
    const double top_z = std::accumulate(things.begin(), things.end(), 0.0, [](double top, const Placed& thing) {
      return std::max(top, thing.bounds.front().corners()[7].z());
    });
    for (int i = 0; i < kTries; ++i) {
      ArmPose pose;
      const double beside = random_.uniform(0.1, 0.25), along = random_.uniform(-0.1, 0.2);
      const double up = random_.uniform(0.25, 0.6), x = random_.uniform(-0.2, 0.2), y = random_.uniform(-0.1, 0.25);
      const double over = random_.uniform(-0.08, 0.3);
      pose.shoulder = {-side_ * (area_.table.width_m / 2 + beside), along, table_z_ + up};
      pose.hand = {area_.viewpoint.target.x() + x, area_.viewpoint.target.y() + y, std::max(0.05, top_z + over)};
      pose.column_m = pose.shoulder.z() - floor_z_;
      pose.elbow_m = random_.uniform(0.1, 0.35);
      pose.hand_turn = random_.uniform(-kPi, kPi);
      const Placed arm = placeArm(pose);
      if (!isClear(arm, obstacles)) continue;
      for (const Part& part : arm.thing.parts) add(part.shape, part.T_thing_part, {225, 225, 228});
      return true;
    }
    return false;
  }

  std::vector<Body> take() { return std::move(bodies_); }

 private:
  void add(const Shape& shape, const Eigen::Isometry3d& T_world_body, const cv::Vec3b& color) {
    bodies_.push_back({shape, T_world_body, color, static_cast<ushort>(kAroundLabel)});
  }
  /// position: centre of the base, over the floor.
  void box(const Vector3d& size, const Vector3d& position, const cv::Vec3b& color) {
    add(Box{size}, moved(position.x(), position.y(), position.z() + floor_z_), color);
  }
  /// A thing not wider than that.
  void standAt(const Vector3d& position, double width) {
    const std::vector<std::string> kinds{"box", "box", "cylinder", "bottle", "jar"};
    const Thing thing = makeThing(random_.pick(kinds), random_);
    const cv::Vec3b color = drawColor(random_);
    if (thing.box().sizes().head<2>().norm() > width) return;
    for (const Part& part : thing.parts) {
      add(part.shape, moved(position.x(), position.y(), position.z() + floor_z_) * part.T_thing_part, color);
    }
  }

  bool isClear(const Placed& arm, const std::vector<Placed>& obstacles) const {
    const Vector3d eye = area_.viewpoint.T_world_camera.translation();
    const ConvexBound camera{moved(eye.x(), eye.y(), eye.z()), Vector3d::Zero(), false};
    for (std::size_t i = 0; i < arm.bounds.size(); ++i) {
      if (separation(arm.bounds[i], camera) < kCameraClear_m) return false;
      for (const Vector3d& corner : arm.bounds[i].corners()) {
        if (i > 0 && corner.z() < table_z_ + kClear_m) return false;
      }
    }
    return std::all_of(obstacles.begin(), obstacles.end(),
                       [&](const Placed& other) { return gap(arm, other) >= kClear_m; });
  }

  const Area& area_;
  Random& random_;
  double table_z_, floor_z_;
  int side_;             // of the table, along x: the one that the camera is not on
  double beside_m_ = 0;  // what stands on that side reaches this far from the table
  std::vector<Body> bodies_;
};

}  // namespace

std::optional<std::vector<Body>> drawAround(const Surroundings& wanted, const Area& area,
                                            const std::vector<Placed>& things, std::vector<Body>& room,
                                            Random& random) {
  Builder builder(area, random);
  if (wanted.rack) builder.rack();
  if (wanted.wall) builder.wall();
  if (wanted.table) moveWallBehind(room, builder.table());
  if (wanted.arm && !builder.arm(things)) return {};
  return builder.take();
}

}  // namespace objectness::sim
