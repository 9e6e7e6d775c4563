// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scene_generator.hpp"

#include <algorithm>
#include <cmath>

#include "common/true_labels.hpp"
#include "sim/around.hpp"
#include "sim/arrangement.hpp"
#include "sim/surface_view.hpp"

namespace objectness::sim {
namespace {

constexpr int kAttempts = 1000;  // at a whole scene, each with a little more room than the one before
constexpr double kMoreRoom = 0.001;
constexpr std::uint32_t kAroundStream = 256;  // no letter of a level's name
constexpr int kCoarse_px = 96;                // width of the picture that shows who hides whom

Result<Scene> bad(const std::string& message) { return Result<Scene>::error(StatusCode::kBadConfig, message); }

/// The same for a level whatever others there are. stream: another one, other numbers.
std::vector<std::uint32_t> seeds(const SceneRequest& request, int attempt,
                                 const std::optional<std::uint32_t>& stream = {}) {
  std::vector<std::uint32_t> all{request.seed, request.index, static_cast<std::uint32_t>(attempt)};
  all.insert(all.end(), request.level.begin(), request.level.end());
  if (stream) all.push_back(*stream);
  return all;
}

/// Radius of the disc that holds `count` things which stand apart.
double roomFor(int count, int attempt) { return (0.08 + 0.09 * std::sqrt(count)) * (1 + kMoreRoom * attempt); }

constexpr int kManyObjects = 20;  // more need a larger table than the usual ones
constexpr int kLargerTables = 6;
constexpr double kLarger = 1.15;  // than a table that has no room for what is to stand on it

TableSize drawTableFor(int count, Random& random) {
  TableSize table = drawTable(random);
  const double scale = std::sqrt(std::max(1.0, static_cast<double>(count) / kManyObjects));
  table.width_m *= scale;
  table.depth_m *= scale;
  return table;
}

/// On what stands on the table, which grows as it has to; nothing when the table that was asked for is too small.
std::optional<Area> drawOnStage(const Level& level, const SceneRequest& request, Area area,
                                const std::optional<Viewpoint>& given, int count, int attempt, Random& random) {
  for (int i = 0; i < kLargerTables && !area.stage; ++i) {
    area.stage = drawStage(level.stage, count, 1 + kMoreRoom * attempt, area.table, random);
    if (area.stage || request.table) break;
    area.table.width_m *= kLarger;
    area.table.depth_m *= kLarger;
  }
  if (!area.stage) return {};
  area.radius_m = area.stage->half.maxCoeff();
  const Eigen::Vector2d middle = area.stage->T_world_stage.translation().head<2>();
  area.viewpoint = given ? *given : drawViewpoint(middle, area.radius_m, level.view, area.camera, random);
  return area;
}

std::optional<Area> drawArea(const Level& level, const SceneRequest& request, const TableSize& table,
                             const std::optional<Viewpoint>& given, int count, int attempt, Random& random) {
  Area area{table, {}, {}, request.camera, roomFor(count, attempt)};
  if (level.stage != StageKind::kTable) return drawOnStage(level, request, area, given, count, attempt, random);
  const double free_x = std::max(0.0, table.width_m / 2 - area.radius_m) * (table.round ? 0.7 : 1);
  const double free_y = std::max(0.0, table.depth_m / 2 - area.radius_m) * (table.round ? 0.7 : 1);
  const double x = random.uniform(-free_x, free_x), y = random.uniform(-free_y, free_y);
  area.viewpoint = given ? *given : drawViewpoint({x, y}, area.radius_m, level.view, request.camera, random);
  return area;
}

/// All that is no object.
struct Background {
  std::vector<Body> bodies;
  std::vector<SceneBackground> named;
};

/// The room, what stands on the table and what stands around it; nothing when there is no room for that.
std::optional<Background> makeBackground(const SceneRequest& request, const Level& level, const Area& area,
                                         const std::vector<Placed>& things, int attempt, Random& random) {
  Background made{roomBodies(area.table, random), {}};
  std::vector<Body>& bodies = made.bodies;
  if (area.stage) {
    made.named.push_back({toString(area.stage->kind), kStageLabel});
    for (Body& body : bodies) body.T_world_body.translation().z() -= area.stage->floor_m;
    bodies.insert(bodies.end(), area.stage->bodies.begin(), area.stage->bodies.end());
  }
  Random own(seeds(request, attempt, kAroundStream));
  const Surroundings drawn = level.everyday ? drawSurroundings(own) : Surroundings();
  const Surroundings wanted = request.around.value_or(drawn);
  const auto around = drawAround(wanted, area, things, bodies, own);
  if (!around) return {};
  bodies.insert(bodies.end(), around->begin(), around->end());
  Surroundings::visit(wanted, [&](const char* name, bool there) {
    if (there) made.named.push_back({name, kAroundLabel});
  });
  return made;
}

Scene assemble(const std::string& level, const Background& background, const std::vector<Placed>& things,
               const Viewpoint& viewpoint, Random& random) {
  Scene scene{level, background.bodies, {}, viewpoint.T_world_camera, viewpoint.target, background.named};
  for (const Placed& placed : things) {
    const int label = trueLabel(scene.objects.size());
    const cv::Vec3b color = drawColor(random);
    for (const Part& part : placed.thing.parts) {
      scene.bodies.push_back({part.shape, placed.T_world_thing * part.T_thing_part, color, static_cast<ushort>(label)});
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
  for (const auto& [label, pixels] : view.pixels_seen) on_table += label > 0 && label != kAroundLabel ? pixels : 0;
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
    const std::optional<Area> area = drawArea(*level, request, table, given, count, attempt, random);
    if (!area) continue;
    const std::vector<Placed> things = arrange(*level, count, *area, random);
    if (static_cast<int>(things.size()) < count) continue;
    const auto background = makeBackground(request, *level, *area, things, attempt, random);
    if (!background) continue;
    const Scene scene = assemble(level->name, *background, things, area->viewpoint, random);
    if (looksAsAsked(scene, request, *level)) return {{}, scene};
  }
  return bad(describe(request, count));
}

}  // namespace objectness::sim
