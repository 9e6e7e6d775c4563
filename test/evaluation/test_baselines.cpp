// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <map>
#include <opencv2/imgcodecs.hpp>

#include "baselines/baselines.hpp"
#include "evaluation/scores.hpp"
#include "fixtures/demo_images.hpp"
#include "fixtures/table_scene.hpp"
#include "fixtures/temporary_folder.hpp"
#include "objectness_segmentation/io/scene_folder.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

constexpr Baseline kBaselines[] = {Baseline::kMps, Baseline::kLccp, Baseline::kCpc};  // after the package's front end
constexpr Baseline kAllBaselines[] = {Baseline::kMps, Baseline::kLccp, Baseline::kCpc, Baseline::kEuclidean,
                                      Baseline::kOrganized};

evaluation::Scores scoresOf(const Segmentation& result, const cv::Mat_<ushort>& annotation) {
  const auto truth = evaluation::truthAtLevel(annotation, evaluation::Level::kObject);
  return evaluation::scoreLabels(result.labels, truth).value();
}

}  // namespace

TEST(Baselines, SegmentTheDemoScene) {
  const SceneImages scene = demoImages(1);
  const auto frame = makeFrame(scene.depth_mm, scene.color, scene.camera, InputConfig());
  ASSERT_TRUE(frame.ok());
  for (const Baseline baseline : kBaselines) {
    const Segmentation result = segmentWithBaseline(baseline, frame.value, Config());
    ASSERT_TRUE(result.status.ok()) << toString(baseline) << ": " << result.status.message;
    const evaluation::Scores scores = scoresOf(result, scene.true_labels);
    EXPECT_GT(scores.precision, 0.9) << toString(baseline);
    EXPECT_GT(scores.recall, 0.8) << toString(baseline);
    EXPECT_EQ(result.report.timings_ms[result.report.timings_ms.size() - 2].first, toString(baseline));
    EXPECT_EQ(result.report.timings_ms.back().first, "total");
  }
}

TEST(Baselines, SegmentsAreOfObjectPointsOnlyAndLargestFirst) {
  Scene scene = tableWith({box({-0.25, -0.05, 0}, {-0.11, 0.07, 0.2}), box({0.02, -0.1, 0}, {0.1, -0.02, 0.08})});
  const Frame frame = scene.render();
  for (const Baseline baseline : kBaselines) {
    const Segmentation result = segmentWithBaseline(baseline, frame, Config());
    ASSERT_EQ(result.segments.size(), 2u) << toString(baseline);
    EXPECT_GE(result.segments[0].pixels.size(), result.segments[1].pixels.size());
    EXPECT_EQ(labelAt(scene, result, {-0.18, 0.0, 0.2}), 2);
    EXPECT_EQ(labelAt(scene, result, {0.06, -0.06, 0.08}), 3);
    EXPECT_EQ(labelAt(scene, result, {0.4, 0.2, 0}), 1);
    for (int i = 0; i < frame.size(); ++i) {
      ASSERT_TRUE(result.labels(i) < 2 || result.object_points.mask(i)) << toString(baseline);
    }
  }
}

/// Versions of PCL differ in what an excluded label means: points of a plane must be left out, all others clustered.
TEST(Mps, LeavesOutThePointsOfPlanesAndNoOthers) {
  // From this view only the large box's front and top have 3000 pixels.
  Scene scene = tableWith({box({-0.3, -0.05, 0}, {-0.05, 0.1, 0.25}), sphere({0.15, 0, 0.05}, 0.05)});
  const Frame frame = scene.render();
  BaselinesConfig settings;
  settings.mps.min_plane_pixels = 3000;
  settings.mps.object_planes = false;
  Segmentation result = segmentWithBaseline(Baseline::kMps, frame, Config(), settings);
  EXPECT_EQ(labelAt(scene, result, {-0.18, -0.05, 0.12}), 0) << "the front of the box, a plane";
  EXPECT_GE(labelAt(scene, result, {0.15, -0.03, 0.09}), 2) << "the ball";
  EXPECT_EQ(labelAt(scene, result, {0.4, 0.2, 0}), 1) << "the table";
  settings.mps.object_planes = true;
  result = segmentWithBaseline(Baseline::kMps, frame, Config(), settings);
  EXPECT_GE(labelAt(scene, result, {-0.18, -0.05, 0.12}), 2);
  EXPECT_GE(labelAt(scene, result, {0.15, -0.03, 0.09}), 2);
  EXPECT_EQ(result.segments.size(), 2u);
}

TEST(Lccp, PartsBoxesThatTouchWhereMpsDoesNot) {
  Scene scene = tableWith({box({-0.15, 0, 0}, {0, 0.12, 0.2}), box({0, -0.06, 0}, {0.15, 0.1, 0.08})});
  const Frame frame = scene.render();
  EXPECT_EQ(segmentWithBaseline(Baseline::kMps, frame, Config()).segments.size(), 1u);
  const Segmentation lccp = segmentWithBaseline(Baseline::kLccp, frame, Config());
  EXPECT_EQ(lccp.segments.size(), 2u);
  EXPECT_NE(labelAt(scene, lccp, {-0.07, 0.06, 0.2}), labelAt(scene, lccp, {0.09, 0.06, 0.08}));
}

TEST(Cpc, CutsAnAngleThatLccpLeavesWhole) {
  // Seen from above an L of one height: its tops are one plane, its inner sides meet in a concave edge.
  Scene scene = tableWith({box({-0.2, 0.0, 0}, {0.2, 0.1, 0.12}), box({-0.2, -0.22, 0}, {-0.1, 0.0, 0.12})});
  const Frame frame = scene.render();
  EXPECT_EQ(segmentWithBaseline(Baseline::kLccp, frame, Config()).segments.size(), 1u);
  BaselinesConfig settings;
  settings.cpc.min_borders_for_cutting = 20;
  settings.cpc.min_cut_score = 0.05;
  EXPECT_GE(segmentWithBaseline(Baseline::kCpc, frame, Config(), settings).segments.size(), 2u);
}

TEST(Baselines, AnEmptyTableIsAValidResult) {
  Scene scene = tableWith({});
  const Frame frame = scene.render();
  for (const Baseline baseline : kBaselines) {
    const Segmentation result = segmentWithBaseline(baseline, frame, Config());
    EXPECT_TRUE(result.status.ok()) << toString(baseline) << ": " << result.status.message;
    EXPECT_TRUE(result.segments.empty());
  }
}

TEST(Baselines, NoTableIsSaid) {
  Scene scene = tableWith({});
  scene.surfaces = {sphere({0, 0, 0.3}, 0.2)};
  Frame empty;
  empty.camera = kinect();
  empty.points.assign(empty.size(), Eigen::Vector3f::Constant(std::nanf("")));
  for (const Baseline baseline : kBaselines) {
    const Segmentation result = segmentWithBaseline(baseline, scene.render(), Config());
    EXPECT_EQ(result.status.code, StatusCode::kNoTable);
    EXPECT_FALSE(result.status.message.empty());
    EXPECT_EQ(result.labels.rows, 480);
    EXPECT_FALSE(segmentWithBaseline(baseline, empty, Config()).status.ok());
  }
}

TEST(Baselines, BadSettingsAreNamed) {
  Scene scene = tableWith({});
  const Frame frame = scene.render();
  BaselinesConfig settings;
  settings.mps.cluster_distance_m = settings.lccp.voxel_m = settings.cpc.lccp.voxel_m = std::nan("");
  for (const Baseline baseline : kBaselines) {
    const Segmentation result = segmentWithBaseline(baseline, frame, Config(), settings);
    EXPECT_EQ(result.status.code, StatusCode::kBadConfig);
    const std::string name =
        toString(baseline) + std::string(baseline == Baseline::kMps ? ".cluster_distance_m" : ".voxel_m");
    EXPECT_NE(result.status.message.find(name), std::string::npos) << result.status.message;
  }
  settings = {};
  settings.lccp.seed_m = 0.5 * settings.lccp.voxel_m;
  EXPECT_EQ(segmentWithBaseline(Baseline::kLccp, frame, Config(), settings).status.code, StatusCode::kBadConfig);
}

TEST(Baselines, TheSameEveryTimeAndSilent) {
  const SceneImages scene = demoImages(2);
  const auto frame = makeFrame(scene.depth_mm, cv::Mat(), scene.camera, InputConfig());
  BaselinesConfig settings;
  settings.cpc.min_borders_for_cutting = 20;  // so that there are cuts, which are found by chance
  for (const Baseline baseline : kAllBaselines) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const Segmentation first = segmentWithBaseline(baseline, frame.value, Config(), settings);
    const Segmentation second = segmentWithBaseline(baseline, frame.value, Config(), settings);
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "") << toString(baseline);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << toString(baseline);
    EXPECT_EQ(cv::norm(first.labels, second.labels, cv::NORM_L1), 0) << toString(baseline);
    EXPECT_GE(first.segments.size(), 5u);
  }
}

TEST(Baselines, SettingsAreNamedInOneLine) {
  EXPECT_NE(settingsText(Baseline::kMps, {}).find("cluster_distance_m 0.008"), std::string::npos);
  EXPECT_NE(settingsText(Baseline::kLccp, {}).find("smoothness_check on"), std::string::npos);
  const std::string cpc = settingsText(Baseline::kCpc, {});
  EXPECT_NE(cpc.find("voxel_m"), std::string::npos) << cpc;
  EXPECT_NE(cpc.find("max_cuts"), std::string::npos) << cpc;
  EXPECT_EQ(cpc.find('\n'), std::string::npos);
}

TEST(Baselines, FiguresOfRecordedScenes) {
  const std::string data = sharedData();
  if (data.empty()) GTEST_SKIP() << "no shared data: set OBJECTNESS_DATA";
  std::map<Baseline, std::pair<double, double>> mean;
  const std::vector<std::string> scenes{"learn2", "learn19", "learn27", "learn36", "learn41"};
  for (const std::string& scene : scenes) {
    const std::string folder = data + "/mosd/" + scene;
    const auto frame = loadSceneFolder(folder, std::nullopt, InputConfig());
    ASSERT_TRUE(frame.ok()) << frame.status.message;
    const cv::Mat_<ushort> truth = cv::imread(folder + "/labels.png", cv::IMREAD_UNCHANGED);
    for (const Baseline baseline : kBaselines) {
      const evaluation::Scores scores = scoresOf(segmentWithBaseline(baseline, frame.value, Config()), truth);
      mean[baseline].first += scores.precision / scenes.size();
      mean[baseline].second += scores.recall / scenes.size();
    }
  }
  EXPECT_NEAR(mean[Baseline::kMps].first, 0.90, 0.04);
  EXPECT_NEAR(mean[Baseline::kMps].second, 0.915, 0.03);
  EXPECT_NEAR(mean[Baseline::kLccp].first, 0.985, 0.02);
  EXPECT_NEAR(mean[Baseline::kLccp].second, 0.91, 0.03);
  EXPECT_NEAR(mean[Baseline::kCpc].first, 0.985, 0.02);
  EXPECT_NEAR(mean[Baseline::kCpc].second, 0.91, 0.03);
}
