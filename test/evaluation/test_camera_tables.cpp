// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "evaluation/camera_tables.hpp"

using namespace objectness;
using namespace objectness::evaluation;

namespace {

SceneResult resultOf(const std::string& method, const std::string& scene) {
  SceneResult result;
  result.method = method;
  result.scene = scene;
  return result;
}

SceneResult labelled(const std::string& scene, double recall, double extra, double ms) {
  SceneResult result = resultOf("lccp", scene);
  result.object = Scores{};
  result.object->recall = recall;
  result.object->extra = extra;
  result.timings_ms = {{"total", ms}};
  return result;
}

SceneResult boxed(const std::string& scene, const PictureBoxCounts& counts) {
  SceneResult result = resultOf("lccp", scene);
  result.picture_boxes = counts;
  return result;
}

}  // namespace

TEST(CameraTables, MeansOfLabelsAndSumsOfBoxesByDataSet) {
  objectness::evaluation::Run run;
  run.methods = {{"lccp", "", ""}, {"oracle", "", ""}};
  run.scenes = {{"a", "easy", "kinect"}, {"b", "hard", "kinect"}, {"c", "all", "kinect"},
                {"d", "all", "xtion"},   {"e", "all", "xtion"},   {"f", "all", "bare"}};
  std::vector<SceneResult> results{labelled("a", 0.5, 1, 10),       labelled("b", 1, 0, 20),
                                   labelled("c", 0, 5, 60),         boxed("d", {5, 4, 3, 1, 7, 2}),
                                   boxed("e", {10, 6, 5, 0, 8, 1}), resultOf("lccp", "f")};
  results[5].state = SceneResult::State::kUnusable;
  results.push_back(resultOf("oracle", "d"));
  results.back().state = SceneResult::State::kNotApplicable;
  const std::vector<CameraRow> rows = summarizeCameras(run, results);
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[0].group, "easy");
  EXPECT_EQ(rows[1].group, "hard");
  EXPECT_EQ(rows[1].labels->recall, 1);
  EXPECT_EQ(rows[2].camera, "kinect");
  EXPECT_EQ(rows[2].group, "");
  EXPECT_EQ(rows[2].scenes, 3);
  EXPECT_NEAR(rows[2].labels->recall, 0.5, 1e-12);
  EXPECT_NEAR(rows[2].labels->extra, 2, 1e-12);
  EXPECT_EQ(rows[2].ms, 20);
  EXPECT_FALSE(rows[2].boxes.has_value());
  EXPECT_EQ(rows[3].camera, "xtion");
  EXPECT_EQ(rows[3].scenes, 2);
  EXPECT_FALSE(rows[3].labels.has_value());
  std::vector<int> sums;
  PictureBoxCounts::fields(*rows[3].boxes, [&](const char*, int value) { sums.push_back(value); });
  EXPECT_EQ(sums, (std::vector<int>{15, 10, 8, 1, 15, 3}));
  EXPECT_NE(toText(rows).find("lccp       xtion"), std::string::npos) << toText(rows);
  EXPECT_NE(toText(rows).find("lccp         hard"), std::string::npos) << toText(rows);
  EXPECT_TRUE(toText(std::vector<CameraRow>{}).empty());
}

TEST(CameraTables, ACameraMayHaveLabelsAndBoxes) {
  objectness::evaluation::Run run;
  run.methods = {{"lccp", "", ""}};
  run.scenes = {{"a", "all", "both"}, {"b", "all", "both"}};
  SceneResult with_boxes = labelled("a", 0.5, 1, 10);
  with_boxes.picture_boxes = PictureBoxCounts{3, 2, 1, 0, 2, 0};
  const std::vector<CameraRow> rows = summarizeCameras(run, {with_boxes, boxed("b", {1, 1, 1, 0, 1, 0})});
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].scenes, 2);
  EXPECT_EQ(rows[0].labelled, 1);
  EXPECT_EQ(rows[0].labels->recall, 0.5) << "the scene without labels is none of those in the mean";
  EXPECT_EQ(rows[0].boxes->objects, 4);
}
