// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <set>

#include "common/color_palette.hpp"
#include "fixtures/temporary_folder.hpp"
#include "fixtures/thing_without_depth.hpp"
#include "objectness_segmentation/io/overlay.hpp"
#include "objectness_segmentation/io/result_writer.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

/// One box of 10 x 20 x 30 cm, 1 m before the camera, turned by 90 degrees about the optical axis.
struct Sample {
  Frame frame;
  Segmentation result;

  Sample() {
    frame.camera = {100, 100, 49.5, 49.5, 100, 100};
    frame.points.assign(100 * 100, Eigen::Vector3f(0, 0, 1));
    result.labels = cv::Mat_<ushort>(100, 100, ushort{1});
    result.table.normal = {0, -1, 0};
    result.table.d = 0.5;
    result.table.T_table_camera.translation() = Eigen::Vector3d(0, 0, 0.5);
    result.table.hull = {{0, 0}, {1, 0}, {0, 1}};
    result.table.hull_measured = {1, 0, 1};
    Segment segment;
    segment.objectness = 1.25;
    segment.cues = {0.5, 0.25, 0.75, 0.125};
    segment.box.size_m = {0.1, 0.2, 0.3};
    segment.box.T_camera_box.translate(Eigen::Vector3d(0, 0, 1))
        .rotate(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()));
    segment.visible_box.size_m = {0.05, 0.2, 0.25};
    segment.visible_box.T_camera_box.translate(Eigen::Vector3d(0, 0.125, 1));
    segment.round = true;
    segment.support = {SupportKind::kSegment, 3, 0.0625};
    segment.carried = {1, 4};
    for (int u = 45; u < 55; ++u) {
      segment.pixels.push_back(50 * 100 + u);
      result.labels(50, u) = 2;
    }
    result.segments.push_back(segment);
    result.report.timings_ms = {{"normals", 1.5}, {"total", 2.5}};
    result.report.boxes_sampled = 123456789012;
    result.report.selection_proven = true;
    result.report.selection_gap = 0.125;
    result.report.remarks = {"the lens is dirty"};
  }
};

}  // namespace

TEST(ResultWriter, NamesTheTableAndWhatHasNoLabel) {
  Sample sample;
  sample.result.segments[0].support = {SupportKind::kTable, -1, 0};
  EXPECT_EQ(nlohmann::json::parse(toJson("", sample.result))["objects"][0]["supported_by"], 1);
  sample.result.segments[0].support = {SupportKind::kOther, -1, 0.1};
  EXPECT_EQ(nlohmann::json::parse(toJson("", sample.result))["objects"][0]["supported_by"], 0);
}

TEST(ResultWriter, JsonHoldsEverything) {
  const auto json = nlohmann::json::parse(toJson("a \"scene\"", Sample().result));
  EXPECT_EQ(json["input"], "a \"scene\"");
  EXPECT_EQ(json["status"], "ok");
  EXPECT_EQ(json["remarks"], nlohmann::json({"the lens is dirty"}));
  EXPECT_EQ(json["table"]["normal"], nlohmann::json({0.0, -1.0, 0.0}));
  EXPECT_EQ(json["table"]["d"], 0.5);
  EXPECT_EQ(json["table"]["frame"]["position"][2], -0.5);
  EXPECT_EQ(json["table"]["frame"]["orientation"], nlohmann::json({0.0, 0.0, 0.0, 1.0}));
  EXPECT_EQ(json["table"]["hull"], nlohmann::json({{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}));
  EXPECT_EQ(json["table"]["hull_measured"], nlohmann::json({true, false, true}));
  const auto& object = json["objects"][0];
  EXPECT_EQ(object["label"], 2);
  EXPECT_EQ(object["visible_box"]["position"], nlohmann::json({0.0, 0.125, 1.0}));
  EXPECT_EQ(object["visible_box"]["orientation"], nlohmann::json({0.0, 0.0, 0.0, 1.0}));
  EXPECT_EQ(object["visible_box"]["size"], nlohmann::json({0.05, 0.2, 0.25}));
  EXPECT_EQ(object["round"], true);
  EXPECT_EQ(object["supported_by"], 5);
  EXPECT_EQ(object["base_height"], 0.0625);
  EXPECT_EQ(object["supports"], nlohmann::json({3, 6}));
  EXPECT_EQ(object["size"], nlohmann::json({0.1, 0.2, 0.3}));
  EXPECT_NEAR(object["orientation"][2], std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(object["orientation"][3], std::sqrt(0.5), 1e-12);
  EXPECT_EQ(object["objectness"], 1.25);
  EXPECT_EQ(
      object["cues"],
      nlohmann::json({{"edge_density", 0.5}, {"outer_edges", 0.25}, {"straddling", 0.75}, {"free_space", 0.125}}));
  EXPECT_EQ(object["points"], 10);
  EXPECT_EQ(json["report"]["boxes_sampled"], 123456789012);
  EXPECT_EQ(json["report"]["selection_gap"], 0.125);
  EXPECT_TRUE(json["report"]["selection_proven"].is_number());
  EXPECT_EQ(json["report"]["selection_proven"], 1);
  EXPECT_FALSE(json["report"].contains("pieces")) << "there were none to count";
  EXPECT_EQ(json["report"]["timings_ms"]["total"], 2.5);
}

TEST(ResultWriter, ThingsWithoutDepthAreAList) {
  Sample sample;
  EXPECT_EQ(nlohmann::json::parse(toJson("", sample.result))["unmeasured"], nlohmann::json::array());
  Unmeasured thing = thingWithoutDepth();
  sample.result.unmeasured.push_back(thing);
  thing.box = sample.result.segments[0].box;
  sample.result.unmeasured.push_back(thing);
  const auto json = nlohmann::json::parse(toJson("", sample.result));
  ASSERT_EQ(json["unmeasured"].size(), 2u);
  const auto &flat = json["unmeasured"][0], &tall = json["unmeasured"][1];
  EXPECT_EQ(flat["outline"], nlohmann::json({{0.0, 0.5, 1.0}, {0.25, 0.5, 1.0}, {0.0, 0.5, 1.5}}));
  EXPECT_EQ(flat["points"], 1234);
  EXPECT_EQ(flat["area"], 0.0625);
  EXPECT_EQ(flat["table_share"], 0.75);
  EXPECT_EQ(flat["noise_ratio"], 4.5);
  EXPECT_TRUE(flat["box"].is_null());
  EXPECT_EQ(tall["box"]["size"], json["objects"][0]["size"]);
  EXPECT_EQ(tall["box"]["position"], json["objects"][0]["position"]);
  EXPECT_EQ(tall["box"]["orientation"], json["objects"][0]["orientation"]);
  EXPECT_EQ(json["objects"].size(), 1u);
}

TEST(ResultWriter, FailureAndOddNames) {
  Segmentation failed;
  failed.status = Status::error(StatusCode::kNoTable, "no plane");
  const auto json = nlohmann::json::parse(toJson("latin \xe9", failed));
  EXPECT_EQ(json["status"], "no_table");
  EXPECT_EQ(json["message"], "no plane");
  EXPECT_TRUE(json["table"].is_null());
  EXPECT_TRUE(json["objects"].is_array());
}

TEST(ResultWriter, WritesWholeFilesAndRemovesThem) {
  const TemporaryFolder folder;
  const Sample sample;
  const std::string out = folder / "new/deep";
  const Status status = writeResult(out, "scene", sample.frame, sample.result, true);
  ASSERT_TRUE(status.ok()) << status.message;
  std::set<std::string> files;
  for (const auto& file : std::filesystem::directory_iterator(out)) files.insert(file.path().filename());
  EXPECT_EQ(files, (std::set<std::string>{"labels.png", "objects.json", "overlay.png"}));
  const cv::Mat labels = cv::imread(out + "/labels.png", cv::IMREAD_UNCHANGED);
  ASSERT_EQ(labels.type(), CV_16UC1);
  EXPECT_EQ(cv::countNonZero(labels != sample.result.labels), 0);
  // Without pictures, that of an earlier run does not stay behind.
  ASSERT_TRUE(writeResult(out, "scene", sample.frame, sample.result, false).ok());
  EXPECT_FALSE(std::filesystem::exists(out + "/overlay.png"));
  removeResult(out);
  EXPECT_TRUE(std::filesystem::is_empty(out));
}

TEST(ResultWriter, FolderThatCannotBeMade) {
  const TemporaryFolder folder;
  writeBytes(folder / "file", "x");
  const Status status = writeResult(folder / "file", "scene", Sample().frame, Sample().result, false);
  EXPECT_NE(status.message.find("cannot make the folder"), std::string::npos) << status.message;
}

TEST(Overlay, ColoursTheSegmentAndDrawsItsBox) {
  const Sample sample;
  const cv::Mat_<cv::Vec3b> image = drawOverlay(sample.frame, sample.result);
  ASSERT_EQ(image.size(), cv::Size(100, 100));
  const Rgb color = objectColor(0);
  const cv::Vec3b line(color.b, color.g, color.r);
  // The box's front face is 0.85 m away, 20 cm wide and 10 cm high: its right edge is at 49.5 + 0.1 / 0.85 * 100.
  EXPECT_EQ(image(54, 61), line);
  EXPECT_NE(image(20, 20), line);
}

TEST(Overlay, DrawsTheOutlinesOfThingsWithoutDepth) {
  Sample sample;
  Unmeasured thing;
  thing.outline = {{-0.4, -0.4, 1}, {-0.2, -0.4, 1}, {-0.2, -0.2, 1}, {-0.4, -0.2, 1}};
  sample.result.unmeasured.push_back(thing);
  const cv::Mat_<cv::Vec3b> image = drawOverlay(sample.frame, sample.result);
  EXPECT_EQ(image(20, 10), cv::Vec3b(255, 0, 255));
  EXPECT_EQ(image(10, 20), cv::Vec3b(255, 0, 255));
  EXPECT_NE(image(20, 20), cv::Vec3b(255, 0, 255));
}

TEST(Overlay, BoxesBesideAndBehindTheCamera) {
  Sample sample;
  for (const Eigen::Vector3d& at :
       {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0, 0, -2), Eigen::Vector3d(1e6, 0, 1e-3)}) {
    sample.result.segments[0].box.T_camera_box.translation() = at;
    EXPECT_EQ(drawOverlay(sample.frame, sample.result).size(), cv::Size(100, 100));
  }
}
