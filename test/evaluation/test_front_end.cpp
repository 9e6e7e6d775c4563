// SPDX-License-Identifier: BSD-3-Clause
// Both methods, the learning and the baselines start from one observation of a frame.
#include <gtest/gtest.h>

#include <cstring>

#include "baselines/baselines.hpp"
#include "fixtures/demo_images.hpp"
#include "front_end.hpp"
#include "learning/training_scene.hpp"
#include "objectness_segmentation/pipeline.hpp"

using namespace objectness;

namespace {

constexpr Baseline kBaselinesOnTheTable[] = {Baseline::kMps, Baseline::kLccp, Baseline::kCpc};

template <class T>
bool sameBits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

template <class T>
bool sameBits(const cv::Mat_<T>& a, const cv::Mat_<T>& b) {
  return a.size() == b.size() && a.isContinuous() && b.isContinuous() &&
         std::memcmp(a.data, b.data, a.total() * sizeof(T)) == 0;
}

void expectSameTable(const SceneObservation& a, const SceneObservation& b) {
  EXPECT_TRUE(sameBits(a.normals.normal, b.normals.normal));
  EXPECT_TRUE(sameBits(a.normals.residual_m, b.normals.residual_m));
  EXPECT_TRUE(sameBits(a.normals.depth_m, b.normals.depth_m));
  EXPECT_TRUE(sameBits(a.normals.jump, b.normals.jump));
  EXPECT_TRUE(sameBits(a.normals.radius_px, b.normals.radius_px));
  EXPECT_EQ(a.table.normal, b.table.normal);
  EXPECT_EQ(a.table.d, b.table.d);
  EXPECT_EQ(a.table.T_table_camera.matrix(), b.table.T_table_camera.matrix());
  EXPECT_TRUE(sameBits(a.table.hull, b.table.hull));
  EXPECT_TRUE(sameBits(a.table.hull_measured, b.table.hull_measured));
  EXPECT_TRUE(sameBits(a.table.extent.cells, b.table.extent.cells));
  EXPECT_EQ(a.table.noise.constant_m, b.table.noise.constant_m);
  EXPECT_EQ(a.table.noise.quadratic_per_m, b.table.noise.quadratic_per_m);
  EXPECT_TRUE(sameBits(a.object_points.height_m, b.object_points.height_m));
  EXPECT_TRUE(sameBits(a.object_points.mask, b.object_points.mask));
  EXPECT_TRUE(sameBits(a.object_points.on_table, b.object_points.on_table));
}

void expectSameScene(const SceneObservation& a, const SceneObservation& b) {
  expectSameTable(a, b);
  EXPECT_TRUE(sameBits(a.edges.kinds, b.edges.kinds));
  EXPECT_TRUE(sameBits(a.superpixels.label, b.superpixels.label));
  EXPECT_EQ(a.superpixels.count, b.superpixels.count);
}

struct DemoScene {
  DemoScene() {
    const SceneImages images = demoImages(1);
    frame = makeFrame(images.depth_mm, images.color, images.camera, {}).value;
    truth = images.true_labels;
  }
  Frame frame;
  cv::Mat_<ushort> truth;
};

}  // namespace

TEST(FrontEnd, BothMethodsTheLearningAndTheBaselinesObserveTheSame) {
  const DemoScene scene;
  Config config;
  config.normals.max_error_deg = 0.5;  // normals are refined: a front end that leaves this out shows
  const Segmentation found = segment(scene.frame, config);
  ASSERT_TRUE(found.status.ok()) << found.status.message;
  ASSERT_GT(found.superpixels.count, 5);
  ASSERT_FALSE(sameBits(found.normals.normal, estimateNormals(scene.frame, config.normals).normal));

  for (const int threads : {1, 3}) {
    config.runtime.threads = threads;
    expectSameScene(observe(scene.frame, scene.truth, config), found);
    for (const Baseline baseline : kBaselinesOnTheTable) {
      SCOPED_TRACE(toString(baseline));
      expectSameTable(segmentWithBaseline(baseline, scene.frame, config), found);
    }
  }

  config.pipeline.method = SegmentationMethod::kPaper;
  const Segmentation paper = segment(scene.frame, config);
  expectSameTable(paper, found);
  EXPECT_TRUE(sameBits(paper.edges.kinds, found.edges.kinds));
  EXPECT_FALSE(sameBits(paper.superpixels.label, found.superpixels.label)) << "the paper's boxes have their own";
  expectSameScene(observe(scene.frame, scene.truth, config), found);  // learning is for groups, whatever segments
}

TEST(FrontEnd, BaselinesAreTimedStageByStageLikeTheMethods) {
  const DemoScene scene;
  const auto stagesOf = [](const Segmentation& result) {
    std::vector<std::string> names;
    for (const auto& [name, ms] : result.report.timings_ms) names.push_back(name);
    return names;
  };
  std::vector<std::string> expected = stagesOf(segment(scene.frame, {}));
  expected.resize(4);
  EXPECT_EQ(expected.back(), "object_points");
  for (const Baseline baseline : kBaselinesOnTheTable) {
    std::vector<std::string> stages = stagesOf(segmentWithBaseline(baseline, scene.frame, {}));
    ASSERT_EQ(stages.size(), 6u);
    EXPECT_EQ(stages[4], toString(baseline));
    stages.resize(4);
    EXPECT_EQ(stages, expected);
  }
}

TEST(FrontEnd, TornDepthIsRefusedByAll) {
  DemoScene scene;
  for (int i = 0; i < scene.frame.size(); ++i) {
    if ((i / scene.frame.width() + i % scene.frame.width()) % 2) scene.frame.points[i].setConstant(std::nanf(""));
  }
  const Status status = segment(scene.frame, {}).status;
  EXPECT_EQ(status.code, StatusCode::kBadInput);
  EXPECT_EQ(observe(scene.frame, scene.truth, {}).status.message, status.message);
  for (const Baseline baseline : kBaselinesOnTheTable) {
    EXPECT_EQ(segmentWithBaseline(baseline, scene.frame, {}).status.message, status.message);
  }
}

TEST(FrontEnd, KeepsWhatWasFoundBeforeItWasCancelled) {
  const DemoScene scene;
  std::atomic<bool> cancel{false};
  Report report;
  const Stages stages(&cancel, report);
  SceneObservation seen;
  observeTable(scene.frame, {}, stages, seen);
  cancel = true;
  EXPECT_THROW(observeScene(scene.frame, {}, stages, seen), Cancelled);
  EXPECT_GT(cv::countNonZero(seen.object_points.mask), 0);
  EXPECT_TRUE(seen.edges.kinds.empty());
}
