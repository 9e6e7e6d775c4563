// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <boost/make_shared.hpp>
#include <utility>
#include <vector>

#include "fixtures/ros_messages.hpp"
#include "ros/camera_partners.hpp"

namespace {

using namespace objectness_segmentation;
using namespace objectness_test;
using std::chrono::milliseconds;

/// Which input went on, and with which camera_info: its number, kAlone for none. Numbers count what was sent.
using Handed = std::pair<int, int>;
constexpr int kAlone = -1;

class Partners : public testing::Test {
 protected:
  void use(CameraPartners::Settings settings) { partners_ = CameraPartners(settings); }

  void sendInput(double stamp_s, const std::string& frame = "a") {
    partners_.addInput(makeHeader(stamp_s, frame), now_, [this, number = inputs_++](const auto& camera) {
      handed_.emplace_back(number, camera ? static_cast<int>(camera->width) : kAlone);
    });
  }
  void sendCamera(double stamp_s, const std::string& frame = "a") {
    const auto camera = boost::make_shared<sensor_msgs::CameraInfo>();
    camera->header = makeHeader(stamp_s, frame);
    camera->width = static_cast<std::uint32_t>(cameras_++);
    partners_.addCamera(camera, now_);
  }
  void wait(int ms) {
    now_ += milliseconds(ms);
    partners_.lookAgain(now_);
  }
  std::vector<Handed> take() { return std::exchange(handed_, {}); }

  /// Inputs at 30 Hz without a partner, until they do not wait for one any more.
  void sendUntilNoneWaits(const std::string& frame = "a") {
    for (int i = 0; i < 30; ++i, wait(33)) sendInput(100 + 0.033 * i, frame);
    EXPECT_FALSE(partners_.partnersCome());
    take();
  }

  CameraPartners partners_{{}};
  CameraPartners::Clock::time_point now_ = CameraPartners::Clock::now();
  int inputs_ = 0, cameras_ = 0;
  std::vector<Handed> handed_;
};

TEST_F(Partners, OfTheSameStampAreFoundInAnyOrder) {
  sendCamera(1);
  sendInput(1);
  EXPECT_EQ(take(), (std::vector<Handed>{{0, 0}}));
  sendInput(2);
  EXPECT_EQ(take(), (std::vector<Handed>{}));
  sendCamera(2);
  EXPECT_EQ(take(), (std::vector<Handed>{{1, 1}}));
  // Clouds that take long to compute come long after their camera_info.
  for (int i = 3; i < 60; ++i) sendCamera(i);
  sendInput(4);
  EXPECT_EQ(take(), (std::vector<Handed>{{2, 3}}));
  EXPECT_TRUE(partners_.partnersCome());
  EXPECT_EQ(partners_.withLastCamera(), 0u);
}

TEST_F(Partners, ThatPairAreWaitedForWhateverTheFrame) {
  sendCamera(1, "b");
  sendInput(1, "a");
  sendInput(2, "a");
  wait(400);
  sendCamera(2, "b");
  EXPECT_EQ(take(), (std::vector<Handed>{{0, 0}, {1, 1}}));
}

TEST_F(Partners, ALostOneCostsAMomentOnly) {
  sendCamera(1);
  sendInput(1);
  sendInput(2);
  take();
  wait(400);
  EXPECT_EQ(take(), (std::vector<Handed>{}));
  wait(101);
  EXPECT_EQ(take(), (std::vector<Handed>{{1, 0}}));
  EXPECT_TRUE(partners_.partnersCome());
  sendInput(3);
  EXPECT_EQ(take(), (std::vector<Handed>{})) << "waits for its own again";
  sendCamera(3);
  EXPECT_EQ(take(), (std::vector<Handed>{{2, 1}}));
}

TEST_F(Partners, OfALaterInputGiveUpTheEarlierOnes) {
  sendCamera(1);
  sendInput(2);
  sendInput(3);
  sendCamera(3);
  EXPECT_EQ(take(), (std::vector<Handed>{{1, 1}}));
  sendCamera(2);
  wait(1000);
  EXPECT_EQ(take(), (std::vector<Handed>{})) << "results never go back";
}

TEST_F(Partners, OnceAndLatchedServeAllInputs) {
  sendCamera(0);
  sendInput(100);
  wait(501);
  EXPECT_EQ(take(), (std::vector<Handed>{{0, 0}})) << "even a single input";
  sendUntilNoneWaits();
  for (int i = 0; i < 20; ++i) {
    sendInput(200 + i);
    EXPECT_EQ(take(), (std::vector<Handed>{{31 + i, 0}})) << "at once";
    wait(33);
  }
}

TEST_F(Partners, ThatAreSlowDoNotSlowDownTheInputs) {
  for (const int every : {2, 3, 30}) {
    use({});
    inputs_ = 0;
    for (int i = 0; i < 300; ++i, wait(33)) {
      sendInput(100 + 0.033 * i);
      if (i % every == 0) sendCamera(100 + 0.033 * i);
      const auto now = take();
      if (i < 60) continue;
      ASSERT_EQ(now.size(), 1u) << i << ", one camera_info for " << every << " inputs";
      EXPECT_EQ(now[0].first, i);
    }
  }
}

TEST_F(Partners, ThatAreSlowArePreferredWhenTheyPair) {
  sendCamera(0);
  sendUntilNoneWaits();
  sendCamera(300);  // number 1
  sendCamera(0);
  sendInput(300);
  sendInput(301);
  EXPECT_EQ(take(), (std::vector<Handed>{{30, 1}, {31, 2}}));
}

TEST_F(Partners, AreWaitedForAgainOnceAllPair) {
  sendCamera(0);
  sendUntilNoneWaits();
  for (int i = 0; i < 30; ++i, wait(33)) {
    sendInput(300 + i);
    sendCamera(300 + i);
    EXPECT_EQ(take().size(), 1u);
  }
  EXPECT_TRUE(partners_.partnersCome());
  sendInput(330);
  EXPECT_EQ(take(), (std::vector<Handed>{}));
  sendCamera(330);
  EXPECT_EQ(take(), (std::vector<Handed>{{60, 31}}));
}

TEST_F(Partners, ThatBeginLateAreNotTakenForMissing) {
  for (int i = 0; i < 20; ++i, wait(33)) sendInput(1 + i);
  for (int i = 20; i < 24; ++i, wait(33)) {
    sendInput(1 + i);
    sendCamera(1 + i);
  }
  EXPECT_EQ(take(), (std::vector<Handed>{{20, 0}, {21, 1}, {22, 2}, {23, 3}}));
  EXPECT_TRUE(partners_.partnersCome());
}

TEST_F(Partners, ThatComeAfterTheFirstInputsServeTheNewestOfThese) {
  for (int i = 0; i < 10; ++i, wait(33)) sendInput(1 + i);
  EXPECT_EQ(take(), (std::vector<Handed>{}));
  sendCamera(0);
  wait(600);
  EXPECT_EQ(take(), (std::vector<Handed>{{9, 0}}));
}

TEST_F(Partners, OfAnotherFrameAreNoCamera) {
  sendCamera(0, "/b");
  sendUntilNoneWaits("a");
  sendInput(200, "a");
  sendInput(201, "b");
  sendInput(202, "/b");
  sendInput(203, "");
  EXPECT_EQ(take(), (std::vector<Handed>{{31, 0}, {32, 0}, {33, 0}}));
  use({false, true, 5});
  sendCamera(0, "b");
  sendInput(200, "a");
  wait(501);
  EXPECT_EQ(take(), (std::vector<Handed>{{34, kAlone}})) << "a cloud does without";
  sendCamera(0, "");
  sendInput(201, "a");
  wait(501);
  EXPECT_EQ(take(), (std::vector<Handed>{{35, 2}})) << "no frame_id says nothing";
}

TEST_F(Partners, MissingAltogether) {
  use({false, true, 5});
  sendInput(1);
  wait(1900);
  EXPECT_EQ(take(), (std::vector<Handed>{}));
  wait(101);
  EXPECT_EQ(take(), (std::vector<Handed>{{0, kAlone}})) << "even a single input";
  sendInput(2);
  EXPECT_EQ(take(), (std::vector<Handed>{{1, kAlone}})) << "at once";
  use({});
  sendInput(3);
  wait(100000);
  EXPECT_EQ(take(), (std::vector<Handed>{})) << "a depth image cannot do without";
}

TEST_F(Partners, OfTheNearestStampWhenApproximate) {
  use({true, false, 5});
  sendCamera(1.0);
  sendInput(1.2);
  EXPECT_EQ(take(), (std::vector<Handed>{})) << "a nearer one may come";
  sendCamera(1.3);
  EXPECT_EQ(take(), (std::vector<Handed>{{0, 1}}));
  sendInput(1.75);
  sendInput(1.5);
  sendCamera(2.0);
  EXPECT_EQ(take(), (std::vector<Handed>{{1, 2}, {2, 1}}));
  sendCamera(2.5, "another frame");
  sendInput(2.25);
  EXPECT_EQ(take(), (std::vector<Handed>{{3, 2}})) << "the earlier of two";
  sendInput(9);
  sendCamera(9);
  EXPECT_EQ(take(), (std::vector<Handed>{{4, 4}}));
}

TEST_F(Partners, WithoutStampServeAllInputsWhenApproximate) {
  use({true, false, 5});
  sendCamera(0, "b");
  sendUntilNoneWaits("a");
  sendCamera(0, "b");
  sendInput(300, "a");
  EXPECT_EQ(take(), (std::vector<Handed>{{30, 1}}));
}

TEST_F(Partners, ThatAreSlowDoNotSlowDownTheInputsWhenApproximate) {
  use({true, false, 5});
  std::size_t handed = 0;
  for (int i = 0; i < 300; ++i, wait(33)) {
    sendInput(100 + 0.033 * i);
    if (i % 30 == 0) sendCamera(100.01 + 0.033 * i);
    const std::size_t count = take().size();
    handed += i >= 60 ? count : 0;
  }
  EXPECT_EQ(handed, 240u);
}

TEST_F(Partners, InputsWithoutStampHaveTheNewestOne) {
  for (const bool approximate : {false, true}) {
    use({approximate, false, 5});
    sendCamera(1);
    sendCamera(2);
    sendCamera(0);
    const int newest = cameras_ - 1;
    sendInput(0);
    sendInput(0);
    EXPECT_EQ(take(), (std::vector<Handed>{{inputs_ - 2, newest}, {inputs_ - 1, newest}}));
  }
}

TEST_F(Partners, OfATimeThatIsOver) {
  sendCamera(5);
  sendInput(6);
  partners_.forgetInputs();
  partners_.forgetStamps();
  sendCamera(6);
  sendInput(5);
  EXPECT_EQ(take(), (std::vector<Handed>{}));
  wait(501);
  EXPECT_EQ(take(), (std::vector<Handed>{{1, 1}})) << "a camera stays one";
}

TEST_F(Partners, AnyStampMayCome) {
  for (const bool approximate : {false, true}) {
    use({approximate, false, 5});
    for (const auto& stamp : {ros::TIME_MAX, ros::Time(0, 1), ros::TIME_MAX, ros::Time(1, 0)}) {
      std_msgs::Header header;
      header.stamp = stamp;
      const auto camera = boost::make_shared<sensor_msgs::CameraInfo>();
      camera->header = header;
      int handed = 0;
      partners_.addInput(header, now_, [&](const auto& found) { handed += found->header.stamp == stamp ? 1 : 0; });
      partners_.addCamera(camera, now_);
      wait(5000);
      EXPECT_GE(handed, approximate ? 0 : 1) << stamp;
    }
  }
}

}  // namespace
