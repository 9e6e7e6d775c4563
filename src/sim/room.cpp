// SPDX-License-Identifier: BSD-3-Clause
#include "sim/room.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "sim/profiles.hpp"

namespace objectness::sim {
namespace {

constexpr double kMinSide_m = 0.3, kMaxSide_m = 4, kMinHeight_m = 0.2, kMaxHeight_m = 1.5;
constexpr std::size_t kWall = 1;  // of the room's bodies
constexpr double kWallThickness_m = 0.1;
constexpr double kFootRadius_m = 0.05, kRoom_m = 8, kRoomHeight_m = 3;

Body body(const Shape& shape, const Eigen::Vector3d& position, const cv::Vec3b& color, int label) {
  Body body{shape, Eigen::Isometry3d::Identity(), color, static_cast<ushort>(label)};
  body.T_world_body.translation() = position;
  return body;
}

}  // namespace

bool TableSize::covers(const Eigen::Vector2d& point, double margin_m) const {
  if (round) return point.norm() <= width_m / 2 - margin_m;
  return std::abs(point.x()) <= width_m / 2 - margin_m && std::abs(point.y()) <= depth_m / 2 - margin_m;
}

Result<TableSize> parseTable(const std::string& text) {
  using Table = Result<TableSize>;
  const std::string prefix = "round:";
  TableSize table;
  table.round = text.compare(0, prefix.size(), prefix) == 0;
  std::istringstream in(table.round ? text.substr(prefix.size()) : text);
  char x1 = 'x', x2 = 'x';
  in >> table.width_m >> x1;
  if (table.round) {
    table.depth_m = table.width_m;
  } else {
    in >> table.depth_m >> x2;
  }
  in >> table.height_m;
  if (!in || !(in >> std::ws).eof() || x1 != 'x' || x2 != 'x') {
    return Table::error(StatusCode::kBadConfig, "'" + text +
                                                    "' is no table: give WIDTHxDEPTHxHEIGHT (1.2x0.8x0.72) or "
                                                    "round:DIAMETERxHEIGHT (round:1.1x0.72), metres");
  }
  for (const double side : {table.width_m, table.depth_m}) {
    if (side >= kMinSide_m && side <= kMaxSide_m) continue;
    return Table::error(StatusCode::kBadConfig, "a table's top must measure 0.3 to 4 m");
  }
  if (table.height_m >= kMinHeight_m && table.height_m <= kMaxHeight_m) return {{}, table};
  return Table::error(StatusCode::kBadConfig, "a table's height must be 0.2 to 1.5 m");
}

void moveWallBehind(std::vector<Body>& room, double y_m) {
  double& y = room[kWall].T_world_body.translation().y();
  y = std::max(y, y_m + kWallThickness_m);
}

TableSize drawTable(Random& random) {
  TableSize table;
  table.round = random.chance(0.3);
  table.width_m = table.round ? random.uniform(0.8, 1.3) : random.uniform(0.8, 1.8);
  table.depth_m = table.round ? table.width_m : random.uniform(0.6, 1.0);
  const double heights[] = {0.45, 0.73, 0.9};
  table.height_m = heights[random.integer(0, 2)];
  table.height_m += random.uniform(-0.04, 0.04);
  return table;
}

std::vector<Body> roomBodies(const TableSize& table, Random& random) {
  const std::vector<cv::Vec3b> woods{{120, 160, 190}, {90, 125, 160}, {200, 205, 210}, {150, 150, 155}, {70, 95, 130}};
  const std::vector<cv::Vec3b> paints{{215, 220, 222}, {190, 200, 200}, {200, 190, 175}, {170, 185, 200}};
  const std::vector<cv::Vec3b> floors{{96, 90, 84}, {80, 100, 120}, {130, 130, 128}};
  const cv::Vec3b wood = random.pick(woods), paint = random.pick(paints), floor = random.pick(floors);
  const double thickness = random.uniform(0.018, 0.04), wall_y = table.depth_m / 2 + random.uniform(0.05, 1.2);
  const Shape top = table.round ? Shape(cylinder(table.width_m / 2, thickness))
                                : Shape(Box{{table.width_m, table.depth_m, thickness}});
  return {body(Box{{kRoom_m, kRoom_m, 0.01}}, {0, 0, -table.height_m - 0.01}, floor, 0),
          body(Box{{kRoom_m, kWallThickness_m, kRoomHeight_m}}, {0, wall_y + kWallThickness_m / 2, -table.height_m},
               paint, 0),
          body(cylinder(kFootRadius_m, table.height_m - thickness), {0, 0, -table.height_m}, wood, 0),
          body(top, {0, 0, -thickness}, wood, 1)};
}

}  // namespace objectness::sim
