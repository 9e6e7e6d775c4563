// SPDX-License-Identifier: BSD-3-Clause
// Run by attacks.test beside the nodelet: sends what no camera should send, and after each a good frame.
#include <limits>

#include "attack_messages.hpp"
#include "nodelet_fixture.hpp"

namespace {

using namespace objectness_test;

class UnderAttack : public SegmentObjects {
 protected:
  void expectGoodFrame(Listener<SegmentedObjectArray>& objects, const std::string& after) {
    const auto result = segment(objects, goodCloud(), goodCamera());
    ASSERT_TRUE(result) << "no answer after " << after;
    EXPECT_EQ(result->status, SegmentedObjectArray::OK) << after << ": " << result->message;
    EXPECT_EQ(result->objects.size(), 2u) << after;
  }
};

TEST_F(UnderAttack, EveryInputHasItsStatusAndTheNextGoodFrameIsSegmented) {
  Listener<SegmentedObjectArray> objects(std::string(kNode) + "/objects");
  expectGoodFrame(objects, "the start");
  for (Attack& attack : makeAttacks({})) {
    const std::string frame_id = attack.name == "empty frame_id" ? "" : "some_camera";
    attack.cloud.header = nextHeader();
    attack.cloud.header.frame_id = frame_id;
    const auto result = segment(objects, attack.cloud, attack.camera_info);
    ASSERT_TRUE(result) << "no answer to " << attack.name;
    EXPECT_EQ(result->status, attack.status) << attack.name << ": " << result->message;
    EXPECT_NE(result->message.find(attack.word), std::string::npos) << attack.name << ": " << result->message;
    EXPECT_EQ(result->header.frame_id, frame_id);
    expectGoodFrame(objects, attack.name);
  }
}

TEST_F(UnderAttack, StampsThatAreNotMonotonic) {
  Listener<SegmentedObjectArray> objects(std::string(kNode) + "/objects");
  const double now = nextHeader().stamp.toSec();
  std::vector<ros::Time> stamps;
  for (const double back : {0.2, 5.0, 500.0, 0.1, 0.1, 400.0}) stamps.push_back(ros::Time(now - back));
  stamps.insert(stamps.end(), {ros::TIME_MAX, ros::Time(1, 0), ros::Time(0, 1), ros::Time(4e9), ros::Time(now)});
  for (const ros::Time& stamp : stamps) {
    PointCloud2 cloud = goodCloud();
    cloud.header.stamp = stamp;
    // An exact pair is one pair, however old: but of a stamp that was there before ExactTime makes no second one.
    const auto result = segment(objects, cloud, goodCamera());
    ASSERT_TRUE(result) << stamp;
    EXPECT_EQ(result->status, SegmentedObjectArray::OK) << stamp << ": " << result->message;
    EXPECT_EQ(result->objects.size(), 2u) << stamp;
  }
  expectGoodFrame(objects, "jumps in time");
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "attacks_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
