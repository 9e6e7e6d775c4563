// SPDX-License-Identifier: BSD-3-Clause
#include "sim/stage.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/angles.hpp"
#include "common/true_labels.hpp"

namespace objectness::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kTries = 40;
constexpr int kMany = 12;  // more than these find no place beside one another on the usual floor
constexpr double kTableMargin_m = 0.01;
constexpr double kShelfTurn_deg = 10;

/// Adds boxes to a stage, given in the stage's own frame.
struct Builder {
  Stage& stage;
  cv::Vec3b color;

  /// position: centre of the box's base.
  void add(const Vector3d& size, const Vector3d& position) {
    stage.bodies.push_back(
        {Box{size}, stage.T_world_stage * Eigen::Translation3d(position), color, static_cast<ushort>(kStageLabel)});
  }
};

/// A floor with walls all around it that end `height_m` over it.
void buildRim(double wall_m, double height_m, Builder& builder) {
  const Vector2d& half = builder.stage.half;
  const double floor_m = builder.stage.floor_m, height = floor_m + height_m;
  builder.add({2 * half.x(), 2 * half.y(), floor_m}, {0, 0, -floor_m});
  for (const int side : {-1, 1}) {
    builder.add({2 * (half.x() + wall_m), wall_m, height}, {0, side * (half.y() + wall_m / 2), -floor_m});
    builder.add({wall_m, 2 * half.y(), height}, {side * (half.x() + wall_m / 2), 0, -floor_m});
  }
}

/// The board, sides and back down to the table, and perhaps a board over it.
void buildShelf(double board_m, double height_m, bool upper_board, Builder& builder) {
  Stage& stage = builder.stage;
  const Vector2d& half = stage.half;
  const double height = stage.floor_m + height_m;
  builder.add({2 * half.x(), 2 * half.y(), board_m}, {0, 0, -board_m});
  for (const int side : {-1, 1}) {
    builder.add({board_m, 2 * half.y(), height}, {side * (half.x() + board_m / 2), 0, -stage.floor_m});
  }
  builder.add({2 * (half.x() + board_m), board_m, height}, {0, half.y() + board_m / 2, -stage.floor_m});
  if (!upper_board) return;
  stage.ceiling_m = height_m;
  builder.add({2 * (half.x() + board_m), 2 * half.y() + board_m, board_m}, {0, board_m / 2, height_m});
}

/// How much of the floor a thing takes; a shelf is not deep, in a tote they lie close together.
Vector2d drawHalf(StageKind kind, int count, double more_room, Random& random) {
  const double crowd = std::pow(std::max(1.0, static_cast<double>(count) / kMany), 0.25);
  const double width = (0.18 + 0.125 * std::sqrt(count)) * random.uniform(0.95, 1.15) * crowd * more_room;
  const double share = random.uniform(0.62, 0.8);
  if (kind != StageKind::kShelf) return Vector2d(width, width * share) / 2;
  const double depth = std::clamp(0.55 * width, 0.24, 0.45 * crowd * crowd) * random.uniform(0.9, 1.1);
  return Vector2d(std::max(0.45, width * width * 0.75 / depth), depth) / 2;
}

bool standsOn(const Stage& stage, double wall_m, const TableSize& table) {
  for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
    const Vector3d corner(x * (stage.half.x() + wall_m), y * (stage.half.y() + wall_m), 0);
    if (!table.covers((stage.T_world_stage * corner).head<2>(), kTableMargin_m)) return false;
  }
  return true;
}

}  // namespace

bool Stage::holds(const Vector3d& point, double margin_m) const {
  const Vector3d local = T_world_stage.inverse() * point;
  return std::abs(local.x()) <= half.x() - margin_m && std::abs(local.y()) <= half.y() - margin_m &&
         local.z() <= ceiling_m - margin_m;
}

std::optional<Stage> drawStage(StageKind kind, int count, double more_room, const TableSize& table, Random& random) {
  const std::vector<cv::Vec3b> plastics{{60, 60, 62}, {160, 90, 40}, {205, 205, 200}, {70, 70, 190}, {90, 130, 165}};
  const cv::Vec3b color = random.pick(plastics);
  const bool shelf = kind == StageKind::kShelf, tray = kind == StageKind::kTray;
  Stage stage;
  stage.kind = kind;
  stage.half = drawHalf(kind, count, more_room, random);
  const double wall_m = shelf  ? random.uniform(0.015, 0.022)
                        : tray ? random.uniform(0.004, 0.012)
                               : random.uniform(0.004, 0.008);
  const double height_m = shelf  ? random.uniform(0.33, 0.45)
                          : tray ? random.uniform(0.015, 0.05)
                                 : random.uniform(0.12, 0.24);
  const bool upper_board = random.chance(0.6), raised = random.chance(0.4);
  const double thickness_m = tray ? random.uniform(0.003, 0.012) : random.uniform(0.003, 0.006);
  const double raise_m = random.uniform(0.15, 0.3);
  stage.floor_m = !shelf ? thickness_m : raised ? raise_m : wall_m;
  const double most_turn = shelf ? kShelfTurn_deg * kPi / 180 : kPi;
  for (int i = 0; i < kTries; ++i) {
    const double x = table.width_m / 2 * random.uniform(-1, 1), y = table.depth_m / 2 * random.uniform(-1, 1);
    const double turn = random.uniform(-most_turn, most_turn);
    stage.T_world_stage = Eigen::Translation3d(x, y, 0) * Eigen::AngleAxisd(turn, Vector3d::UnitZ());
    if (!standsOn(stage, wall_m, table)) continue;
    Builder builder{stage, color};
    if (shelf) {
      buildShelf(wall_m, height_m, upper_board, builder);
    } else {
      buildRim(wall_m, height_m, builder);
    }
    return stage;
  }
  return {};
}

}  // namespace objectness::sim
