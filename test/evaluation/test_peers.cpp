// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <map>
#include <opencv2/imgcodecs.hpp>

#include "evaluation/scores.hpp"
#include "fixtures/demo_images.hpp"
#include "fixtures/table_scene.hpp"
#include "fixtures/temporary_folder.hpp"
#include "objectness_segmentation/io/scene_folder.hpp"
#include "peers/peers.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

constexpr Peer kPeers[] = {Peer::kMps, Peer::kLccp, Peer::kCpc};  // after the package's front end
constexpr Peer kAllPeers[] = {Peer::kMps, Peer::kLccp, Peer::kCpc, Peer::kEuclidean, Peer::kOrganized};

evaluation::Scores scoresOf(const Segmentation& result, const cv::Mat_<ushort>& annotation) {
  const auto truth = evaluation::truthAtLevel(annotation, evaluation::Level::kObject);
  return evaluation::scoreLabels(result.labels, truth).value();
}

}  // namespace

TEST(Peers, SegmentTheDemoScene) {
  const SceneImages scene = demoImages(1);
  const auto frame = makeFrame(scene.depth_mm, scene.color, scene.camera, InputConfig());
  ASSERT_TRUE(frame.ok());
  for (const Peer peer : kPeers) {
    const Segmentation result = segmentWithPeer(peer, frame.value, Config());
    ASSERT_TRUE(result.status.ok()) << toString(peer) << ": " << result.status.message;
    const evaluation::Scores scores = scoresOf(result, scene.true_labels);
    EXPECT_GT(scores.precision, 0.9) << toString(peer);
    EXPECT_GT(scores.recall, 0.8) << toString(peer);
    EXPECT_EQ(result.report.timings_ms[result.report.timings_ms.size() - 2].first, toString(peer));
    EXPECT_EQ(result.report.timings_ms.back().first, "total");
  }
}

TEST(Peers, SegmentsAreOfObjectPointsOnlyAndLargestFirst) {
  Scene scene = tableWith({box({-0.25, -0.05, 0}, {-0.11, 0.07, 0.2}), box({0.02, -0.1, 0}, {0.1, -0.02, 0.08})});
  const Frame frame = scene.render();
  for (const Peer peer : kPeers) {
    const Segmentation result = segmentWithPeer(peer, frame, Config());
    ASSERT_EQ(result.segments.size(), 2u) << toString(peer);
    EXPECT_GE(result.segments[0].pixels.size(), result.segments[1].pixels.size());
    EXPECT_EQ(labelAt(scene, result, {-0.18, 0.0, 0.2}), 2);
    EXPECT_EQ(labelAt(scene, result, {0.06, -0.06, 0.08}), 3);
    EXPECT_EQ(labelAt(scene, result, {0.4, 0.2, 0}), 1);
    for (int i = 0; i < frame.size(); ++i) {
      ASSERT_TRUE(result.labels(i) < 2 || result.object_points.mask(i)) << toString(peer);
    }
  }
}

/// Versions of PCL differ in what an excluded label means: points of a plane must be left out, all others clustered.
TEST(Mps, LeavesOutThePointsOfPlanesAndNoOthers) {
  // From this view only the large box's front and top have 3000 pixels.
  Scene scene = tableWith({box({-0.3, -0.05, 0}, {-0.05, 0.1, 0.25}), sphere({0.15, 0, 0.05}, 0.05)});
  const Frame frame = scene.render();
  PeersConfig settings;
  settings.mps.min_plane_pixels = 3000;
  settings.mps.object_planes = false;
  Segmentation result = segmentWithPeer(Peer::kMps, frame, Config(), settings);
  EXPECT_EQ(labelAt(scene, result, {-0.18, -0.05, 0.12}), 0) << "the front of the box, a plane";
  EXPECT_GE(labelAt(scene, result, {0.15, -0.03, 0.09}), 2) << "the ball";
  EXPECT_EQ(labelAt(scene, result, {0.4, 0.2, 0}), 1) << "the table";
  settings.mps.object_planes = true;
  result = segmentWithPeer(Peer::kMps, frame, Config(), settings);
  EXPECT_GE(labelAt(scene, result, {-0.18, -0.05, 0.12}), 2);
  EXPECT_GE(labelAt(scene, result, {0.15, -0.03, 0.09}), 2);
  EXPECT_EQ(result.segments.size(), 2u);
}

TEST(Lccp, PartsBoxesThatTouchWhereMpsDoesNot) {
  Scene scene = tableWith({box({-0.15, 0, 0}, {0, 0.12, 0.2}), box({0, -0.06, 0}, {0.15, 0.1, 0.08})});
  const Frame frame = scene.render();
  EXPECT_EQ(segmentWithPeer(Peer::kMps, frame, Config()).segments.size(), 1u);
  const Segmentation lccp = segmentWithPeer(Peer::kLccp, frame, Config());
  EXPECT_EQ(lccp.segments.size(), 2u);
  EXPECT_NE(labelAt(scene, lccp, {-0.07, 0.06, 0.2}), labelAt(scene, lccp, {0.09, 0.06, 0.08}));
}

TEST(Cpc, CutsAnAngleThatLccpLeavesWhole) {
  // Seen from above an L of one height: its tops are one plane, its inner sides meet in a concave edge.
  Scene scene = tableWith({box({-0.2, 0.0, 0}, {0.2, 0.1, 0.12}), box({-0.2, -0.22, 0}, {-0.1, 0.0, 0.12})});
  const Frame frame = scene.render();
  EXPECT_EQ(segmentWithPeer(Peer::kLccp, frame, Config()).segments.size(), 1u);
  PeersConfig settings;
  settings.cpc.min_borders_for_cutting = 20;
  settings.cpc.min_cut_score = 0.05;
  EXPECT_GE(segmentWithPeer(Peer::kCpc, frame, Config(), settings).segments.size(), 2u);
}

TEST(Peers, AnEmptyTableIsAValidResult) {
  Scene scene = tableWith({});
  const Frame frame = scene.render();
  for (const Peer peer : kPeers) {
    const Segmentation result = segmentWithPeer(peer, frame, Config());
    EXPECT_TRUE(result.status.ok()) << toString(peer) << ": " << result.status.message;
    EXPECT_TRUE(result.segments.empty());
  }
}

TEST(Peers, NoTableIsSaid) {
  Scene scene = tableWith({});
  scene.surfaces = {sphere({0, 0, 0.3}, 0.2)};
  Frame empty;
  empty.camera = kinect();
  empty.points.assign(empty.size(), Eigen::Vector3f::Constant(std::nanf("")));
  for (const Peer peer : kPeers) {
    const Segmentation result = segmentWithPeer(peer, scene.render(), Config());
    EXPECT_EQ(result.status.code, StatusCode::kNoTable);
    EXPECT_FALSE(result.status.message.empty());
    EXPECT_EQ(result.labels.rows, 480);
    EXPECT_FALSE(segmentWithPeer(peer, empty, Config()).status.ok());
  }
}

TEST(Peers, BadSettingsAreNamed) {
  Scene scene = tableWith({});
  const Frame frame = scene.render();
  PeersConfig settings;
  settings.mps.cluster_distance_m = settings.lccp.voxel_m = settings.cpc.lccp.voxel_m = std::nan("");
  for (const Peer peer : kPeers) {
    const Segmentation result = segmentWithPeer(peer, frame, Config(), settings);
    EXPECT_EQ(result.status.code, StatusCode::kBadConfig);
    const std::string name = toString(peer) + std::string(peer == Peer::kMps ? ".cluster_distance_m" : ".voxel_m");
    EXPECT_NE(result.status.message.find(name), std::string::npos) << result.status.message;
  }
  settings = {};
  settings.lccp.seed_m = 0.5 * settings.lccp.voxel_m;
  EXPECT_EQ(segmentWithPeer(Peer::kLccp, frame, Config(), settings).status.code, StatusCode::kBadConfig);
}

TEST(Peers, TheSameEveryTimeAndSilent) {
  const SceneImages scene = demoImages(2);
  const auto frame = makeFrame(scene.depth_mm, cv::Mat(), scene.camera, InputConfig());
  PeersConfig settings;
  settings.cpc.min_borders_for_cutting = 20;  // so that there are cuts, which are found by chance
  for (const Peer peer : kAllPeers) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const Segmentation first = segmentWithPeer(peer, frame.value, Config(), settings);
    const Segmentation second = segmentWithPeer(peer, frame.value, Config(), settings);
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "") << toString(peer);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << toString(peer);
    EXPECT_EQ(cv::norm(first.labels, second.labels, cv::NORM_L1), 0) << toString(peer);
    EXPECT_GE(first.segments.size(), 5u);
  }
}

TEST(Peers, SettingsAreNamedInOneLine) {
  EXPECT_NE(settingsText(Peer::kMps, {}).find("cluster_distance_m 0.008"), std::string::npos);
  EXPECT_NE(settingsText(Peer::kLccp, {}).find("smoothness_check on"), std::string::npos);
  const std::string cpc = settingsText(Peer::kCpc, {});
  EXPECT_NE(cpc.find("voxel_m"), std::string::npos) << cpc;
  EXPECT_NE(cpc.find("max_cuts"), std::string::npos) << cpc;
  EXPECT_EQ(cpc.find('\n'), std::string::npos);
}

TEST(Peers, FiguresOfRecordedScenes) {
  const std::string data = sharedData();
  if (data.empty()) GTEST_SKIP() << "no shared data: set OBJECTNESS_DATA";
  std::map<Peer, std::pair<double, double>> mean;
  const std::vector<std::string> scenes{"learn2", "learn19", "learn27", "learn36", "learn41"};
  for (const std::string& scene : scenes) {
    const std::string folder = data + "/mosd/" + scene;
    const auto frame = loadSceneFolder(folder, std::nullopt, InputConfig());
    ASSERT_TRUE(frame.ok()) << frame.status.message;
    const cv::Mat_<ushort> truth = cv::imread(folder + "/labels.png", cv::IMREAD_UNCHANGED);
    for (const Peer peer : kPeers) {
      const evaluation::Scores scores = scoresOf(segmentWithPeer(peer, frame.value, Config()), truth);
      mean[peer].first += scores.precision / scenes.size();
      mean[peer].second += scores.recall / scenes.size();
    }
  }
  EXPECT_NEAR(mean[Peer::kMps].first, 0.90, 0.04);
  EXPECT_NEAR(mean[Peer::kMps].second, 0.915, 0.03);
  EXPECT_NEAR(mean[Peer::kLccp].first, 0.985, 0.02);
  EXPECT_NEAR(mean[Peer::kLccp].second, 0.91, 0.03);
  EXPECT_NEAR(mean[Peer::kCpc].first, 0.985, 0.02);
  EXPECT_NEAR(mean[Peer::kCpc].second, 0.91, 0.03);
}
