// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "fixtures/cue_scene.hpp"
#include "fixtures/temporary_folder.hpp"
#include "integral/integral_volume.hpp"
#include "integral/voxelizer.hpp"
#include "objectness_segmentation/io/scene_folder.hpp"
#include "reference/plain_voxels.hpp"
#include "search/box_sampler.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

/// Marks every angle both ways; returns the occluded voxels met.
long expectPlainVoxels(const CueScene& scene, const VolumeConfig& config, double max_size_m, int threads) {
  const int margin = 3, tallest = static_cast<int>(max_size_m / config.voxel_m);
  Voxelizer marker(scene.points, config);
  std::vector<Grid> grids;
  for (const double angle : sampledAngles(SearchConfig())) {
    grids.push_back(marker.gridAt(angle, margin, 3, tallest));
    const Grid plain = makeGrid(scene.points, angle, config, margin, 3, tallest);
    EXPECT_EQ(grids.back().origin_m, plain.origin_m);
    EXPECT_EQ(std::tie(grids.back().nx, grids.back().ny, grids.back().nz), std::tie(plain.nx, plain.ny, plain.nz));
  }
  marker.prepare(scene.frame, scene.table, grids, threads);
  Voxelizer::Scratch scratch;
  CueVoxels marked;
  long hidden = 0;
  for (const Grid& grid : grids) {
    marker.mark(grid, scratch, marked);
    const CueVoxels plain = markVoxelsPlain(scene.frame, scene.table, scene.points, grid, config);
    EXPECT_TRUE(marked.edges == plain.edges);
    EXPECT_TRUE(marked.occupied == plain.occupied);
    EXPECT_TRUE(marked.filled == plain.filled);
    EXPECT_EQ(marked.superpixels.size(), plain.superpixels.size());
    if (::testing::Test::HasFailure()) return 0;
    for (std::size_t s = 0; s < plain.superpixels.size(); ++s) {
      EXPECT_EQ(marked.superpixels[s].x0, plain.superpixels[s].x0);
      EXPECT_EQ(marked.superpixels[s].y0, plain.superpixels[s].y0);
      EXPECT_TRUE(marked.superpixels[s].voxels == plain.superpixels[s].voxels);
    }
    hidden += IntegralVolume(plain.filled).total() - IntegralVolume(plain.occupied).total();
  }
  return hidden;
}

}  // namespace

TEST(Voxelizer, MarksTheVoxelsOfThePlainLoop) {
  const CueScene scene = simulatedCueScene();
  ASSERT_GT(scene.points.superpixels, 2);
  EXPECT_GT(expectPlainVoxels(scene, VolumeConfig(), 0.45, 1), 1000) << "there must be hidden space to find";
  EXPECT_GT(expectPlainVoxels(scene, VolumeConfig(), 0.45, 2), 1000);
}

TEST(Voxelizer, InAWideVolumeWithUnknownSpaceHidden) {
  const CueScene scene = simulatedCueScene();
  VolumeConfig wide;
  wide.min_extent_m = 1.6;
  wide.min_height_m = 0.45;
  wide.unknown_is_occluded = true;
  EXPECT_GT(expectPlainVoxels(scene, wide, 0.45, 2), 1000);
}

TEST(Voxelizer, InColumnsOfMoreThanOneWord) {
  const CueScene scene = simulatedCueScene();
  VolumeConfig fine;
  fine.voxel_m = 0.004;
  fine.min_height_m = 0.3;  // 75 voxels
  EXPECT_GT(expectPlainVoxels(scene, fine, 0.4, 2), 1000);
}

TEST(Voxelizer, PointsOverTheTopOfTheGridAreLeftOut) {
  EXPECT_GT(expectPlainVoxels(simulatedCueScene(), VolumeConfig(), 0.09, 1), 100);
}

TEST(Voxelizer, MarksTheVoxelsOfThePlainLoopOnARealScene) {
  const std::string data = sharedData();
  if (data.empty()) GTEST_SKIP() << "no shared data: set OBJECTNESS_DATA";
  const auto read = loadSceneFolder(data + "/mosd/test55", std::nullopt, InputConfig());
  ASSERT_TRUE(read.ok()) << read.status.message;
  EXPECT_GT(expectPlainVoxels(cueScene(read.value), VolumeConfig(), 0.45, 2), 1000);
}
