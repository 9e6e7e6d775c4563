// SPDX-License-Identifier: BSD-3-Clause
// Run by looped_bag.test beside the node, in simulated time: the bag begins again and again, and time with it.
#include <diagnostic_msgs/DiagnosticArray.h>

#include "playback_fixture.hpp"

namespace {

using namespace objectness_test;

class LoopedBag : public Playback {
 protected:
  LoopedBag() {
    diagnostics_ = nh_.subscribe<diagnostic_msgs::DiagnosticArray>(
        "/diagnostics", 1000, [this](const diagnostic_msgs::DiagnosticArrayConstPtr& array) {
          for (const auto& status : array->status) {
            if (status.name.find("segment_objects: segmentation") != std::string::npos) reports_.push_back(status);
          }
        });
  }
  /// How often the answers went back in time.
  int jumps() const {
    int count = 0;
    for (std::size_t i = 1; i < answers_.size(); ++i) {
      if (answers_[i]->header.stamp < answers_[i - 1]->header.stamp) ++count;
    }
    return count;
  }

  ros::Subscriber diagnostics_;
  std::vector<diagnostic_msgs::DiagnosticStatus> reports_;
};

TEST_F(LoopedBag, IsAnsweredOverEveryJumpBackInTime) {
  BagPlayer player(play({"--clock", "--hz=100", "--loop"}));
  for (int jump = 1; jump <= 2; ++jump) {
    ASSERT_TRUE(waitUntil([&] { return jumps() >= jump; }, kPatience_s)) << "no answers after the jump";
    const std::size_t answers = answers_.size(), reports = reports_.size();
    EXPECT_TRUE(waitUntil([&] { return answers_.size() > answers; }, kPatience_s)) << "the node fell silent";
    ASSERT_TRUE(waitUntil([&] { return reports_.size() >= reports + 2; }, kPatience_s)) << "its diagnostics did";
    EXPECT_EQ(reports_.back().level, diagnostic_msgs::DiagnosticStatus::OK) << reports_.back().message;
    EXPECT_EQ(reports_.back().message, "segmenting");
  }
  EXPECT_TRUE(ros::Time::isSimTime());
  for (const auto& answer : answers_) EXPECT_EQ(answer->status, SegmentedObjectArray::OK) << answer->message;
  EXPECT_TRUE(player.running());
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "looped_bag_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
