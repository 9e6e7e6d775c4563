// SPDX-License-Identifier: BSD-3-Clause
// Run by exceptions.test: exceptions come out of the core, and out of the messages that are made of its results,
// wherever they allocate much. Each ends its own frame only.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <sensor_msgs/PointCloud2.h>

#include "failing_memory.hpp"
#include "hosted_nodelets.hpp"

namespace {

using namespace objectness_test;

constexpr char kNode[] = "/exceptional";
/// Images and clouds of a frame are above it, ROS's own messages and logs below.
constexpr std::size_t kMuchBytes = 8192;

class Exceptions : public ::testing::TestWithParam<Failure> {
 protected:
  void SetUp() override {
    ASSERT_TRUE(host_.load(kNode));
    objects_ = listen(kNode, [this](const SegmentedObjectArrayConstPtr& array) { newest_ = array; });
    segments_ = nh_.subscribe<sensor_msgs::PointCloud2>(
        std::string(kNode) + "/segments", 5,
        boost::function<void(const sensor_msgs::PointCloud2ConstPtr&)>(
            [this](const sensor_msgs::PointCloud2ConstPtr& cloud) { last_published_ = cloud->header.stamp; }));
    diagnostics_ = nh_.subscribe<diagnostic_msgs::DiagnosticArray>(
        "/diagnostics", 10, [this](const diagnostic_msgs::DiagnosticArrayConstPtr& array) {
          for (const auto& status : array->status) {
            if (status.name.find("exceptional") != std::string::npos) level_ = status.level;
          }
        });
    ASSERT_TRUE(spinUntil([&] { return host_.connected(1); }));
  }
  void TearDown() override {
    FailingMemory::disarm();
    EXPECT_TRUE(host_.unload(kNode));
  }

  bool answered(const ros::Time& stamp, double seconds = 60) {
    return spinUntil([&] { return newest_ && newest_->header.stamp == stamp; }, seconds);
  }

  void expectGoodFrame(int after) {
    ASSERT_TRUE(answered(host_.send(frames_, 2))) << after;
    EXPECT_EQ(newest_->status, SegmentedObjectArray::OK) << newest_->message;
    if (objects_expected_ < 0) objects_expected_ = static_cast<long>(newest_->objects.size());
    EXPECT_EQ(static_cast<long>(newest_->objects.size()), objects_expected_) << after;
    ASSERT_TRUE(spinUntil([&] { return last_published_ == newest_->header.stamp; })) << after;
  }

  ros::NodeHandle nh_;
  HostedNodelets host_;
  const SmallFrames frames_{3};
  ros::Subscriber objects_, segments_, diagnostics_;
  SegmentedObjectArrayConstPtr newest_;
  long objects_expected_ = -1;
  ros::Time last_published_;  // after the objects: the frame is then done with
  int level_ = -1;
};

TEST_P(Exceptions, EndTheirOwnFrameOnly) {
  ASSERT_NO_FATAL_FAILURE(expectGoodFrame(-1));
  EXPECT_GT(objects_expected_, 0);
  int answered_with_error = 0, not_answered = 0;
  bool fired = true;
  for (int passes = 0; fired && passes < 500; ++passes) {
    const auto cloud_stamp = [&] {
      FailingMemory::arm(GetParam(), kMuchBytes, passes, true);
      return host_.send(frames_, 2);
    }();
    // Either an answer comes, or none can be made: then the failure shows that it was taken up.
    spinUntil([&] { return FailingMemory::fired() || (newest_ && newest_->header.stamp == cloud_stamp); });
    fired = FailingMemory::fired();
    FailingMemory::disarm();
    if (fired) {
      if (answered(cloud_stamp, 0.3) && newest_->status != SegmentedObjectArray::OK) {
        EXPECT_EQ(newest_->status, SegmentedObjectArray::INTERNAL_ERROR) << newest_->message;
        EXPECT_FALSE(newest_->message.empty());
        ++answered_with_error;
      } else if (!newest_ || newest_->header.stamp != cloud_stamp) {
        ++not_answered;
      }
      // Diagnostics come once a second: looked at for the first, which is inside the core.
      if (passes == 0) {
        EXPECT_TRUE(spinUntil([&] { return level_ == diagnostic_msgs::DiagnosticStatus::ERROR; }, 10));
      }
    }
    ASSERT_NO_FATAL_FAILURE(expectGoodFrame(passes));
  }
  EXPECT_FALSE(fired) << "not all large allocations of a frame were made to fail";
  std::printf("%d frames answered with an error, %d without an answer\n", answered_with_error, not_answered);
  EXPECT_GT(answered_with_error, 10);
  EXPECT_TRUE(spinUntil([&] { return level_ == diagnostic_msgs::DiagnosticStatus::OK; }, 10));
}

TEST_P(Exceptions, InDiagnosticsAreThereInTheNext) {
  ASSERT_NO_FATAL_FAILURE(expectGoodFrame(-1));
  // No frame is under way: what allocates much is the text of the configuration, once a second.
  FailingMemory::arm(GetParam(), kMuchBytes, 0, true);
  EXPECT_TRUE(spinUntil([] { return FailingMemory::fired(); }, 10));
  FailingMemory::disarm();
  EXPECT_TRUE(spinUntil([&] { return level_ == diagnostic_msgs::DiagnosticStatus::ERROR; }, 10));
  ASSERT_NO_FATAL_FAILURE(expectGoodFrame(0));
  EXPECT_TRUE(spinUntil([&] { return level_ == diagnostic_msgs::DiagnosticStatus::OK; }, 10));
}

INSTANTIATE_TEST_SUITE_P(Kinds, Exceptions,
                         ::testing::Values(Failure::kBadAlloc, Failure::kException, Failure::kNoException));

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "exceptions_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
