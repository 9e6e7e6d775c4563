// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scene_generator.hpp"

#include <algorithm>
#include <cmath>

#include "common/true_labels.hpp"
#include "sim/arrangement.hpp"
#include "sim/surface_view.hpp"

namespace objectness::sim {
namespace {

constexpr int kAttempts = 1000;  // at a whole scene, each with a little more room than the one before
constexpr double kMoreRoom = 0.001;
constexpr int kCoarse_px = 96;  // width of the picture that shows who hides whom

Result<Scene> bad(const std::string& message) { return Result<Scene>::error(StatusCode::kBadConfig, message); }

/// The same for a level whatever others there are.
std::vector<std::uint32_t> seeds(const SceneRequest& request, int attempt) {
  std::vector<std::uint32_t> all{request.seed, request.index, static_cast<std::uint32_t>(attempt)};
  all.insert(all.end(), request.level.begin(), request.level.end());
  return all;
}

/// Radius of the disc that holds `count` things which stand apart.
double roomFor(int count, int attempt) { return (0.08 + 0.09 * std::sqrt(count)) * (1 + kMoreRoom * attempt); }

constexpr int kManyObjects = 20;  // more need a larger table than the usual ones

TableSize drawTableFor(int count, Random& random) {
  TableSize table = drawTable(random);
  const double scale = std::sqrt(std::max(1.0, static_cast<double>(count) / kManyObjects));
  table.width_m *= scale;
  table.depth_m *= scale;
  return table;
}

Area drawArea(const SceneRequest& request, const TableSize& table, const std::optional<Viewpoint>& given, int count,
              int attempt, Random& random) {
  Area area{table, {}, request.camera, roomFor(count, attempt)};
  const double free_x = std::max(0.0, table.width_m / 2 - area.radius_m) * (table.round ? 0.7 : 1);
  const double free_y = std::max(0.0, table.depth_m / 2 - area.radius_m) * (table.round ? 0.7 : 1);
  const double x = random.uniform(-free_x, free_x), y = random.uniform(-free_y, free_y);
  area.viewpoint = given ? *given : drawViewpoint({x, y}, area.radius_m, request.camera, random);
  return area;
}

Scene assemble(const std::string& level, const std::vector<Body>& room, const std::vector<Placed>& things,
               const Viewpoint& viewpoint, Random& random) {
  Scene scene{level, room, {}, viewpoint.T_world_camera, viewpoint.target};
  for (const Placed& placed : things) {
    const int label = trueLabel(scene.objects.size());
    const cv::Vec3b color = drawColor(random);
    for (const Shape& part : placed.thing.parts) {
      scene.bodies.push_back({part, placed.T_world_thing, color, static_cast<ushort>(label)});
    }
    const Eigen::AlignedBox3d box = placed.thing.box();
    scene.objects.push_back({placed.thing.kind, label,
                             Eigen::Isometry3d(placed.T_world_thing * Eigen::Translation3d(box.center())),
                             box.sizes()});
  }
  return scene;
}

/// Whether the table fills enough of the picture, and as much of the objects is covered as their level asks for.
bool looksAsAsked(const Scene& scene, const SceneRequest& request, const Level& level) {
  const PinholeCamera& camera = request.camera;
  const double scale = static_cast<double>(kCoarse_px) / camera.width;
  const PinholeCamera coarse{camera.fx * scale,
                             camera.fy * scale,
                             (camera.cx + 0.5) * scale - 0.5,
                             (camera.cy + 0.5) * scale - 0.5,
                             kCoarse_px,
                             static_cast<int>(camera.height * scale)};
  const SurfaceView view = viewSurfaces(scene.bodies, scene.T_world_camera, coarse, {}, 1);
  int on_table = 0;
  for (const auto& [label, pixels] : view.pixels_seen) on_table += label > 0 ? pixels : 0;
  const int wanted = static_cast<int>(request.min_table_share * coarse.width * coarse.height);
  if (!request.T_world_camera && on_table < wanted) return false;
  double least = 1;
  for (const SceneObject& object : scene.objects) {
    const int alone = view.pixels_alone.at(object.label);
    least = std::min(least, alone > 0 ? static_cast<double>(view.pixels_seen.at(object.label)) / alone : 0);
  }
  return least >= level.min_visible && (least <= level.most_covered || scene.objects.size() < 2);
}

std::string describe(const SceneRequest& request, int count) {
  return "found no room for " + std::to_string(count) + " objects at level '" + request.level +
         "' on the table and in the camera's view: ask for fewer, give a larger table or a wider camera, or let the "
         "table fill less of the picture";
}

}  // namespace

Result<Scene> generateScene(const SceneRequest& request) {
  const Level* level = findLevel(request.level);
  if (!level) return bad("there is no level '" + request.level + "', but " + levelNames());
  if (request.objects && (*request.objects < 0 || *request.objects > kMaxObjects)) {
    return bad(std::to_string(*request.objects) + " objects: must be 0 to " + std::to_string(kMaxObjects));
  }
  const Status camera = validate(request.camera);
  if (!camera.ok()) return Result<Scene>::error(camera);
  std::optional<Viewpoint> given;
  if (request.T_world_camera) {
    given = givenViewpoint(*request.T_world_camera);
    if (!given) return bad("the camera must look down at the table");
  }
  int count = 0;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    Random random(seeds(request, attempt));
    const int drawn_count = random.integer(level->min_objects, level->max_objects);
    count = request.objects.value_or(drawn_count);
    const TableSize drawn_table = drawTableFor(count, random);
    const TableSize table = request.table.value_or(drawn_table);
    const Area area = drawArea(request, table, given, count, attempt, random);
    const std::vector<Placed> things = arrange(*level, count, area, random);
    if (static_cast<int>(things.size()) < count) continue;
    const std::vector<Body> room = roomBodies(table, random);
    const Scene scene = assemble(level->name, room, things, area.viewpoint, random);
    if (looksAsAsked(scene, request, *level)) return {{}, scene};
  }
  return bad(describe(request, count));
}

}  // namespace objectness::sim
