// SPDX-License-Identifier: BSD-3-Clause
// Run by playback.test beside the node: plays a bag to it and looks at what comes back.
#include <algorithm>
#include <map>
#include <set>

#include "playback_fixture.hpp"

namespace {

using namespace objectness_test;

constexpr double kDice = 0.75;

double dice(const std::vector<int>& found, const std::vector<int>& truth) {
  std::vector<int> common;  // both are sorted
  std::set_intersection(found.begin(), found.end(), truth.begin(), truth.end(), std::back_inserter(common));
  return 2.0 * common.size() / (found.size() + truth.size());
}

/// Pixels of each object in a true label image.
std::map<int, std::vector<int>> objectsOf(const sensor_msgs::Image& labels) {
  std::map<int, std::vector<int>> pixels;
  for (std::uint32_t i = 0; i < labels.width * labels.height; ++i) {
    const int label = labels.data[2 * i] | labels.data[2 * i + 1] << 8;
    if (label >= 20) pixels[label].push_back(static_cast<int>(i));
  }
  return pixels;
}

TEST_F(Playback, FindsTheObjectsOfEveryFrameItTakes) {
  const std::uint32_t dropped_before = droppedSoFar();
  BagPlayer player(playOnce({"-r", "0.3"}));
  const std::vector<ros::Time> played = playedStamps();
  ASSERT_EQ(played.size(), static_cast<std::size_t>(kFrames));
  ASSERT_GE((played.back() - played.front()).toSec(), 3.0);
  ASSERT_TRUE(waitForAnswerTo(played.back()));

  std::map<ros::Time, sensor_msgs::ImageConstPtr> truth;
  for (const auto& labels : readAll<sensor_msgs::Image>(bag(), bag_topics::kTrueLabels)) {
    truth[labels->header.stamp] = labels;
  }
  std::set<ros::Time> answered;
  std::size_t objects = 0, found = 0;
  for (const auto& answer : answers_) {
    ASSERT_EQ(truth.count(answer->header.stamp), 1u) << answer->header.stamp;
    const sensor_msgs::Image& labels = *truth[answer->header.stamp];
    EXPECT_TRUE(answered.insert(answer->header.stamp).second) << "answered twice: " << answer->header.stamp;
    EXPECT_EQ(answer->header.frame_id, labels.header.frame_id);
    EXPECT_EQ(answer->status, SegmentedObjectArray::OK) << answer->message;
    const auto true_objects = objectsOf(labels);
    EXPECT_GE(true_objects.size(), 5u);
    for (const auto& [label, pixels] : true_objects) {
      double best = 0;
      for (const auto& object : answer->objects) {
        auto indices = object.indices.indices;
        std::sort(indices.begin(), indices.end());
        best = std::max(best, dice({indices.begin(), indices.end()}, pixels));
        EXPECT_EQ(object.header.stamp, answer->header.stamp);
        EXPECT_EQ(object.header.frame_id, answer->header.frame_id);
      }
      ++objects;
      if (best > kDice) ++found;
    }
  }
  EXPECT_EQ(answered.size() + answers_.back()->dropped_frames - dropped_before, played.size());
  EXPECT_GE(2 * answered.size(), played.size()) << "most frames of a slow bag are taken";
  EXPECT_GE(static_cast<double>(found), 0.9 * objects) << found << " of " << objects;
  RecordProperty("answered", static_cast<int>(answered.size()));
  RecordProperty("found", static_cast<int>(found));
  RecordProperty("objects", static_cast<int>(objects));
}

TEST_F(Playback, TooFastDropsAllButTheNewest) {
  const std::vector<ros::Time> played = playedStamps();
  const std::uint32_t dropped_before = droppedSoFar();
  BagPlayer player(playOnce({"-r", "100"}));
  ASSERT_TRUE(waitForAnswerTo(played.back())) << "the newest frame is always processed";
  for (std::size_t i = 1; i < answers_.size(); ++i) {
    EXPECT_LT(answers_[i - 1]->header.stamp, answers_[i]->header.stamp) << "none twice, none older";
    EXPECT_LE(answers_[i - 1]->dropped_frames, answers_[i]->dropped_frames);
  }
  const std::uint32_t dropped = answers_.back()->dropped_frames - dropped_before;
  EXPECT_EQ(answers_.size() + dropped, played.size());
  EXPECT_GT(dropped, 0u) << "was the bag played too fast at all?";
  for (const auto& answer : answers_) {
    EXPECT_EQ(std::count(played.begin(), played.end(), answer->header.stamp), 1);
  }
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "playback_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
