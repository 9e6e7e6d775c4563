// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "cues/surface_cues.hpp"
#include "fixtures/cue_view.hpp"

using namespace objectness;
using namespace objectness_test;

TEST(SurfaceCues, AreThoseFoundOneAfterTheOther) {
  Scene scene = sceneOf({kTable, box({-0.12, -0.1, 0}, {0, 0.05, 0.12}), box({0, -0.06, 0}, {0.1, 0.06, 0.08})});
  scene.s0 = 0.0003, scene.s2 = 0.001;
  const CueView view(scene);
  for (const bool for_boxes : {false, true}) {
    const SuperpixelsConfig config = for_boxes ? superpixelsForBoxes({}) : SuperpixelsConfig();
    const EdgeMap edges = findEdges(view.frame, view.normals, view.table, view.points, {});
    const Superpixels superpixels = findSuperpixels(view.frame, view.normals, view.table, view.points, config);
    EXPECT_GT(cv::countNonZero(edges.kinds), 100);
    EXPECT_GE(superpixels.count, 4);
    for (const int threads : {1, 2, 5}) {
      const SurfaceCues cues = findSurfaceCues(view.frame, view.normals, view.table, view.points, {}, config, threads);
      EXPECT_EQ(cv::countNonZero(cues.edges.kinds != edges.kinds), 0) << threads;
      EXPECT_EQ(cv::countNonZero(cues.superpixels.label != superpixels.label), 0) << threads;
      EXPECT_EQ(cues.superpixels.count, superpixels.count);
    }
  }
}
