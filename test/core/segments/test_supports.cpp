// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "fixtures/seen_surfaces.hpp"
#include "objectness_segmentation/pipeline.hpp"
#include "segments/supports.hpp"
#include "sim/scene_generator.hpp"
#include "sim/simulated_frame.hpp"

using namespace objectness;
using namespace objectness_test;
using Eigen::Vector3d;

namespace {

/// Heights of the lowest and the highest corner.
std::pair<double, double> heightsOf(const OrientedBox& box, const Eigen::Isometry3d& T_world_camera) {
  double low = 1e9, high = -1e9;
  for (int i = 0; i < 8; ++i) {
    const Vector3d sign((i & 1) - 0.5, (i >> 1 & 1) - 0.5, (i >> 2) - 0.5);
    const double z = (T_world_camera * box.T_camera_box * sign.cwiseProduct(box.size_m)).z();
    low = std::min(low, z), high = std::max(high, z);
  }
  return {low, high};
}

/// By segment, what is wrong with the heights of its box.
struct Errors {
  std::vector<double> low, high;

  static double worst(std::vector<double> errors, double share) {
    for (double& error : errors) error = std::abs(error);
    std::sort(errors.begin(), errors.end());
    return errors[static_cast<std::size_t>(share * (errors.size() - 1))];
  }
};

/// Of the things that were found well, upright ones of a kind that has a flat top.
Errors errorsOf(const std::string& level, const sim::DepthSensor& sensor, int scenes, const Config& config = {}) {
  Errors errors;
  for (int index = 0; index < scenes; ++index) {
    sim::SceneRequest request;
    request.level = level;
    request.seed = 8;
    request.index = static_cast<std::uint32_t>(index);
    request.camera = sensor.camera;
    const auto scene = sim::generateScene(request);
    EXPECT_TRUE(scene.ok()) << scene.status.message;
    if (!scene.ok()) continue;
    const auto truth = sim::simulateFrame(scene.value, scene.value.T_world_camera, sensor, request.index);
    const Frame frame = makeFrame(truth.images.depth_mm, cv::Mat(), truth.images.camera, InputConfig()).value;
    const Segmentation result = segment(frame, config);
    EXPECT_TRUE(result.status.ok()) << result.status.message;
    for (const sim::TrueObject& object : truth.objects) {
      if (object.hidden || (object.kind != "box" && object.kind != "cylinder")) continue;
      const int own = cv::countNonZero(truth.images.true_labels == object.label);
      for (const Segment& found : result.segments) {
        int shared = 0;
        for (const int pixel : found.pixels) shared += truth.images.true_labels(pixel) == object.label;
        if (2.0 * shared / (own + found.pixels.size()) < 0.9) continue;
        const auto [low, high] = heightsOf(found.box, truth.T_world_camera);
        const auto [true_low, true_high] = heightsOf(object.box, truth.T_world_camera);
        errors.low.push_back(low - true_low);
        errors.high.push_back(high - true_high);
      }
    }
  }
  return errors;
}

/// Surfaces with what they stand on; their boxes rest there.
struct Sight : SeenSurfaces {
  std::vector<Support> supports;

  explicit Sight(Scene given, std::size_t first, std::size_t without = 0)
      : SeenSurfaces(std::move(given), first, without) {
    rest();
  }

  void rest() {
    supports = findSupports(frame, normals, table, above, segments);
    for (std::size_t k = 0; k < segments.size(); ++k) restBox(table, supports[k].height_m, segments[k].box);
  }

  /// Lowest and highest corner of the box around the k-th segment.
  std::pair<double, double> heights(std::size_t k) const { return heightsOf(segments[k].box, scene.T_world_camera); }
};

}  // namespace

TEST(Supports, OfIdealScenesHaveTheTrueHeights) {
  sim::DepthSensor ideal;
  ideal.ideal = true;
  for (const char* level : {"boxes", "shapes", "stacked"}) {
    SCOPED_TRACE(level);
    const Errors errors = errorsOf(level, ideal, 12);
    ASSERT_GT(errors.low.size(), 10u);
    EXPECT_LT(Errors::worst(errors.low, 0.9), 0.002);
    EXPECT_LT(Errors::worst(errors.high, 0.9), 0.002);
  }
}

TEST(Supports, ReachWhatTheyStandOnDespiteNoise) {
  for (const char* level : {"boxes", "stacked"}) {
    SCOPED_TRACE(level);
    const Errors errors = errorsOf(level, sim::DepthSensor(), 12);
    ASSERT_GT(errors.low.size(), 10u);
    EXPECT_LT(Errors::worst(errors.low, 0.9), 0.005);
  }
}

TEST(Supports, OfThePaperReachTheTable) {
  sim::DepthSensor ideal;
  ideal.ideal = true;
  Config paper;
  paper.pipeline.method = SegmentationMethod::kPaper;
  paper.search.angle_step_deg = 15;
  const Errors errors = errorsOf("boxes", ideal, 4, paper);
  ASSERT_GT(errors.low.size(), 4u);
  EXPECT_LT(Errors::worst(errors.low, 1), 0.002);
}

TEST(Supports, AThingOnATopThatIsSeenAroundIt) {
  const Sight sight(onATable({box({-0.15, -0.1, 0}, {0.15, 0.1, 0.08}), box({-0.05, -0.04, 0.08}, {0.05, 0.04, 0.2})}),
                    1);
  EXPECT_NEAR(sight.heights(0).first, 0, 0.001);
  EXPECT_NEAR(sight.heights(0).second, 0.08, 0.001);
  EXPECT_NEAR(sight.heights(1).first, 0.08, 0.001);
  EXPECT_NEAR(sight.heights(1).second, 0.2, 0.001);
  EXPECT_EQ(sight.supports[0].kind, SupportKind::kTable);
  EXPECT_EQ(sight.supports[0].segment, -1);
  EXPECT_EQ(sight.supports[0].height_m, 0);
  EXPECT_EQ(sight.supports[1].kind, SupportKind::kSegment);
  EXPECT_EQ(sight.supports[1].segment, 0);
  EXPECT_NEAR(sight.supports[1].height_m, 0.08, 0.001);
}

TEST(Supports, OfAStackNameWhatIsDirectlyUnder) {
  const Sight sight(onATable({box({-0.05, -0.04, 0.13}, {0.05, 0.04, 0.2}), box({-0.15, -0.1, 0}, {0.15, 0.1, 0.08}),
                              box({0.2, -0.1, 0}, {0.3, 0, 0.1}), box({-0.08, -0.07, 0.08}, {0.08, 0.07, 0.13})}),
                    1);
  EXPECT_EQ(sight.supports[0].segment, 3);
  EXPECT_EQ(sight.supports[1].segment, -1);
  EXPECT_EQ(sight.supports[2].segment, -1);
  EXPECT_EQ(sight.supports[3].segment, 1);
}

TEST(Supports, NeverGoInACircle) {
  for (const char* level : {"stacked", "clutter"}) {
    for (std::uint32_t index = 0; index < 6; ++index) {
      SCOPED_TRACE(testing::Message() << level << ' ' << index);
      sim::SceneRequest request;
      request.level = level;
      request.seed = 5;
      request.index = index;
      request.camera = sim::DepthSensor().camera;
      const auto scene = sim::generateScene(request);
      ASSERT_TRUE(scene.ok());
      const auto truth = sim::simulateFrame(scene.value, scene.value.T_world_camera, sim::DepthSensor(), index);
      const Frame frame = makeFrame(truth.images.depth_mm, cv::Mat(), truth.images.camera, InputConfig()).value;
      const std::vector<Segment> segments = segment(frame, Config()).segments;
      for (std::size_t k = 0; k < segments.size(); ++k) {
        std::size_t steps = 0;
        int at = static_cast<int>(k);
        while (segments[at].support.kind == SupportKind::kSegment && ++steps <= segments.size()) {
          const int under = segments[at].support.segment;
          ASSERT_GE(under, 0);
          const std::vector<int>& carried = segments[under].carried;
          EXPECT_EQ(std::count(carried.begin(), carried.end(), at), 1);
          at = under;
        }
        EXPECT_LE(steps, segments.size());
        EXPECT_EQ(segments[k].support.segment >= 0, segments[k].support.kind == SupportKind::kSegment);
        for (const int on : segments[k].carried) EXPECT_EQ(segments[on].support.segment, static_cast<int>(k));
      }
    }
  }
}

TEST(Supports, AThingThatHidesTheWholeTopUnderIt) {
  for (const double overhang : {0.0, 0.03}) {
    SCOPED_TRACE(overhang);
    const Sight sight(onATable({box({-0.1, -0.1, 0}, {0.1, 0.1, 0.06}),
                                box({-0.1 - overhang, -0.1 - overhang, 0.06}, {0.1 + overhang, 0.1 + overhang, 0.15})}),
                      1);
    EXPECT_NEAR(sight.heights(0).first, 0, 0.001);
    EXPECT_NEAR(sight.heights(1).first, 0.06, 0.003);
  }
}

TEST(Supports, AThingThatIsInNoSegmentCarriesToo) {
  const Sight sight(onATable({box({-0.15, -0.1, 0}, {0.15, 0.1, 0.04}), box({-0.05, -0.04, 0.04}, {0.05, 0.04, 0.2})}),
                    1, 1);
  ASSERT_EQ(sight.segments.size(), 1u);
  EXPECT_NEAR(sight.heights(0).first, 0.04, 0.001);
  EXPECT_EQ(sight.supports[0].kind, SupportKind::kOther);
  EXPECT_EQ(sight.supports[0].segment, -1);
}

TEST(Supports, AThingInATrayStandsOnItsFloor) {
  std::vector<Surface> things{box({-0.02, -0.05, 0.012}, {0.06, 0.03, 0.1})};
  const Surface floor = box({-0.2, -0.15, 0}, {0.2, 0.15, 0.012}), left = box({-0.2, -0.15, 0}, {-0.19, 0.15, 0.04}),
                right = box({0.19, -0.15, 0}, {0.2, 0.15, 0.04}), near = box({-0.2, -0.15, 0}, {0.2, -0.14, 0.04}),
                far = box({-0.2, 0.14, 0}, {0.2, 0.15, 0.04});
  things.push_back([=](const Vector3d& o, const Vector3d& d) {
    return std::min({floor(o, d), left(o, d), right(o, d), near(o, d), far(o, d)});
  });
  const Sight sight(onATable(things), 1);
  EXPECT_NEAR(sight.heights(0).first, 0.012, 0.001);
}

TEST(Supports, AThingBehindOthersStandsOnTheTable) {
  // The foot of the second is hidden by the first: with a gap between them, without one, and beside it.
  for (const double gap : {0.05, 0.01, 0.0}) {
    for (const double height : {0.015, 0.05, 0.1}) {
      SCOPED_TRACE(testing::Message() << "gap " << gap << ", height " << height);
      const Sight sight(
          onATable({box({-0.1, -0.15, 0}, {0.1, -0.05, height}), box({-0.08, -0.05 + gap, 0}, {0.08, 0.05 + gap, 0.2}),
                    box({0.1, -0.1, 0}, {0.2, 0.02, 0.5 * height + 0.01})}),
          1);
      for (const std::size_t k : {0u, 1u, 2u}) EXPECT_NEAR(sight.heights(k).first, 0, 0.001) << "thing " << k;
    }
  }
}

TEST(Supports, ATiltedBoxIsLengthenedUntilItsEdgeIsThere) {
  Sight sight(onATable({box({-0.1, -0.1, 0}, {0.1, 0.1, 0.06})}), 1);
  for (const double tilt_deg : {10.0, 25.0, 40.0}) {
    Segment& segment = sight.segments[0];
    // Its lower edge on the table, seen from 2 cm on.
    const Eigen::AngleAxisd tilt(tilt_deg * M_PI / 180, Vector3d::UnitX());
    const Vector3d size(0.2, 0.03, 0.25);
    Eigen::Isometry3d T_world_box = Eigen::Isometry3d::Identity();
    T_world_box.rotate(tilt);
    const double low = heightsOf({T_world_box, size}, Eigen::Isometry3d::Identity()).first;
    T_world_box.pretranslate(Vector3d(0, 0, -low));
    segment.box = {sight.scene.T_world_camera.inverse() * T_world_box * Eigen::Translation3d(0, 0, 0.01),
                   size - Vector3d(0, 0, 0.02)};
    sight.rest();
    EXPECT_LT((segment.box.size_m - size).norm(), 1e-4);
    EXPECT_LT((sight.scene.T_world_camera * segment.box.T_camera_box.translation() - T_world_box.translation()).norm(),
              1e-4);
    EXPECT_NEAR(sight.heights(0).first, 0, 1e-4);
  }
}

TEST(Supports, NothingToRest) {
  const Sight sight(onATable({}), 1);
  EXPECT_TRUE(sight.segments.empty());
}
