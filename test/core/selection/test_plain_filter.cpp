// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "fixtures/random_volumes.hpp"
#include "reference/plain_filter.hpp"
#include "selection/scene_points.hpp"

using namespace objectness;
using objectness_test::Dice;

namespace {

Grid turnedGrid(double angle_rad) {
  Grid grid;
  grid.angle_rad = angle_rad;
  grid.cosine = std::cos(angle_rad), grid.sine = std::sin(angle_rad);
  grid.origin_m = {-0.2, -0.2};
  grid.nx = grid.ny = 40, grid.nz = 20;
  return grid;
}

std::vector<Eigen::Vector3f> randomPoints(unsigned seed, int count) {
  Dice dice(seed);
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < count; ++i) {
    points.emplace_back(0.5 * dice.unit() - 0.25, 0.5 * dice.unit() - 0.25, 0.25 * dice.unit());
  }
  return points;
}

ScoredBox scoredBox(int x0, int x1, int y0, int y1, int height, float objectness, int angle = 0) {
  ScoredBox scored;
  scored.box = {angle, x0, x1, y0, y1, height};
  scored.objectness = objectness;
  return scored;
}

}  // namespace

TEST(Grid, TableToGridAndBack) {
  const Grid grid = turnedGrid(0.6);
  for (const auto& p : randomPoints(1, 20)) {
    EXPECT_LT((grid.toTable(grid.toGrid(p.cast<double>())) - p.cast<double>()).norm(), 1e-12);
  }
}

TEST(PointOverlap, HoldsThePointsThatABoxTestHolds) {
  const auto points = randomPoints(2, 300);
  for (const double margin_m : {0.0, 0.005}) {
    const Grid grid = turnedGrid(0.4);
    const PointOverlap overlap(points, grid, margin_m);
    Dice dice(11);
    for (int trial = 0; trial < 100; ++trial) {
      const int x0 = dice.below(30), y0 = dice.below(30), grow = dice.below(5);
      const Box box{0, x0, x0 + dice.between(3, 10), y0, y0 + dice.between(3, 10), dice.between(3, 20)};
      const std::vector<int> held = listPoints(overlap.inside(box, grow, grow));
      std::vector<int> expected;
      const double m = margin_m / grid.voxel_m;
      for (int i = 0; i < 300; ++i) {
        const Eigen::Vector3d q = grid.toGrid(points[i].cast<double>());
        // A face that has grown out of the grid holds everything on its side.
        const bool after_x = box.x0 - grow <= 0 ? q.x() >= -m : q.x() >= box.x0 - grow - m;
        const bool after_y = box.y0 - grow <= 0 ? q.y() >= -m : q.y() >= box.y0 - grow - m;
        if (after_x && after_y && q.x() < std::min(box.x1 + grow, grid.nx) + m &&
            q.y() < std::min(box.y1 + grow, grid.ny) + m && q.z() < std::min(box.height + grow, grid.nz) + m) {
          expected.push_back(i);
        }
      }
      ASSERT_EQ(held, expected);
    }
  }
}

TEST(PointOverlap, CountsSharedPoints) {
  PointSet a(2, 0), b(2, 0);
  a[0] = 0b1011, a[1] = std::uint64_t{1} << 63;
  b[0] = 0b0110, b[1] = std::uint64_t{1} << 63;
  EXPECT_EQ(countPoints(a), 4);
  EXPECT_EQ(countShared(a, b), 2);
  EXPECT_EQ(listPoints(a), (std::vector<int>{0, 1, 3, 127}));
}

TEST(ThinPoints, OnePointACellAndNoneAboveTheTop) {
  const std::vector<Eigen::Vector3f> points = {
      {0.001f, 0.001f, 0.001f}, {0.004f, 0.001f, 0.001f}, {-0.001f, 0.001f, 0.001f}, {0.001f, 0.001f, 0.3f}};
  const auto thinned = thinPoints(points, 0.005, 0.2);
  ASSERT_EQ(thinned.size(), 2u);
  EXPECT_EQ(thinned[0], points[0]) << "the first of a cell stays";
  EXPECT_EQ(thinned[1], points[2]);
}

class BoxFilter : public ::testing::Test {
 protected:
  BoxFilter() {
    // A dense block of points in the voxels [10, 20) x [10, 20) x [0, 10), another in [28, 34) x [10, 20) x [0, 10).
    for (int x = 0; x < 40; ++x) {
      for (int y = 10; y < 20; ++y) {
        for (int z = 0; z < 10; ++z) {
          if ((x < 10 || x >= 20) && (x < 28 || x >= 34)) continue;
          points_.push_back(grids_[0].toTable({x + 0.5, y + 0.5, z + 0.5}).cast<float>());
        }
      }
    }
    overlaps_.emplace_back(points_, grids_[0], 0);
  }
  std::vector<BoxHypothesis> run(const std::vector<ScoredBox>& boxes) {
    return filterBoxes(boxes, grids_, overlaps_, config_);
  }

  std::vector<Grid> grids_{turnedGrid(0)};
  std::vector<Eigen::Vector3f> points_;
  std::vector<PointOverlap> overlaps_;
  FilterConfig config_;
};

TEST_F(BoxFilter, KeepsTheBestOfBoxesInConflict) {
  const auto kept = run({scoredBox(10, 20, 10, 20, 10, 1.4f), scoredBox(9, 20, 10, 20, 10, 1.3f),
                         scoredBox(28, 34, 10, 20, 10, 1.2f), scoredBox(10, 20, 9, 21, 11, 1.1f)});
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_FLOAT_EQ(kept[0].scored.objectness, 1.4f);
  EXPECT_FLOAT_EQ(kept[1].scored.objectness, 1.2f);
  EXPECT_EQ(countPoints(kept[0].points), 1000);
}

TEST_F(BoxFilter, SharesAreOfTheBoxWithMorePoints) {
  // The smaller box lies wholly in the larger one but is 90 % of it: no conflict at 95 %, one at 90 %.
  const std::vector<ScoredBox> boxes = {scoredBox(10, 20, 10, 20, 10, 1.4f), scoredBox(10, 19, 10, 20, 10, 1.3f)};
  EXPECT_EQ(run(boxes).size(), 2u);
  config_.conflict_share = 0.9;
  EXPECT_EQ(run(boxes).size(), 1u);
}

TEST_F(BoxFilter, ASuppressedBoxSuppressesNothing) {
  // The middle box is in conflict with both others, which share only 80 %: once it is out, the last one stays.
  config_.conflict_share = 0.88;
  const auto kept = run(
      {scoredBox(10, 20, 10, 20, 10, 1.4f), scoredBox(10, 19, 10, 20, 10, 1.3f), scoredBox(10, 18, 10, 20, 10, 1.2f)});
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_FLOAT_EQ(kept[1].scored.objectness, 1.2f);
}

TEST_F(BoxFilter, TakesTheBestOfACluster) {
  config_.max_boxes_per_cluster = 1;
  const auto kept = run(
      {scoredBox(10, 20, 10, 20, 10, 1.4f), scoredBox(10, 20, 10, 17, 10, 1.3f), scoredBox(28, 34, 10, 20, 10, 1.2f)});
  ASSERT_EQ(kept.size(), 2u) << "the second is the second of its cluster";
  EXPECT_FLOAT_EQ(kept[1].scored.objectness, 1.2f);
}

TEST_F(BoxFilter, OnlyWithinClustersWhenAskedTo) {
  // The same content, centres more than a cluster's radius apart.
  const std::vector<ScoredBox> boxes = {scoredBox(10, 20, 10, 20, 10, 1.4f), scoredBox(10, 20, 0, 20, 20, 1.3f)};
  EXPECT_EQ(run(boxes).size(), 1u);
  config_.across_clusters = false;
  EXPECT_EQ(run(boxes).size(), 2u);
}

TEST_F(BoxFilter, DropsBoxesWithoutPoints) { EXPECT_TRUE(run({scoredBox(0, 5, 0, 5, 5, 1.4f)}).empty()); }
