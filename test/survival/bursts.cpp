// SPDX-License-Identifier: BSD-3-Clause
// Run by bursts.test: four nodelets in one process and bursts of 500 frames a second, a subscriber that has stopped to
// read, and logs that cannot be written.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "hosted_nodelets.hpp"

namespace {

using namespace objectness_test;

constexpr int kNodelets = 4, kBursts = 4, kFramesPerBurst = 250;
constexpr double kPeriod_s = 1.0 / 500;
/// What the machine may take to wake a thread, beside the time of two frames.
constexpr double kScheduling_s = 0.5;

/// Everything that this process writes to its console fails as on a full disk, while this lives.
class FullDisk {
 public:
  FullDisk() {
    std::fflush(nullptr);
    const int full = open("/dev/full", O_WRONLY);
    for (int k = 0; k < 2; ++k) {
      saved_[k] = dup(k + 1);
      dup2(full, k + 1);
    }
    close(full);
  }
  ~FullDisk() {
    std::fflush(nullptr);
    for (int k = 0; k < 2; ++k) {
      dup2(saved_[k], k + 1);
      close(saved_[k]);
    }
    std::clearerr(stdout);
    std::clearerr(stderr);
  }

 private:
  int saved_[2];
};

/// A process that has subscribed to everything of a nodelet and then stands still.
class StoppedSubscriber {
 public:
  explicit StoppedSubscriber(const std::string& nodelet) {
    process_ = fork();
    if (process_ == 0) {
      execl("/proc/self/exe", "bursts_test", "--subscribe", nodelet.c_str(), "__name:=stopped_subscriber", nullptr);
      _exit(127);
    }
  }
  ~StoppedSubscriber() {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  void stop() const { kill(process_, SIGSTOP); }

 private:
  pid_t process_;
};

struct Listener {
  ros::Subscriber subscriber;
  long results = 0, dropped = 0, dropped_before = 0;
  double last_processing_s = 0, largest_latency_s = 0, largest_excess_s = 0;
  ros::Time last;
};

class Bursts : public ::testing::Test {
 protected:
  static std::string name(int k) { return "/burst" + std::to_string(k); }

  void SetUp() override {
    for (int k = 0; k < kNodelets; ++k) {
      ASSERT_TRUE(host_.load(name(k)));
      listeners_[k].subscriber =
          listen(name(k), [this, k](const SegmentedObjectArrayConstPtr& array) { receive(listeners_[k], *array); });
    }
    // All nodelets of a process are one subscriber to roscpp: who answers has subscribed.
    const auto all_answered = [&] {
      send(0);
      return spinUntil([&] { return everyOneIsDone(); }, 0.5);
    };
    ASSERT_TRUE(spinUntil(all_answered));
    sent_ = 0;
    for (Listener& listener : listeners_) {
      listener.results = 0;
      listener.dropped_before = listener.dropped;
    }
  }

  void receive(Listener& listener, const SegmentedObjectArray& array) {
    const double sent_s = sent_at_[array.header.stamp.toNSec() / 1000000 % sent_at_.size()];
    const double latency = ros::WallTime::now().toSec() - sent_s;
    // The frame that was worked on when it arrived, and its own.
    const double two_frames = listener.last_processing_s + array.processing_time;
    listener.largest_latency_s = std::max(listener.largest_latency_s, latency);
    listener.largest_excess_s = std::max(listener.largest_excess_s, latency - two_frames);
    listener.last_processing_s = array.processing_time;
    ++listener.results;
    listener.dropped = array.dropped_frames;
    listener.last = array.header.stamp;
  }

  void send(std::size_t number) {
    const double now = ros::WallTime::now().toSec();
    const ros::Time stamp = host_.send(frames_, number);
    sent_at_[stamp.toNSec() / 1000000 % sent_at_.size()] = now;
    ++sent_;
    last_stamp_ = stamp;
  }

  void sendBurst() {
    for (int i = 0; i < kFramesPerBurst; ++i) {
      const ros::WallTime next = ros::WallTime::now() + ros::WallDuration(kPeriod_s);
      send(i);
      do {
        ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.0005));
      } while (ros::WallTime::now() < next);
    }
  }

  bool everyOneIsDone() const {
    return std::all_of(std::begin(listeners_), std::end(listeners_),
                       [&](const Listener& listener) { return listener.last == last_stamp_; });
  }

  HostedNodelets host_;
  const SmallFrames frames_{9};
  Listener listeners_[kNodelets];
  std::vector<double> sent_at_ = std::vector<double>(1 << 16);
  long sent_ = 0;
  ros::Time last_stamp_;
};

TEST_F(Bursts, KeepTheNewestAndCountTheRest) {
  const StoppedSubscriber stopped(name(0));
  const auto looksOn = [&] {
    ros::V_string nodes;
    ros::master::getNodes(nodes);
    return std::find(nodes.begin(), nodes.end(), "/stopped_subscriber") != nodes.end();
  };
  ASSERT_TRUE(spinUntil(looksOn));
  send(0);  // reaches it, too
  ASSERT_TRUE(spinUntil([&] { return everyOneIsDone(); }));
  stopped.stop();
  {
    const FullDisk disk;
    for (int burst = 0; burst < kBursts; ++burst) {
      sendBurst();
      if (!spinUntil([&] { return everyOneIsDone(); })) break;
    }
  }
  ASSERT_TRUE(everyOneIsDone()) << "the newest frame of a burst was not segmented";
  for (const Listener& listener : listeners_) {
    const long dropped = listener.dropped - listener.dropped_before;
    std::printf("%ld results, %ld dropped of %ld; latency at most %.3f s, %+.3f s against two frames\n",
                listener.results, dropped, sent_, listener.largest_latency_s, listener.largest_excess_s);
    EXPECT_EQ(listener.results + dropped, sent_);
    EXPECT_GT(dropped, 0);
    EXPECT_LT(listener.largest_excess_s, kScheduling_s);
  }
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (argc > 2 && std::string(argv[1]) == "--subscribe") {
    ros::init(argc, argv, "stopped_subscriber");
    const ros::Subscriber subscriber = listen(argv[2], [](const SegmentedObjectArrayConstPtr&) {});
    ros::spin();
    return 0;
  }
  ros::init(argc, argv, "bursts_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
