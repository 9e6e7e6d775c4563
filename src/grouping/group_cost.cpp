// SPDX-License-Identifier: BSD-3-Clause
#include "grouping/group_cost.hpp"

#include <algorithm>
#include <limits>

#include "grouping/rule_based_scores.hpp"
#include "selection/scene_points.hpp"

namespace objectness {
namespace {

/// S': camera frame, metres, piece after piece.
struct ScenePoints {
  std::vector<Eigen::Vector3f> points;
  std::vector<int> piece;  ///< of each point
};

ScenePoints scenePoints(const Frame& frame, const Pieces& pieces, double spacing_m) {
  ScenePoints scene;
  for (int k = 0; k < pieces.count(); ++k) {
    std::vector<Eigen::Vector3f> all;
    for (const int pixel : pieces.pieces[k].pixels) all.push_back(frame.points[pixel]);
    for (const auto& p : thinPoints(all, spacing_m, std::numeric_limits<double>::infinity())) {
      scene.points.push_back(p);
      scene.piece.push_back(k);
    }
  }
  return scene;
}

/// b_eps: the box grown to four sides and upwards. Box frame.
struct GrownBox {
  GrownBox(const OrientedBox& box, const Eigen::Vector3d& table_normal, double ring_m)
      : T_box_camera(box.T_camera_box.inverse().cast<float>()), high((0.5 * box.size_m).cast<float>()), low(-high) {
    const float ring = static_cast<float>(ring_m);
    const bool z_is_up = box.T_camera_box.linear().col(2).dot(table_normal) >= 0;
    high += Eigen::Vector3f(ring, ring, z_is_up ? ring : 0);
    low -= Eigen::Vector3f(ring, ring, z_is_up ? 0 : ring);
  }
  bool holds(const Eigen::Vector3f& p_camera) const {
    const Eigen::Array3f q = T_box_camera * p_camera;
    return (q >= low.array()).all() && (q <= high.array()).all();
  }

  Eigen::Isometry3f T_box_camera;
  Eigen::Vector3f high, low;
};

}  // namespace

CostProblem groupCostProblem(const Frame& frame, const Table& table, const Pieces& pieces,
                             const std::vector<GroupHypothesis>& groups, const SelectionConfig& config,
                             const GroupCostUnits& units) {
  const ScenePoints scene = scenePoints(frame, pieces, config.point_spacing_m);
  std::vector<CostHypothesis> hypotheses;
  for (const GroupHypothesis& group : groups) {
    const CueValues cues = paperCues(group, units.objectness, units.voxel_m);
    const GrownBox grown(group.box, table.normal, config.ring_m);
    CostHypothesis hypothesis;
    hypothesis.objectness = group.objectness;
    hypothesis.free_space = config.free_space_in_voxels ? cues.free_voxels : cues.free_space;
    for (std::size_t i = 0; i < scene.points.size(); ++i) {
      const bool own = std::binary_search(group.pieces.begin(), group.pieces.end(), scene.piece[i]);
      if (own) hypothesis.inside.push_back(static_cast<int>(i));
      if (!own && grown.holds(scene.points[i])) hypothesis.surroundings.push_back(static_cast<int>(i));
    }
    hypotheses.push_back(std::move(hypothesis));
  }
  return mergeAlikePoints(hypotheses, static_cast<int>(scene.points.size()));
}

}  // namespace objectness
