// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "fixtures/boxes_on_a_table.hpp"
#include "objectness_segmentation/pipeline.hpp"
#include "objectness_segmentation/sequence.hpp"
#include "sim/scene_generator.hpp"
#include "sim/simulated_frame.hpp"

using namespace objectness;

namespace {

/// Boxes before a stereo camera that stands still; every frame has noise of its own.
class Sequence : public testing::Test {
 protected:
  Sequence() : sensor_(sim::DepthSensor::stereo({525, 525, 319.5, 239.5, 640, 480})) {
    sensor_.subpixel_px = 0.05;
    sim::SceneRequest request;
    request.level = "boxes";
    request.objects = 3;
    request.camera = sensor_.camera;
    const auto scene = sim::generateScene(request);
    EXPECT_TRUE(scene.ok()) << scene.status.message;
    scene_ = scene.value;
  }
  Frame look(unsigned noise) const {
    const SceneImages images = simulateFrame(scene_, scene_.T_world_camera, sensor_, noise).images;
    const auto frame = makeFrame(images.depth_mm, images.color, images.camera, {});
    EXPECT_TRUE(frame.ok()) << frame.status.message;
    return frame.value;
  }

  sim::DepthSensor sensor_;
  sim::Scene scene_;
};

/// Sum of the changes of box centres from frame to frame, by identity.
double unrest(const SequenceResult& before, const SequenceResult& now) {
  double sum = 0;
  for (std::size_t i = 0; i < before.identities.size(); ++i) {
    for (std::size_t j = 0; j < now.identities.size(); ++j) {
      if (before.identities[i].id != now.identities[j].id) continue;
      sum += (before.segmentation.segments[i].box.T_camera_box.translation() -
              now.segmentation.segments[j].box.T_camera_box.translation())
                 .norm();
    }
  }
  return sum;
}

}  // namespace

TEST_F(Sequence, OfAStillSceneIsSteadierThanItsFrames) {
  FrameSequence alone(1), fused(8);
  Config config, unsettled;
  unsettled.tracking.settle_frames = 1;
  SequenceResult last_alone, last_fused;
  double unrest_alone = 0, unrest_fused = 0;
  int changes = 0;
  for (unsigned k = 0; k < 12; ++k) {
    const SequenceResult a = alone.next(look(k), {}, 0.1 * k, unsettled), b = fused.next(look(k), {}, 0.1 * k, config);
    ASSERT_TRUE(b.segmentation.status.ok()) << b.segmentation.status.message;
    ASSERT_EQ(b.identities.size(), b.segmentation.segments.size());
    ASSERT_EQ(b.fused.restarted, k == 0) << k;
    if (k >= 8) {
      changes += b.segmentation.segments.size() != last_fused.segmentation.segments.size();
      unrest_alone += unrest(last_alone, a);
      unrest_fused += unrest(last_fused, b);
    }
    last_alone = a;
    last_fused = b;
  }
  EXPECT_GT(last_fused.segmentation.segments.size(), 0u);
  EXPECT_LE(changes, 1);
  EXPECT_LT(unrest_fused, 0.4 * unrest_alone);
  EXPECT_EQ(fused.memoryBytes(), 6u * 640 * 480);
}

TEST_F(Sequence, OfSingleFramesIsSegment) {
  FrameSequence alone(1);
  Config config;
  config.tracking.enabled = false;
  for (unsigned k = 0; k < 2; ++k) {
    const Frame frame = look(k);
    const SequenceResult result = alone.next(frame, {}, 0, config);
    const Segmentation single = segment(frame, config);
    EXPECT_EQ(cv::countNonZero(result.segmentation.labels != single.labels), 0);
    ASSERT_EQ(result.segmentation.segments.size(), single.segments.size());
    for (std::size_t i = 0; i < single.segments.size(); ++i) {
      EXPECT_EQ(result.segmentation.segments[i].box.size_m, single.segments[i].box.size_m);
    }
    EXPECT_TRUE(result.identities.empty());
  }
}

TEST_F(Sequence, ForgetsWhenTimeGoesBack) {
  FrameSequence sequence;
  sequence.next(look(1), {}, 100, {});
  EXPECT_FALSE(sequence.next(look(2), {}, 99.9, {}).fused.restarted);
  const SequenceResult later = sequence.next(look(3), {}, 50, {});
  EXPECT_TRUE(later.fused.restarted);
  for (const Identity& identity : later.identities) EXPECT_EQ(identity.age_frames, 1);
}

TEST_F(Sequence, IsTheSameForAnyNumberOfThreads) {
  FrameSequence one, two;
  Config config_one, config_two;
  config_one.runtime.threads = 1;
  config_two.runtime.threads = 3;
  for (unsigned k = 0; k < 3; ++k) {
    const SequenceResult a = one.next(look(k), {}, k, config_one), b = two.next(look(k), {}, k, config_two);
    EXPECT_EQ(cv::countNonZero(a.segmentation.labels != b.segmentation.labels), 0) << k;
    ASSERT_EQ(a.segmentation.segments.size(), b.segmentation.segments.size());
    for (std::size_t i = 0; i < a.segmentation.segments.size(); ++i) {
      EXPECT_TRUE(a.segmentation.segments[i].box.T_camera_box.matrix() ==
                  b.segmentation.segments[i].box.T_camera_box.matrix());
    }
  }
}

namespace {

using objectness_test::Thing;

/// Boxes on a table that are moved while the camera stands still.
class ChangingScene : public testing::Test {
 protected:
  /// How well each thing is segmented: the best Dice of any segment.
  std::vector<double> look(const std::vector<Thing>& things) {
    objectness_test::Scene scene = objectness_test::boxesOnATable(things, T_world_camera_);
    Frame frame = scene.render();
    std::mt19937 random(++frames_);
    std::normal_distribution<float> noise(0, 0.001f);
    for (Eigen::Vector3f& p : frame.points) {
      const float error = noise(random);
      if (p.z() > 0) p *= 1 / (1 + error * p.z());
    }
    result_ = sequence_.next(frame, {}, 0.1 * frames_, {});
    EXPECT_TRUE(result_.segmentation.status.ok()) << result_.segmentation.status.message;
    std::vector<double> dices;
    for (std::size_t k = 0; k < things.size(); ++k) {
      double best = 0;
      for (const Segment& segment : result_.segmentation.segments) {
        double both = 0, all = static_cast<double>(segment.pixels.size());
        for (int i = 0; i < frame.size(); ++i) all += scene.seen[i] == static_cast<int>(k) + 1;
        for (const int i : segment.pixels) both += scene.seen[i] == static_cast<int>(k) + 1;
        best = std::max(best, 2 * both / all);
      }
      dices.push_back(best);
    }
    return dices;
  }
  void expectAll(const std::vector<Thing>& things, double least, const std::string& what) {
    for (const double dice : look(things)) EXPECT_GT(dice, least) << what;
    EXPECT_EQ(result_.segmentation.segments.size(), things.size()) << what;
  }

  const Eigen::Isometry3d T_world_camera_ = objectness_test::lookAt({0, -0.65, 0.65}, {0, 0, 0.03});
  const Thing left_{{-0.2, 0, 0}, {0.1, 0.1, 0.14}}, right_{{0.18, 0.05, 0}, {0.08, 0.1, 0.1}};
  FrameSequence sequence_;
  SequenceResult result_;
  unsigned frames_ = 0;
};

}  // namespace

TEST_F(ChangingScene, WhatAppearsAndGoesIsSeenInTheSameFrame) {
  for (int k = 0; k < 10; ++k) expectAll({left_}, 0.9, "one thing, frame " + std::to_string(k));
  for (int k = 0; k < 3; ++k) expectAll({left_, right_}, 0.9, "two things, frame " + std::to_string(k));
  for (int k = 0; k < 3; ++k) expectAll({right_}, 0.9, "the other thing, frame " + std::to_string(k));
}

TEST_F(ChangingScene, WhatSlidesIsWhereItIs) {
  for (int k = 0; k < 10; ++k) look({left_, right_});
  for (int k = 1; k <= 12; ++k) {
    Thing sliding = right_;
    sliding.at.x() -= 0.012 * k;
    expectAll({left_, sliding}, 0.88, "frame " + std::to_string(k));
    const OrientedBox* nearest = nullptr;
    const Eigen::Vector3d centre =
        T_world_camera_.inverse() * (sliding.at + Eigen::Vector3d(0, 0, 0.5 * sliding.size.z()));
    double best = 1;
    for (const Segment& segment : result_.segmentation.segments) {
      const double distance = (segment.box.T_camera_box.translation() - centre).norm();
      if (distance < best) best = distance, nearest = &segment.box;
    }
    EXPECT_TRUE(nearest && best < 0.02) << best << " m off in frame " << k;
  }
}

TEST_F(ChangingScene, WhatWasOneObjectBecomesTwoWhenItsPartsMove) {
  const Thing half{{-0.05, 0, 0}, {0.1, 0.1, 0.12}};
  Thing other = half;
  other.at.x() = 0.05;
  for (int k = 0; k < 10; ++k) look({half, other});
  other.at.x() = 0.12;
  look({half, other});
  expectAll({half, other}, 0.9, "in the second frame");
}
