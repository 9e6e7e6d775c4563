// SPDX-License-Identifier: BSD-3-Clause
// make_scene --bag, run as a user runs it.
#include <gtest/gtest.h>
#include <sensor_msgs/Image.h>

#include <cstring>
#include <opencv2/imgcodecs.hpp>

#include "fixtures/bag_files.hpp"
#include "fixtures/tool_test.hpp"
#include "objectness_segmentation/ros/topics.hpp"

namespace {

using namespace objectness_segmentation;
using namespace objectness_test;

class MakeSceneBag : public ToolTest {
 protected:
  Outcome run(const std::string& arguments) const {
    return ToolTest::run("make_scene", "--demo --size 160x120 " + arguments);
  }
  const std::string bag_ = folder_ / "scene.bag";
};

TEST_F(MakeSceneBag, HoldsTheSequenceOfTheFolders) {
  const Outcome outcome = run("--frames 3 --rate 4 --out " + (folder_ / "sequence") + " --bag " + bag_);
  ASSERT_EQ(outcome.exit_status, 0) << outcome.err;
  const auto labels = readAll<sensor_msgs::Image>(bag_, bag_topics::kTrueLabels);
  ASSERT_EQ(labels.size(), 3u);
  EXPECT_EQ(labels[2]->header.stamp - labels[0]->header.stamp, ros::Duration(0.5));
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const cv::Mat saved =
        cv::imread(folder_ / ("sequence/frame_000" + std::to_string(i) + "/labels.png"), cv::IMREAD_UNCHANGED);
    ASSERT_EQ(saved.total() * saved.elemSize(), labels[i]->data.size());
    EXPECT_EQ(std::memcmp(saved.data, labels[i]->data.data(), labels[i]->data.size()), 0);
  }
}

TEST_F(MakeSceneBag, IsRefusedWhenItMakesNoSense) {
  for (const auto& [arguments, text] : std::vector<std::pair<std::string, std::string>>{
           {"", "neither --out DIR nor --bag FILE"},
           {"--rate 0 --bag " + bag_, "--rate: must be"},
           {"--rate nan --bag " + bag_, "--rate: must be"},
           {"--rate 5 --out " + folder_.path(), "--rate belongs to --bag"}}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_status, 2) << arguments;
    EXPECT_NE(outcome.err.find(text), std::string::npos) << outcome.err;
  }
  const Outcome outcome = run("--bag " + (folder_ / "none/scene.bag"));
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_NE(outcome.err.find("none/scene.bag: cannot be written"), std::string::npos) << outcome.err;
}

}  // namespace
