// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "objectness_segmentation/ros/params.hpp"

namespace {

using namespace objectness_segmentation;

TEST(Parameters, AreReadFlatAndNested) {
  const ros::NodeHandle nh("~flat_and_nested");
  nh.setParam("objectness/weight_edges", 0.25);
  nh.setParam("objectness/weight_outer", 0.25);
  nh.setParam("objectness_weight_outer", 0.75);
  nh.setParam("input_max_depth_m", 3);  // a whole number for a double
  nh.setParam("pipeline/method", "boxes");
  nh.setParam("runtime_threads", 1);
  nh.setParam("queue_size", 3);
  const ReadParameters parameters = readParameters(nh, {"queue_size"});
  EXPECT_TRUE(parameters.problems.empty()) << parameters.problems[0];
  EXPECT_EQ(parameters.config.objectness.weight_edges, 0.25);
  EXPECT_EQ(parameters.config.objectness.weight_outer, 0.75);
  EXPECT_EQ(parameters.config.input.max_depth_m, 3);
  EXPECT_EQ(parameters.config.pipeline.method, objectness::SegmentationMethod::kBoxes);
  EXPECT_EQ(parameters.config.runtime.threads, 1);
}

TEST(Parameters, OfEarlierVersionsCountWithAWarning) {
  const ros::NodeHandle nh("~former");
  nh.setParam("grouping_enabled", false);
  const ReadParameters parameters = readParameters(nh, {});
  EXPECT_EQ(parameters.config.pipeline.method, objectness::SegmentationMethod::kPaper);
  ASSERT_EQ(parameters.problems.size(), 1u);
  EXPECT_EQ(parameters.problems[0], "parameter grouping.enabled is replaced by pipeline.method: paper");
  nh.setParam("pipeline_method", "objectness");
  const ReadParameters both = readParameters(nh, {});
  EXPECT_EQ(both.config.pipeline.method, objectness::SegmentationMethod::kObjectness);
  ASSERT_EQ(both.problems.size(), 1u);
  EXPECT_NE(both.problems[0].find("has no effect beside it"), std::string::npos);
}

TEST(Parameters, ThatAreWrongAreNamed) {
  const ros::NodeHandle nh("~wrong");
  nh.setParam("objectness_weight_edges", "a lot");
  nh.setParam("input_max_depth_m", -1.0);
  nh.setParam("search/max_size", 0.3);
  nh.setParam("pipeline_method", "graph");
  const ReadParameters parameters = readParameters(nh, {});
  ASSERT_EQ(parameters.problems.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const char* names[] = {"pipeline_method", "input_max_depth_m", "objectness_weight_edges", "search/max_size"};
    EXPECT_NE(parameters.problems[i].find(names[i]), std::string::npos) << parameters.problems[i];
  }
  EXPECT_EQ(parameters.config.input.max_depth_m, objectness::Config{}.input.max_depth_m);
}

}  // namespace
