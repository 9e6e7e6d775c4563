// SPDX-License-Identifier: BSD-3-Clause
// Run by endurance.test: frames of changing scenes at the highest rate, while parameters change ten times a second.
#include <dynamic_reconfigure/Reconfigure.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <random>
#include <thread>
#include <vector>

#include "hosted_nodelets.hpp"
#include "objectness_segmentation/config.hpp"
#include "objectness_segmentation/ros/params.hpp"
#include "objectness_segmentation/ros/segment_messages.hpp"
#include "process_state.hpp"

namespace {

using namespace objectness_test;
using objectness::Config;
using objectness_segmentation::toReconfigureMessage;

constexpr char kNode[] = "/enduring";
constexpr int kScenes = 15, kConfigs = 6, kSettled = 500;
constexpr double kGrowth = 0.05;

/// Valid values that differ in many parameters at once: a frame that took some from one and some from another set
/// would show a result of none.
Config configOf(int index) {
  Config config;
  config.runtime.threads = 1;
  config.tracking.settle_frames = 1;
  config.object_points.min_threshold_m = config.object_points.max_threshold_m = 0.006 + 0.004 * index;
  config.normals.min_window_px += index % 3;
  config.superpixels.convex_deg -= 5 * (index % 2);
  return config;
}

/// What a result says about the objects, to the last bit.
using Fingerprint = std::vector<double>;

void add(const SegmentedObjectArray& array, Fingerprint& values) {
  std::vector<Fingerprint> objects;
  for (const auto& object : array.objects) {
    const auto& centre = object.pose.position;
    objects.push_back({centre.x, centre.y, centre.z, object.dimensions.x, object.dimensions.y, object.dimensions.z,
                       object.objectness, static_cast<double>(object.indices.indices.size())});
  }
  std::sort(objects.begin(), objects.end());
  values.push_back(array.status);
  for (const Fingerprint& object : objects) values.insert(values.end(), object.begin(), object.end());
}

Fingerprint fingerprint(const SegmentedObjectArray& array) {
  Fingerprint values(array.table.values.begin(), array.table.values.end());
  add(array, values);
  return values;
}

class Endurance : public ::testing::Test {
 protected:
  void SetUp() override {
    ros::param::set(std::string(kNode) + "/runtime_threads", 1);
    ros::param::set(std::string(kNode) + "/fuse_frames", 1);  // a result is of its own frame alone
    ASSERT_TRUE(host_.load(kNode));
    subscriber_ = listen(kNode, [this](const SegmentedObjectArrayConstPtr& array) { receive(*array); });
    ASSERT_TRUE(spinUntil([&] { return host_.connected(1); }));
    learnWhatToExpect();
    reconfigurer_ = std::thread([this] { reconfigure(); });
  }
  void TearDown() override {
    stop_ = true;
    if (reconfigurer_.joinable()) reconfigurer_.join();
  }

  /// Each scene with each set of values, alone.
  void learnWhatToExpect() {
    for (int k = 0; k < kConfigs; ++k) {
      ASSERT_TRUE(apply(toReconfigureMessage(configOf(k))));
      for (int scene = 0; scene < kScenes; ++scene) {
        last_ = ros::Time();
        const ros::Time stamp = send(scene);
        ASSERT_TRUE(spinUntil([&] { return last_ == stamp; }));
        expected_[scene].push_back(newest_);
      }
    }
    std::vector<Fingerprint> all = expected_[0];
    std::sort(all.begin(), all.end());
    distinct_ = std::unique(all.begin(), all.end()) - all.begin();
    learned_ = true;
    torn_ = 0;
  }

  ros::Time send(std::size_t number) {
    const ros::Time stamp = host_.send(frames_, number);
    ++sent_;
    scenes_[stamp.toNSec() / 1000000 % scenes_.size()] = static_cast<int>(number % kScenes);
    return stamp;
  }

  void receive(const SegmentedObjectArray& array) {
    ++results_;
    in_order_ = in_order_ && array.header.stamp > last_;
    last_ = array.header.stamp;
    dropped_ = array.dropped_frames;
    newest_ = fingerprint(array);
    if (!learned_) return;
    const auto& known = expected_[scenes_[last_.toNSec() / 1000000 % scenes_.size()]];
    torn_ += std::find(known.begin(), known.end(), newest_) == known.end();
  }

  static bool apply(const dynamic_reconfigure::Config& config) {
    dynamic_reconfigure::Reconfigure call;
    call.request.config = config;
    return ros::service::call(std::string(kNode) + "/set_parameters", call);
  }

  /// Ten times a second one of the sets, or values that contradict each other or are no numbers.
  void reconfigure() {
    std::mt19937 random(3);
    while (!stop_) {
      dynamic_reconfigure::Config config = toReconfigureMessage(configOf(random() % kConfigs));
      if (random() % 2 == 0) {
        for (auto& entry : config.doubles) {
          if (entry.name == "search_min_size_m") entry.value = random() % 2 == 0 ? NAN : 0.3;
          if (entry.name == "search_max_size_m") entry.value = 0.1;
        }
        ++rejected_;
      }
      failed_calls_ += !apply(config);
      ++calls_;
      ros::WallDuration(0.1).sleep();
    }
  }

  HostedNodelets host_;
  const SmallFrames frames_{kScenes};
  ros::Subscriber subscriber_;
  std::vector<std::vector<Fingerprint>> expected_ = std::vector<std::vector<Fingerprint>>(kScenes);
  std::vector<int> scenes_ = std::vector<int>(4096);
  std::thread reconfigurer_;
  std::atomic<bool> stop_{false};
  std::atomic<int> calls_{0}, rejected_{0}, failed_calls_{0};

  bool learned_ = false, in_order_ = true;
  long sent_ = 0, results_ = 0, dropped_ = 0, torn_ = 0, distinct_ = 0;
  ros::Time last_;
  Fingerprint newest_;
};

TEST_F(Endurance, FramesAtTheHighestRateWhileParametersChange) {
  const int frames = ros::NodeHandle("~").param("frames", 800);
  ASSERT_GT(distinct_, 3) << "the sets of values give the same results: nothing could be told apart";
  in_order_ = true;
  const long before = results_;
  long settled_kb = 0, largest_kb = 0;
  std::size_t number = 0;
  const ros::WallTime start = ros::WallTime::now();
  while (results_ - before < frames) {
    // Two for each result: the mailbox is never empty, and about every other frame is replaced in it.
    const long count = results_;
    send(number++);
    send(number++);
    ASSERT_TRUE(spinUntil([&] { return results_ > count; })) << "no result after " << results_ - before;
    if ((results_ - before) % 50 != 0) continue;
    const long resident = residentKb(getpid());
    if (results_ - before <= std::min(kSettled, frames / 2)) settled_kb = std::max(settled_kb, resident);
    largest_kb = std::max(largest_kb, resident);
  }
  const double seconds = (ros::WallTime::now() - start).toSec();
  // Whatever still waits comes, too; then the books must balance.
  EXPECT_TRUE(spinUntil([&] { return results_ + dropped_ == sent_; }, 10));
  std::printf(
      "%ld results of %ld frames, %ld dropped, %.0f results a second, %d calls (%d of invalid values); "
      "resident %ld kB, later at most %ld kB\n",
      results_, sent_, dropped_, frames / seconds, calls_.load(), rejected_.load(), settled_kb, largest_kb);
  EXPECT_EQ(results_ + dropped_, sent_);
  EXPECT_TRUE(in_order_);
  EXPECT_EQ(torn_, 0);
  EXPECT_EQ(failed_calls_, 0);
  EXPECT_GT(rejected_, 0);
  EXPECT_LE(largest_kb, (1 + kGrowth) * settled_kb);
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "endurance_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
