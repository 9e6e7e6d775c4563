// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "baselines/baselines.hpp"
#include "baselines/euclidean_clusters.hpp"
#include "baselines/organized_clusters.hpp"
#include "fixtures/table_scene.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

constexpr Baseline kPclAlone[] = {Baseline::kEuclidean, Baseline::kOrganized};

}  // namespace

TEST(PclAlone, BadSettingsAreNamed) {
  Scene scene = tableWith({});
  const Frame frame = scene.render();
  BaselinesConfig settings;
  settings.euclidean.cluster_distance_m = settings.organized.plane.plane_distance_m = std::nan("");
  const Status euclidean = segmentWithBaseline(Baseline::kEuclidean, frame, Config(), settings).status;
  EXPECT_EQ(euclidean.code, StatusCode::kBadConfig);
  EXPECT_NE(euclidean.message.find("euclidean.cluster_distance_m"), std::string::npos) << euclidean.message;
  const Status organized = segmentWithBaseline(Baseline::kOrganized, frame, Config(), settings).status;
  EXPECT_NE(organized.message.find("organized.plane_distance_m"), std::string::npos) << organized.message;
}

TEST(PclAlone, FindsThePlaneOfMostPointsAndWhatStandsOnIt) {
  Scene scene = tableWith({box({-0.25, -0.05, 0}, {-0.11, 0.07, 0.2}), box({0.02, -0.1, 0}, {0.1, -0.02, 0.08})});
  const Frame frame = scene.render();
  for (const Baseline baseline : kPclAlone) {
    SCOPED_TRACE(toString(baseline));
    const Segmentation result = segmentWithBaseline(baseline, frame, Config());
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
    EXPECT_EQ(result.report.timings_ms[1].first, toString(baseline));
  }
}

TEST(PclAlone, LeavesOutWhatIsTooFarTooSmallOrTooLarge) {
  Scene scene = tableWith({box({-0.25, -0.05, 0}, {-0.11, 0.07, 0.2}), box({0.02, -0.1, 0}, {0.1, -0.02, 0.08})});
  const Frame frame = scene.render();
  const auto sizesWith = [&](const BaselinesConfig& settings, Baseline baseline) {
    std::vector<std::size_t> sizes;
    for (const Segment& s : segmentWithBaseline(baseline, frame, Config(), settings).segments)
      sizes.push_back(s.pixels.size());
    return sizes;
  };
  for (const Baseline baseline : kPclAlone) {
    const std::vector<std::size_t> sizes = sizesWith({}, baseline);
    ASSERT_EQ(sizes.size(), 2u);
    ASSERT_GT(sizes[0], sizes[1]);
    BaselinesConfig settings;
    settings.euclidean.min_pixels = settings.organized.min_pixels = static_cast<int>(sizes[1]) + 1;
    EXPECT_EQ(sizesWith(settings, baseline), std::vector<std::size_t>{sizes[0]});
    settings = {};
    settings.euclidean.max_pixels = settings.organized.max_pixels = static_cast<int>(sizes[0]) - 1;
    EXPECT_EQ(sizesWith(settings, baseline), std::vector<std::size_t>{sizes[1]});
    settings = {};
    settings.euclidean.plane.max_depth_m = settings.organized.plane.max_depth_m = 0.31;
    EXPECT_EQ(segmentWithBaseline(baseline, frame, Config(), settings).status.code, StatusCode::kNoTable);
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
  BaselinesConfig settings;
  const Segmentation result = segmentWithBaseline(Baseline::kEuclidean, frame, Config(), settings);
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
  for (const Baseline baseline : kPclAlone) {
    EXPECT_EQ(segmentWithBaseline(baseline, empty, Config()).status.code, StatusCode::kNoTable);
  }
}

TEST(PclAlone, SeesThePictureAsItIs) {
  // Nothing of the package: pixels are not averaged, however fine they are.
  Scene scene = tableWith({box({-0.25, -0.05, 0}, {-0.11, 0.07, 0.2})});
  const Frame frame = scene.render();
  Config averaged;
  averaged.resolution = {0.01, 100};
  for (const Baseline baseline : kPclAlone) {
    const Segmentation as_it_is = segmentWithBaseline(baseline, frame, Config());
    EXPECT_EQ(cv::countNonZero(as_it_is.labels != segmentWithBaseline(baseline, frame, averaged).labels), 0);
  }
}
