// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <tuple>

#include "fixtures/piece_view.hpp"
#include "grouping/group_cost.hpp"
#include "objectness_segmentation/pipeline.hpp"
#include "selection/global_selection.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

/// Two boxes, the right one from x = left on.
Scene twoBoxes(double left) {
  Scene scene = sceneOf({kTable, box({-0.2, 0, 0}, {-0.02, 0.1, 0.12}), box({left, 0, 0}, {left + 0.14, 0.1, 0.08})});
  scene.camera = {262.5, 262.5, 159.5, 119.5, 320, 240};
  return scene;
}

/// Two boxes that touch, front and top of each a piece: 0 and 1 the left one's, 2 and 3 the right one's.
struct FourPieces : PieceView {
  FourPieces()
      : PieceView(twoBoxes(-0.02), [](int surface, const Eigen::Vector3d& p) {
          return 2 * surface - (p.z() > (surface == 1 ? 0.119 : 0.079) ? 0 : 1);
        }) {
    const EdgeMap edges = findEdges(frame, normals, table, points, {});
    const std::vector<std::vector<int>> sets = {{0}, {1}, {2}, {3}, {0, 1}, {2, 3}, {0, 2}, {0, 1, 2, 3}};
    groups = describeGroups({frame, table, edges, pieces, borders, {}}, sets, 1);
    const float objectness[] = {0.5f, 0.45f, 0.5f, 0.45f, 0.95f, 0.9f, 0.3f, 0.6f};
    for (std::size_t k = 0; k < groups.size(); ++k) groups[k].objectness = objectness[k];
  }
  CostProblem problem(const SelectionConfig& config) const {
    return groupCostProblem(frame, table, pieces, groups, config, {objectness, kVoxel_m});
  }

  static constexpr double kVoxel_m = 0.01;
  ObjectnessConfig objectness;
  std::vector<GroupHypothesis> groups;
};

/// Eq. 8 and 10 in the world, point by point.
class CostByTheBook {
 public:
  CostByTheBook(const FourPieces& view, const SelectionConfig& config) : view_(view), config_(config) {
    for (int k = 0; k < view.pieces.count(); ++k) {
      std::set<std::tuple<int, int, int>> cells;
      for (const int pixel : view.pieces.pieces[k].pixels) {
        const Eigen::Vector3f& p = view.frame.points[pixel];
        const auto cell = [&](int axis) { return static_cast<int>(std::floor(p[axis] / config.point_spacing_m)); };
        if (cells.emplace(cell(0), cell(1), cell(2)).second) points_.emplace_back(view.world(pixel), k);
      }
    }
  }

  double operator()(unsigned chosen) const {
    double cost = 0;
    for (std::size_t i = 0; i < view_.groups.size(); ++i) {
      const OrientedBox& box = view_.groups[i].box;
      const double free_cm3 = view_.groups[i].cues.free * 1e6 * box.size_m.prod();
      if (chosen >> i & 1) cost += config_.lambda * std::round(free_cm3);
    }
    for (const auto& [p, piece] : points_) {
      int holders = 0, beside = 0;
      double objectness = 0;
      for (std::size_t i = 0; i < view_.groups.size(); ++i) {
        const GroupHypothesis& group = view_.groups[i];
        if (!(chosen >> i & 1)) continue;
        if (std::count(group.pieces.begin(), group.pieces.end(), piece)) {
          ++holders;
          objectness += group.objectness;
        } else {
          beside += near(group.box, p);
        }
      }
      cost += holders > 1    ? config_.weight_multiple * holders
              : holders == 1 ? -config_.weight_objectness * objectness
                             : config_.weight_unexplained * beside;
    }
    return cost;
  }

 private:
  bool near(const OrientedBox& box, const Eigen::Vector3d& p) const {
    const Eigen::Isometry3d pose = view_.scene.T_world_camera * box.T_camera_box;
    const Eigen::Vector3d d = p - pose.translation(), half = 0.5 * box.size_m;
    Eigen::Vector3d up = pose.linear().col(2);
    if (up.z() < 0) up = -up;
    const double ring = config_.ring_m;
    return std::abs(d.dot(pose.linear().col(0))) <= half.x() + ring &&
           std::abs(d.dot(pose.linear().col(1))) <= half.y() + ring && d.dot(up) >= -half.z() &&
           d.dot(up) <= half.z() + ring;
  }

  const FourPieces& view_;
  const SelectionConfig config_;
  std::vector<std::pair<Eigen::Vector3d, int>> points_;
};

std::vector<bool> flags(unsigned chosen, std::size_t count) {
  std::vector<bool> active(count);
  for (std::size_t i = 0; i < count; ++i) active[i] = chosen >> i & 1;
  return active;
}

}  // namespace

TEST(GroupCost, IsThatOfTheBookForEveryChoice) {
  const FourPieces view;
  ASSERT_EQ(view.pieces.count(), 4);
  for (const double ring_m : {0.0, 0.03}) {
    SelectionConfig config;
    config.ring_m = ring_m;
    config.lambda = 0.3;
    const CostProblem problem = view.problem(config);
    ASSERT_EQ(problem.hypotheses.size(), view.groups.size());
    const CostByTheBook by_the_book(view, config);
    for (unsigned chosen = 0; chosen < 1u << view.groups.size(); ++chosen) {
      const double expected = by_the_book(chosen);
      ASSERT_NEAR(GlobalCost::evaluate(problem, config, flags(chosen, view.groups.size())), expected,
                  1e-6 * (1 + std::abs(expected)))
          << chosen;
    }
  }
}

TEST(GroupCost, AnnealingFindsTheBestOfAllChoices) {
  const FourPieces view;
  for (const double lambda : {0.0, 0.1, 1.0}) {
    for (const double weight_unexplained : {0.0, 0.3, 1.0}) {
      SelectionConfig config;
      config.lambda = lambda;
      config.weight_unexplained = weight_unexplained;
      const CostProblem problem = view.problem(config);
      double best = std::numeric_limits<double>::max();
      for (unsigned chosen = 0; chosen < 1u << view.groups.size(); ++chosen) {
        best = std::min(best, GlobalCost::evaluate(problem, config, flags(chosen, view.groups.size())));
      }
      EXPECT_NEAR(selectHypotheses(problem, config, 1).cost, best, 1e-6 * (1 + std::abs(best)));
    }
  }
}

TEST(GroupCost, WholeObjectsAreChosen) {
  const FourPieces view;
  SelectionConfig config;
  config.lambda = 0.1;
  const Selection selection = selectHypotheses(view.problem(config), config, 1);
  EXPECT_EQ(selection.active, flags(0b110000, view.groups.size()));
}

TEST(GroupCost, ChoosesForTheWholePipeline) {
  Scene scene = twoBoxes(0.08);
  const Frame frame = scene.render();
  Config config;
  config.grouping.paper_cost = true;
  const Segmentation result = segment(frame, config);
  ASSERT_TRUE(result.status.ok()) << result.status.message;
  ASSERT_EQ(result.segments.size(), 2u);
  std::set<int> found;
  for (const Segment& segment : result.segments) {
    const int surface = scene.seen[segment.pixels[segment.pixels.size() / 2]];
    const auto own = std::count_if(segment.pixels.begin(), segment.pixels.end(),
                                   [&](int pixel) { return scene.seen[pixel] == surface; });
    EXPECT_GT(own, 0.9 * std::count(scene.seen.begin(), scene.seen.end(), surface));
    found.insert(surface);
  }
  EXPECT_EQ(found, (std::set<int>{1, 2}));
}
