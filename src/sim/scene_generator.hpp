// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "objectness_segmentation/common/status.hpp"
#include "objectness_segmentation/scene/camera.hpp"
#include "sim/levels.hpp"
#include "sim/room.hpp"
#include "sim/scene.hpp"
#include "sim/surroundings.hpp"

namespace objectness::sim {

/// What a scene is made from; it depends on nothing else. What is not given is drawn at random.
struct SceneRequest {
  std::string level = "boxes";  ///< of levels()
  std::uint32_t seed = 1, index = 0;
  std::optional<int> objects;                       ///< 0..kMaxObjects
  std::optional<TableSize> table;                   ///< a tray, tote or shelf stands on it
  std::optional<Eigen::Isometry3d> T_world_camera;  ///< must look down at the table
  /// Drawn camera poses are such that table and objects fill at least this share of the picture: nobody points a camera
  /// at little but floor.
  double min_table_share = 0.15;
  /// At everyday levels drawn at random when it is not given, at the others nothing then.
  std::optional<Surroundings> around;
  PinholeCamera camera;  ///< every object is wholly within its picture
};

constexpr int kMaxObjects = 40;
/// Scene `index` of `seed` at a level. Nothing floats and nothing interpenetrates: whatever stands on the table or on a
/// thing stands exactly on it, leaning slabs touch the table and their support, and between all others lies a gap.
/// kBadConfig: no such level; no room for that many objects on that table, in that camera's view.
Result<Scene> generateScene(const SceneRequest& request);

}  // namespace objectness::sim
