// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <set>

#include "fixtures/boxes_on_a_table.hpp"
#include "fixtures/temporary_folder.hpp"
#include "objectness_segmentation/io/scene_folder.hpp"
#include "objectness_segmentation/pipeline.hpp"
#include "objectness_segmentation/tracking/tracker.hpp"

namespace {

using namespace objectness;
using objectness_test::lookAt;
using objectness_test::Thing;

/// A camera in a world of boxes. The segments are what a perfect segmentation would give: the pixels and the true box.
class Tracking : public testing::Test {
 protected:
  std::vector<Identity> look(const std::vector<Thing>& things, double time_s) {
    objectness_test::Scene scene = objectness_test::boxesOnATable(things, T_world_camera_, hiding_);
    const int first = static_cast<int>(hiding_.size()) + 1;
    const Frame frame = scene.render();
    std::vector<Segment> segments;
    seen_.clear();
    for (std::size_t k = 0; k < things.size(); ++k) {
      Segment segment;
      for (int i = 0; i < frame.size(); ++i) {
        if (scene.seen[i] == first + static_cast<int>(k)) segment.pixels.push_back(i);
      }
      if (segment.pixels.size() < 100) continue;
      const Eigen::Vector3d centre = things[k].at + Eigen::Vector3d(0, 0, 0.5 * things[k].size.z());
      segment.box.T_camera_box = T_world_camera_.inverse() * Eigen::Translation3d(centre);
      segment.box.size_m = things[k].size;
      segments.push_back(segment);
      seen_.push_back(k);
    }
    std::vector<Identity> identities =
        tracker_.update(frame, segments, tf_known_ ? T_world_camera_ : Eigen::Isometry3d::Identity(), time_s, config_);
    EXPECT_EQ(identities.size(), segments.size());
    return identities;
  }
  static std::vector<std::uint64_t> idsOf(const std::vector<Identity>& identities) {
    std::vector<std::uint64_t> ids;
    for (const Identity& identity : identities) ids.push_back(identity.id);
    return ids;
  }
  static std::vector<int> labelsOf(const std::vector<Identity>& identities) {
    std::vector<int> labels;
    for (const Identity& identity : identities) labels.push_back(identity.label);
    return labels;
  }

  const std::vector<Thing> things_{
      {{-0.2, 0, 0}, {0.1, 0.1, 0.14}}, {{0, 0.1, 0}, {0.06, 0.12, 0.05}}, {{0.18, 0, 0}, {0.1, 0.1, 0.14}}};
  Tracker tracker_;
  TrackingConfig config_;
  Eigen::Isometry3d T_world_camera_ = lookAt({0, -0.65, 0.65}, {0, 0, 0.03});
  bool tf_known_ = true;
  std::vector<objectness_test::Surface> hiding_;
  std::vector<std::size_t> seen_;
};

TEST_F(Tracking, BeginsWithLabelsByRank) {
  const auto identities = look(things_, 0);
  EXPECT_EQ(labelsOf(identities), (std::vector<int>{2, 3, 4}));
  EXPECT_EQ(idsOf(identities), (std::vector<std::uint64_t>{1, 2, 3}));
  for (const Identity& identity : identities) {
    EXPECT_EQ(identity.age_frames, 1);
    EXPECT_EQ(identity.age_s, 0);
  }
  const auto ranks = identitiesByRank(3);
  EXPECT_EQ(labelsOf(ranks), labelsOf(identities));
  EXPECT_EQ(idsOf(ranks), (std::vector<std::uint64_t>{0, 0, 0}));
}

TEST_F(Tracking, FollowsObjectsNotTheirOrder) {
  look(things_, 0);
  auto turned = things_;
  std::reverse(turned.begin(), turned.end());
  EXPECT_EQ(idsOf(look(turned, 0.1)), (std::vector<std::uint64_t>{3, 2, 1}));
}

TEST_F(Tracking, KeepsIdentitiesUnderAMovingCamera) {
  double confidence = 0;
  for (int i = 0; i < 30; ++i) {
    // Half a turn about the table: 6 degrees and 7 cm a frame; at the end other faces are seen, from the other side.
    const double angle = 6 * i * M_PI / 180;
    T_world_camera_ = lookAt({-0.65 * std::sin(angle), -0.65 * std::cos(angle), 0.65}, {0, 0, 0.03});
    const auto identities = look(things_, 0.1 * i);
    EXPECT_EQ(idsOf(identities), (std::vector<std::uint64_t>{1, 2, 3})) << i;
    EXPECT_EQ(identities[0].age_frames, i + 1);
    EXPECT_NEAR(identities[0].age_s, 0.1 * i, 1e-9);
    if (i < 5) {
      EXPECT_GT(identities[0].confidence, confidence);
    }
    confidence = identities[0].confidence;
    if (i >= 10) {
      EXPECT_GT(confidence, 0.8);
    }
  }
}

TEST_F(Tracking, ACameraThatJumpsNeedsItsPose) {
  // Turned about one box so far that the other stands where the first was seen: only the pose tells them apart.
  const std::vector<Thing> pair{things_[0], things_[2]};
  const Eigen::Isometry3d before = T_world_camera_, after = Eigen::Translation3d(0.38, 0, 0) * before;
  for (const bool known : {true, false}) {
    tracker_.clear();
    tf_known_ = known;
    T_world_camera_ = before;
    const auto first = look(pair, 0);
    T_world_camera_ = after;
    const auto second = look(pair, 0.1);
    ASSERT_EQ(seen_.size(), 2u);
    if (known) {
      EXPECT_EQ(idsOf(first), idsOf(second));
    } else {
      EXPECT_EQ(second[1].id, first[0].id) << "taken for the other one, which it looks like";
    }
  }
}

TEST_F(Tracking, SurvivesMissedFrames) {
  const auto before = look(things_, 0);
  for (int i = 1; i <= 4; ++i) {
    const auto rest = look({things_[0], things_[2]}, 0.1 * i);
    EXPECT_EQ(idsOf(rest), (std::vector<std::uint64_t>{1, 3}));
  }
  const auto after = look(things_, 0.5);
  EXPECT_EQ(idsOf(after), idsOf(before));
  EXPECT_EQ(labelsOf(after), labelsOf(before));
  EXPECT_EQ(after[1].age_frames, 2);
  EXPECT_LT(after[1].confidence, after[0].confidence);
}

TEST_F(Tracking, SurvivesOcclusion) {
  const auto before = look(things_, 0);
  const Eigen::Vector3d eye = T_world_camera_.translation();
  for (int i = 1; i <= 8; ++i) {
    // A plate passes between the camera and the boxes from left to right, hiding parts of them, then one, then none.
    const double x = -0.25 + 0.06 * i;
    hiding_ = {objectness_test::box({x - 0.1, 0.6 * eye.y(), 0.1}, {x + 0.1, 0.6 * eye.y() + 0.01, 0.7})};
    const auto identities = look(things_, 0.1 * i);
    for (std::size_t k = 0; k < identities.size(); ++k) EXPECT_EQ(identities[k].id, before[seen_[k]].id) << i;
  }
  hiding_.clear();
  EXPECT_EQ(idsOf(look(things_, 0.9)), idsOf(before));
}

TEST_F(Tracking, ForgetsWhatWasRemovedAndUsesItsLabelAgain) {
  look(things_, 0);
  const std::vector<Thing> rest{things_[0], things_[2]};
  for (int i = 1; i < 30; ++i) EXPECT_EQ(idsOf(look(rest, 0.1 * i)), (std::vector<std::uint64_t>{1, 3}));
  // Something new, where the removed one stood.
  const auto after = look(things_, 3.0);
  EXPECT_EQ(idsOf(after), (std::vector<std::uint64_t>{1, 4, 3}));
  EXPECT_EQ(labelsOf(after), (std::vector<int>{2, 3, 4}));
  EXPECT_EQ(after[1].age_frames, 1);
}

TEST_F(Tracking, ObjectsAtLowRatesAreRememberedByFrames) {
  look(things_, 0);
  look({things_[0]}, 60);
  EXPECT_EQ(idsOf(look(things_, 120)), (std::vector<std::uint64_t>{1, 2, 3}));
}

TEST_F(Tracking, FollowsObjectsThatSwapPlaces) {
  // Of different size, a hand's breadth apart: each is known by its size.
  const std::vector<Thing> before{{{-0.05, 0, 0}, {0.06, 0.06, 0.16}}, {{0.05, 0, 0}, {0.08, 0.05, 0.07}}};
  const auto first = look(before, 0);
  const std::vector<Thing> after{{{0.05, 0, 0}, {0.06, 0.06, 0.16}}, {{-0.05, 0, 0}, {0.08, 0.05, 0.07}}};
  EXPECT_EQ(idsOf(look(after, 0.1)), idsOf(first));
}

TEST_F(Tracking, IdentitiesStayWithThePlaceOfThingsThatLookTheSame) {
  const std::vector<Thing> before{{{-0.05, 0, 0}, {0.06, 0.06, 0.16}}, {{0.05, 0, 0}, {0.06, 0.06, 0.16}}};
  const auto first = look(before, 0);
  EXPECT_EQ(idsOf(look({before[1], before[0]}, 0.1)), (std::vector<std::uint64_t>{first[1].id, first[0].id}));
}

TEST_F(Tracking, WhatIsMovedTooFarIsNew) {
  look({things_[0]}, 0);
  auto moved = things_[0];
  moved.at.x() += 0.1;  // its faces do not meet those it had
  EXPECT_EQ(look({moved}, 0.1)[0].id, 1u);
  moved.at.x() += config_.max_move_m + 0.05;
  EXPECT_EQ(look({moved}, 0.2)[0].id, 2u);
}

TEST_F(Tracking, BeginsAnewWhenTimeJumpsBack) {
  look(things_, 100);
  EXPECT_EQ(idsOf(look(things_, 99.9)), (std::vector<std::uint64_t>{1, 2, 3})) << "jitter";
  EXPECT_EQ(idsOf(look(things_, 10)), (std::vector<std::uint64_t>{4, 5, 6}));
  EXPECT_EQ(labelsOf(look(things_, 10.1)), (std::vector<int>{2, 3, 4}));
}

TEST_F(Tracking, OfNothingIsNothing) {
  EXPECT_TRUE(look({}, 0).empty());
  EXPECT_EQ(look(things_, 0.1).size(), 3u);
  EXPECT_TRUE(look({}, 0.2).empty());
}

/// Five views of a bin with three things, which a moving camera took a quarter of a second apart or more; where it was
/// is not known, and the things were moved, too. Pixels read by eye.
TEST(TrackingOfRecordedFrames, ThreeObjectsKeepThreeIdentities) {
  const std::string data = objectness_test::sharedData();
  if (data.empty()) GTEST_SKIP() << "no shared data: set OBJECTNESS_DATA";
  struct View {
    const char* name;
    cv::Point carrot, toy, ball;
  };
  const View views[] = {{"000", {420, 330}, {620, 440}, {840, 355}},
                        {"006", {350, 290}, {545, 440}, {790, 315}},
                        {"012", {250, 180}, {515, 510}, {590, 245}},
                        {"018", {200, 240}, {540, 570}, {380, 330}},
                        {"024", {400, 200}, {745, 595}, {335, 440}}};
  Tracker tracker;
  std::vector<std::uint64_t> carrots, toys, balls;
  double time_s = 0;
  for (const View& view : views) {
    const auto frame = loadSceneFolder(data + "/anygrasp_track/" + view.name, std::nullopt, InputConfig{});
    ASSERT_TRUE(frame.ok()) << frame.status.message;
    const Segmentation result = segment(frame.value, Config{});
    ASSERT_TRUE(result.status.ok()) << result.status.message;
    const auto identities =
        tracker.update(frame.value, result.segments, Eigen::Isometry3d::Identity(), time_s += 0.25, TrackingConfig{});
    const auto idAt = [&](const cv::Point& pixel) -> std::uint64_t {
      const int label = result.labels(pixel);
      EXPECT_GE(label, kFirstObjectLabel) << view.name << pixel;
      return label < kFirstObjectLabel ? 0 : identities[label - kFirstObjectLabel].id;
    };
    carrots.push_back(idAt(view.carrot));
    toys.push_back(idAt(view.toy));
    balls.push_back(idAt(view.ball));
  }
  EXPECT_EQ(carrots, std::vector<std::uint64_t>(5, carrots[0]));
  EXPECT_EQ(toys, std::vector<std::uint64_t>(5, toys[0]));
  EXPECT_EQ(balls, std::vector<std::uint64_t>(5, balls[0]));
  EXPECT_EQ((std::set<std::uint64_t>{carrots[0], toys[0], balls[0]}).size(), 3u);
}

}  // namespace
