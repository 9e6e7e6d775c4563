// SPDX-License-Identifier: BSD-3-Clause
// Run by examples.test beside the node: a program of examples/ asks it.
#include <future>

#include "fixtures/tool_test.hpp"
#include "nodelet_fixture.hpp"

namespace {

using namespace objectness_test;

/// What runs it: a test has one fixture only.
class Client : public ToolTest {
 public:
  Outcome ask(const std::string& service) const { return run("nearest_object_client", "segment:=" + service); }

 private:
  void TestBody() override {}
};

class ExampleClient : public SegmentObjects {
 protected:
  void SetUp() override {
    SegmentObjects::SetUp();
    ASSERT_TRUE(ros::service::waitForService(std::string(kNode) + "/segment", kTimeout * 1000));
  }

  Client client_;
};

TEST_F(ExampleClient, PrintsTheNearestObject) {
  auto outcome = std::async(std::launch::async, [this] { return client_.ask(std::string(kNode) + "/segment"); });
  ASSERT_TRUE(waitUntil([&] { return inputsConnected(); }));
  send(goodCloud(), goodCamera());
  const auto answer = outcome.get();
  ASSERT_EQ(answer.exit_status, 0) << answer.err;

  const Eigen::Vector3d camera = scene_.T_world_camera.translation();
  const TrueBox& nearest =
      (boxes_[0].centre() - camera).norm() < (boxes_[1].centre() - camera).norm() ? boxes_[0] : boxes_[1];
  const std::size_t line = answer.out.find("object ");  // roscpp's own log comes before it
  ASSERT_NE(line, std::string::npos) << answer.out;
  geometry_msgs::Point found;
  int label = 0;
  ASSERT_EQ(std::sscanf(answer.out.c_str() + line, "object %d at %lf %lf %lf m in some_camera/optical_frame", &label,
                        &found.x, &found.y, &found.z),
            4)
      << answer.out;
  EXPECT_GE(label, 2);
  EXPECT_LT((toWorld(found) - nearest.centre()).norm(), 0.02) << answer.out;
}

TEST_F(ExampleClient, SaysWhatIsWrongWithTheFrame) {
  auto outcome = std::async(std::launch::async, [this] { return client_.ask(std::string(kNode) + "/segment"); });
  ASSERT_TRUE(waitUntil([&] { return inputsConnected(); }));
  PointCloud2 cloud = goodCloud();
  cloud.data.resize(10);
  send(cloud, goodCamera());
  const auto answer = outcome.get();
  EXPECT_EQ(answer.exit_status, 1) << answer.out;
  EXPECT_EQ(answer.errorLines(), 1) << answer.err;
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "examples_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
