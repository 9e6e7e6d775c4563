// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <map>
#include <opencv2/imgcodecs.hpp>
#include <random>

#include "../src/peers/euclidean_clusters.hpp"
#include "../src/peers/organized_clusters.hpp"
#include "fixtures/demo_images.hpp"
#include "fixtures/ray_cast.hpp"
#include "fixtures/temporary_folder.hpp"
#include "objectness_segmentation/evaluation/scores.hpp"
#include "objectness_segmentation/io/scene_folder.hpp"
#include "objectness_segmentation/peers/peers.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

constexpr Peer kPeers[] = {Peer::kMps, Peer::kLccp, Peer::kCpc};  // after the package's front end
constexpr Peer kPclAlone[] = {Peer::kEuclidean, Peer::kOrganized};
constexpr Peer kAllPeers[] = {Peer::kMps, Peer::kLccp, Peer::kCpc, Peer::kEuclidean, Peer::kOrganized};

Scene tableWith(std::vector<Surface> objects) {
  Scene scene;
  scene.surfaces = {slab(-5, -5, 5, 5, -0.7), slab(-0.6, -0.4, 0.6, 0.4, 0)};
  scene.surfaces.insert(scene.surfaces.end(), objects.begin(), objects.end());
  scene.s0 = 0.0003, scene.s2 = 0.0008;
  return scene;
}

int labelAt(const Scene& scene, const Segmentation& result, const Eigen::Vector3d& world) {
  const Eigen::Vector2d p = scene.camera.project(scene.T_world_camera.inverse() * world);
  return result.labels(static_cast<int>(std::lround(p.y())), static_cast<int>(std::lround(p.x())));
}

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

TEST(PclAlone, BadSettingsAreNamed) {
  Scene scene = tableWith({});
  const Frame frame = scene.render();
  PeersConfig settings;
  settings.euclidean.cluster_distance_m = settings.organized.plane.plane_distance_m = std::nan("");
  const Status euclidean = segmentWithPeer(Peer::kEuclidean, frame, Config(), settings).status;
  EXPECT_EQ(euclidean.code, StatusCode::kBadConfig);
  EXPECT_NE(euclidean.message.find("euclidean.cluster_distance_m"), std::string::npos) << euclidean.message;
  const Status organized = segmentWithPeer(Peer::kOrganized, frame, Config(), settings).status;
  EXPECT_NE(organized.message.find("organized.plane_distance_m"), std::string::npos) << organized.message;
}

TEST(PclAlone, FindsThePlaneOfMostPointsAndWhatStandsOnIt) {
  Scene scene = tableWith({box({-0.25, -0.05, 0}, {-0.11, 0.07, 0.2}), box({0.02, -0.1, 0}, {0.1, -0.02, 0.08})});
  const Frame frame = scene.render();
  for (const Peer peer : kPclAlone) {
    SCOPED_TRACE(toString(peer));
    const Segmentation result = segmentWithPeer(peer, frame, Config());
    ASSERT_TRUE(result.status.ok()) << result.status.message;
    const Eigen::Vector3d up = scene.T_world_camera.linear().transpose() * Eigen::Vector3d::UnitZ();
    EXPECT_GT(result.table.normal.dot(up), std::cos(M_PI / 180));
    EXPECT_NEAR(result.table.d, scene.T_world_camera.translation().z(), 0.005);
    EXPECT_EQ(result.segments.size(), 2u);
    EXPECT_EQ(labelAt(scene, result, {-0.18, 0.0, 0.2}), 2);
    EXPECT_EQ(labelAt(scene, result, {0.06, -0.06, 0.08}), 3);
    EXPECT_EQ(labelAt(scene, result, {0.4, 0.2, 0}), 1);
    for (int i = 0; i < frame.size(); ++i) {
      const float z = frame.points[i].z();
      ASSERT_TRUE(result.labels(i) < 2 || (result.object_points.mask(i) && z > 0.3f && z < 1.5f));
    }
    EXPECT_EQ(result.report.timings_ms[0].first, "plane");
    EXPECT_EQ(result.report.timings_ms[1].first, toString(peer));
  }
}

TEST(PclAlone, LeavesOutWhatIsTooFarTooSmallOrTooLarge) {
  Scene scene = tableWith({box({-0.25, -0.05, 0}, {-0.11, 0.07, 0.2}), box({0.02, -0.1, 0}, {0.1, -0.02, 0.08})});
  const Frame frame = scene.render();
  const auto sizesWith = [&](const PeersConfig& settings, Peer peer) {
    std::vector<std::size_t> sizes;
    for (const Segment& s : segmentWithPeer(peer, frame, Config(), settings).segments) sizes.push_back(s.pixels.size());
    return sizes;
  };
  for (const Peer peer : kPclAlone) {
    const std::vector<std::size_t> sizes = sizesWith({}, peer);
    ASSERT_EQ(sizes.size(), 2u);
    ASSERT_GT(sizes[0], sizes[1]);
    PeersConfig settings;
    settings.euclidean.min_pixels = settings.organized.min_pixels = static_cast<int>(sizes[1]) + 1;
    EXPECT_EQ(sizesWith(settings, peer), std::vector<std::size_t>{sizes[0]});
    settings = {};
    settings.euclidean.max_pixels = settings.organized.max_pixels = static_cast<int>(sizes[0]) - 1;
    EXPECT_EQ(sizesWith(settings, peer), std::vector<std::size_t>{sizes[1]});
    settings = {};
    settings.euclidean.plane.max_depth_m = settings.organized.plane.max_depth_m = 0.31;
    EXPECT_EQ(segmentWithPeer(peer, frame, Config(), settings).status.code, StatusCode::kNoTable);
  }
}

TEST(PclAlone, ClustersAreThoseOfAPlainLoop) {
  // Points that jump about: what is near in space may be far apart in the image.
  std::mt19937 random(3);
  Frame frame;
  frame.camera = {60, 60, 19.5, 14.5, 40, 30};
  cv::Mat_<uchar> mask(30, 40);
  for (int i = 0; i < frame.size(); ++i) {
    const double z = 0.6 + 0.004 * (random() % 8);
    frame.points.push_back((z * frame.camera.ray(i % 40, i / 40)).cast<float>());
    mask(i) = random() % 3 ? 255 : 0;
  }
  constexpr float kDistance_m = 0.0125f;
  const auto expectSame = [&](const std::vector<int>& labels, bool in_image) {
    std::vector<int> component(frame.size());
    for (int i = 0; i < frame.size(); ++i) component[i] = i;
    for (bool changed = true; changed;) {
      changed = false;
      for (int a = 0; a < frame.size(); ++a) {
        for (int b = 0; b < a; ++b) {
          const int apart_px = std::abs(a % 40 - b % 40) + std::abs(a / 40 - b / 40);
          if (!mask(a) || !mask(b) || component[a] == component[b] || (in_image && apart_px != 1)) continue;
          if ((frame.points[a] - frame.points[b]).norm() >= kDistance_m) continue;
          component[a] = component[b] = std::min(component[a], component[b]);
          changed = true;
        }
      }
    }
    std::map<int, int> of_label, of_component;
    for (int i = 0; i < frame.size(); ++i) {
      ASSERT_EQ(labels[i] > 0, mask(i) != 0);
      if (!mask(i)) continue;
      of_label.emplace(labels[i], component[i]);
      of_component.emplace(component[i], labels[i]);
      ASSERT_EQ(of_label[labels[i]], component[i]);
      ASSERT_EQ(of_component[component[i]], labels[i]);
    }
    EXPECT_GT(of_label.size(), 5u);
    EXPECT_LT(of_label.size(), 500u);
  };
  EuclideanConfig config;
  config.voxel_m = 0;
  config.cluster_distance_m = kDistance_m;
  expectSame(labelEuclideanClusters(frame, mask, config), false);
  expectSame(labelOrganizedClusters(frame, mask, kDistance_m, false), true);
}

TEST(PclAlone, VoxelsGiveEveryPointALabel) {
  Scene scene = tableWith({box({-0.25, -0.05, 0}, {-0.11, 0.07, 0.2}), box({0.02, -0.1, 0}, {0.1, -0.02, 0.08})});
  const Frame frame = scene.render();
  PeersConfig settings;
  const Segmentation result = segmentWithPeer(Peer::kEuclidean, frame, Config(), settings);
  const std::vector<int> labels = labelEuclideanClusters(frame, result.object_points.mask, settings.euclidean);
  int points = 0, labelled = 0;
  for (int i = 0; i < frame.size(); ++i) {
    points += result.object_points.mask(i) != 0;
    labelled += labels[i] > 0;
  }
  EXPECT_GT(points, 5000);
  EXPECT_GT(labelled, 0.999 * points);
}

TEST(PclAlone, NoPlaneIsSaid) {
  Frame empty;
  empty.camera = kinect();
  empty.points.assign(empty.size(), Eigen::Vector3f::Constant(std::nanf("")));
  for (const Peer peer : kPclAlone) {
    EXPECT_EQ(segmentWithPeer(peer, empty, Config()).status.code, StatusCode::kNoTable);
  }
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
