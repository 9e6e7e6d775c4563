// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "fixtures/random_volumes.hpp"
#include "objectness/cue_scores.hpp"
#include "objectness/objectness.hpp"

using namespace objectness;

namespace {

const Box kBox{0, 10, 14, 20, 26, 5};  // 4 x 6 x 5 voxels

/// The visible area by definition: every face whose outward normal has the viewpoint on its outer side.
double visibleAreaByNormals(const Box& b, const Eigen::Vector3d& eye) {
  struct Face {
    Eigen::Vector3d centre, normal;
    double area;
  };
  const double x = 0.5 * (b.x0 + b.x1), y = 0.5 * (b.y0 + b.y1), z = 0.5 * b.height;
  const double sx = b.sizeX(), sy = b.sizeY(), sz = b.height;
  const Face faces[] = {{{1.0 * b.x0, y, z}, {-1, 0, 0}, sy * sz},
                        {{1.0 * b.x1, y, z}, {1, 0, 0}, sy * sz},
                        {{x, 1.0 * b.y0, z}, {0, -1, 0}, sx * sz},
                        {{x, 1.0 * b.y1, z}, {0, 1, 0}, sx * sz},
                        {{x, y, sz}, {0, 0, 1}, sx * sy}};
  double area = 0;
  for (const auto& face : faces) {
    if ((eye - face.centre).dot(face.normal) > 0) area += face.area;
  }
  return area;
}

}  // namespace

TEST(CueScores, VisibleAreaIsThatOfTheFacesTurnedToTheViewpoint) {
  for (const double x : {-50.0, 12.0, 40.0}) {
    for (const double y : {-50.0, 23.0, 80.0}) {
      for (const double z : {1.0, 90.0}) {
        const Eigen::Vector3d eye(x, y, z);
        EXPECT_EQ(visibleArea(kBox, eye), visibleAreaByNormals(kBox, eye)) << eye.transpose();
      }
    }
  }
  EXPECT_EQ(visibleArea(kBox, {0, 0, 50}), 4 * 6 + 4 * 5 + 6 * 5);
  EXPECT_EQ(visibleArea(kBox, {12, 23, 50}), 4 * 6) << "from above only the top is seen";
  EXPECT_EQ(visibleArea(kBox, {0, 23, 3}), 6 * 5) << "from the front, below the top";
}

TEST(CueScores, ThreeFaceAreaIgnoresTheViewpoint) { EXPECT_EQ(threeFaceArea(kBox), 24 + 20 + 30); }

TEST(CueScores, EdgeDensityIsEq1) {
  EXPECT_DOUBLE_EQ(edgeDensity(37, 74), 0.5);
  EXPECT_EQ(edgeDensity(5, 0), 0);
}

TEST(CueScores, OuterEdgesIsEq2) {
  EXPECT_DOUBLE_EQ(outerEdges(30, 40), 0.75);
  EXPECT_DOUBLE_EQ(outerEdges(30, 30), 1);
  EXPECT_EQ(outerEdges(0, 0), 0);
}

TEST(CueScores, StraddlingIsEq3And4) {
  EXPECT_DOUBLE_EQ(straddling(10, 10), 10);
  EXPECT_DOUBLE_EQ(straddling(5, 10), 2.5);
  // One superpixel wholly inside, one half: (10 + 2.5) / 15.
  EXPECT_DOUBLE_EQ(straddling(straddling(10, 10) + straddling(5, 10), 15), 12.5 / 15);
  EXPECT_EQ(straddling(0.0, 0), 0);
}

TEST(CueScores, FreeSpaceIsEq5) {
  EXPECT_DOUBLE_EQ(freeSpace(120, 90, 60), 0.5);
  EXPECT_EQ(freeSpace(120, 90, 0), 0);
}

TEST(Objectness, IsTheWeightedSumOfEq6) {
  ObjectnessConfig config;
  config.weight_edges = 2, config.weight_outer = 3, config.weight_free = -5, config.constant = 7;
  CueValues cues;
  cues.edge_density = 0.5f, cues.outer_edges = 0.75f, cues.straddling = 0.25f, cues.free_space = 0.125f;
  EXPECT_DOUBLE_EQ(objectness::objectness(cues, config), 2 * 0.5 + 3 * 0.75 * 0.25 - 5 * 0.125 + 7);
}

TEST(Objectness, ScoreBoxAgreesWithCountingVoxels) {
  ObjectnessConfig config;
  config.min_edge_voxels = 1, config.min_occupied_voxels = 1, config.min_top_share = 0, config.min_straddling = 0;
  const Ring ring{1, 2};
  int scored = 0;
  for (unsigned seed = 0; seed < 30; ++seed) {
    const CueVolumes v = objectness_test::randomVolumes(seed, ring.z);
    const Box b{0, 1, v.grid.nx - 1, 0, v.grid.ny - 1, v.grid.nz - 1};
    const auto voxel = [](const IntegralVolume& volume, int x, int y, int z) {
      return volume.count(x, x + 1, y, y + 1, z, z + 1);
    };
    int edges = 0, expanded = 0, filled = 0, occupied = 0;
    for (int x = 0; x < v.grid.nx; ++x) {
      for (int y = 0; y < v.grid.ny; ++y) {
        for (int z = 0; z < v.grid.nz; ++z) {
          const bool in = x >= b.x0 && x < b.x1 && y >= b.y0 && y < b.y1 && z < b.height;
          const bool near = x >= b.x0 - 1 && x < b.x1 + 1 && y >= b.y0 - 1 && y < b.y1 + 1 && z < b.height + 2;
          edges += in && voxel(v.edges, x, y, z);
          expanded += near && voxel(v.edges, x, y, z);
          filled += in && voxel(v.filled, x, y, z);
          occupied += in && voxel(v.occupied, x, y, z);
        }
      }
    }
    const auto result = scoreBox(v, b, ring, config);
    ASSERT_EQ(result.has_value(), edges >= 1 && occupied >= 1);
    if (!result) continue;
    ++scored;
    const double area = visibleArea(b, v.viewpoint);
    EXPECT_FLOAT_EQ(result->cues.edge_density, std::min(1.0, edges / area));
    EXPECT_FLOAT_EQ(result->cues.outer_edges, static_cast<double>(edges) / expanded);
    EXPECT_FLOAT_EQ(result->cues.free_space, (b.volume() - filled) / area);
    EXPECT_EQ(result->cues.free_voxels, b.volume() - filled);
    EXPECT_FLOAT_EQ(result->objectness, static_cast<float>(objectness::objectness(result->cues, config)));
  }
  EXPECT_GT(scored, 15);
}

TEST(Objectness, EachGateRejects) {
  const Ring ring{1, 2};
  ObjectnessConfig open;
  open.min_edge_voxels = 1, open.min_occupied_voxels = 1, open.min_top_share = 0, open.min_straddling = 0;
  const CueVolumes v = objectness_test::randomVolumes(4, ring.z);
  const Box b{0, 0, v.grid.nx, 0, v.grid.ny, v.grid.nz};
  ASSERT_TRUE(scoreBox(v, b, ring, open));
  ObjectnessConfig config = open;
  config.min_edge_voxels = v.edges.total() + 1;
  EXPECT_FALSE(scoreBox(v, b, ring, config));
  config = open;
  config.min_occupied_voxels = v.occupied.total() + 1;
  EXPECT_FALSE(scoreBox(v, b, ring, config));
  config = open;
  config.min_top_share = 1;
  EXPECT_FALSE(scoreBox(v, b, ring, config));
  config = open;
  config.min_straddling = 1.01;
  EXPECT_FALSE(scoreBox(v, b, ring, config));
}
