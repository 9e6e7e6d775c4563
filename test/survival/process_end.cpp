// SPDX-License-Identifier: BSD-3-Clause
// Run by process_end.test: nodelets come and go, and managers are ended, while frames arrive faster than they are
// segmented. Every end takes less than a second and takes nothing else down.
#include <gtest/gtest.h>
#include <objectness_segmentation/SegmentedObjectArray.h>
#include <ros/ros.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <random>
#include <string>
#include <thread>

#include "manager_process.hpp"
#include "small_frames.hpp"

namespace {

using namespace objectness_test;
using objectness_segmentation::SegmentedObjectArray;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double kLongestEnd_s = 5.0;  // stages are many times slower, and leaks are looked for at the end
#else
constexpr double kLongestEnd_s = 1.0;
#endif

/// Sends frames without a pause to speak of, from a thread of its own.
class FullInput {
 public:
  FullInput() {
    ros::NodeHandle nh;
    clouds_ = nh.advertise<sensor_msgs::PointCloud2>("points", 5);
    cameras_ = nh.advertise<sensor_msgs::CameraInfo>("camera_info", 5);
    thread_ = std::thread([this] {
      for (std::size_t number = 0; !stop_; ++number) {
        const ros::Time stamp = ros::Time::now();
        cameras_.publish(frames_.cameraInfo(stamp));
        clouds_.publish(frames_.cloud(number, stamp));
        ros::WallDuration(0.005).sleep();
      }
    });
  }
  ~FullInput() {
    stop_ = true;
    thread_.join();
  }

 private:
  const SmallFrames frames_{3, 2};
  ros::Publisher clouds_, cameras_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

/// Counts the results of a nodelet, and so keeps it at work.
class Results {
 public:
  explicit Results(const std::string& nodelet) {
    subscriber_ = ros::NodeHandle().subscribe<SegmentedObjectArray>(
        nodelet + "/objects", 10, [this](const boost::shared_ptr<const SegmentedObjectArray>& array) {
          ++count_;
          stamp_ = array->header.stamp;
        });
  }
  /// A result of a frame that was sent after this call.
  bool freshOne(double seconds = 60) {
    const ros::Time now = ros::Time::now();
    return wait([&] { return stamp_ > now; }, seconds);
  }
  bool wait(const std::function<bool()>& condition, double seconds = 60) {
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(seconds);
    while (!condition() && ros::WallTime::now() < end) {
      ros::spinOnce();
      ros::WallDuration(0.002).sleep();
    }
    return condition();
  }
  long count() const { return count_; }

 private:
  ros::Subscriber subscriber_;
  long count_ = 0;
  ros::Time stamp_;
};

int rounds() { return ros::NodeHandle("~").param("rounds", 200); }

TEST(ProcessEnd, LoadedAndUnloadedUnderFullInput) {
  const FullInput input;
  ManagerProcess manager("/survivor");
  ASSERT_TRUE(manager.up());
  ASSERT_TRUE(manager.load("/neighbour"));
  Results neighbour("/neighbour"), guest("/guest");
  ASSERT_TRUE(neighbour.freshOne());

  std::mt19937 random(1);
  double longest = 0;
  const auto round = [&](bool wait_for_result) {
    ASSERT_TRUE(manager.load("/guest"));
    // A guest that has computed once is most likely computing again; without that it is caught while it starts.
    if (wait_for_result) {
      ASSERT_TRUE(guest.freshOne());
    }
    ros::WallDuration(0.001 * (random() % 30)).sleep();
    const ros::WallTime start = ros::WallTime::now();
    ASSERT_TRUE(manager.unload("/guest"));
    longest = std::max(longest, (ros::WallTime::now() - start).toSec());
  };
  const int warm_up = std::min(20, rounds() / 2);
  for (int i = 0; i < warm_up; ++i) ASSERT_NO_FATAL_FAILURE(round(true));
  ASSERT_TRUE(neighbour.freshOne());
  const long threads = manager.threads(), resident = manager.residentKb();
  for (int i = warm_up; i < rounds(); ++i) {
    ASSERT_NO_FATAL_FAILURE(round(i % 4 != 0));
    ASSERT_FALSE(manager.exited());
  }
  ASSERT_TRUE(neighbour.freshOne());
  const double grown = 100.0 * (manager.residentKb() - resident) / resident;
  std::printf("%d rounds: longest unload %.3f s, threads %ld -> %ld, resident %ld kB %+.1f %%\n", rounds(), longest,
              threads, manager.threads(), resident, grown);
  EXPECT_LT(longest, kLongestEnd_s);
  // Connections to nodes that look on come and go by themselves, threads of a nodelet that is gone do not.
  EXPECT_TRUE(neighbour.wait([&] { return manager.threads() <= threads; })) << threads << " -> " << manager.threads();
  EXPECT_LT(grown, 10);
}

TEST(ProcessEnd, SignalsInMidFrame) {
  const FullInput input;
  std::mt19937 random(2);
  double longest = 0;
  for (int round = 0; round < std::max(4, rounds() / 10); ++round) {
    for (const int signal : {SIGINT, SIGTERM}) {
      ManagerProcess manager("/victim");
      ASSERT_TRUE(manager.up());
      ASSERT_TRUE(manager.load("/guest"));
      Results guest("/guest");
      ASSERT_TRUE(guest.freshOne());
      ros::WallDuration(0.001 * (random() % 40)).sleep();
      const double seconds = manager.end(signal, 10);
      longest = std::max(longest, seconds);
      EXPECT_LT(seconds, kLongestEnd_s) << "signal " << signal;
      EXPECT_TRUE(manager.endedCleanly(signal)) << "signal " << signal;
    }
  }
  std::printf("longest end after a signal %.3f s\n", longest);
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "process_end_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
