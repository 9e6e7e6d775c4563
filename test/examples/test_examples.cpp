// SPDX-License-Identifier: BSD-3-Clause
// The programs of examples/, run as a user runs them.
#include <opencv2/imgcodecs.hpp>

#include "fixtures/tool_test.hpp"
#include "objectness_segmentation/io/camera_yaml.hpp"
#include "objectness_segmentation/io/input_file.hpp"
#include "objectness_segmentation/pipeline.hpp"

using namespace objectness_test;

namespace {

constexpr char kModel[] = REPOSITORY_DIR "/cfg/objectness_model.json";

class Examples : public ToolTest {
 protected:
  void SetUp() override { ASSERT_EQ(run("make_scene", "--demo --size 320x240 --out " + scene_).exit_status, 0); }

  /// What the library itself says about the scene.
  objectness::Segmentation expected() const {
    const auto frame = objectness::loadInput(scene_, {}, {});
    EXPECT_TRUE(frame.ok()) << frame.status.message;
    return objectness::segment(frame.value, {});
  }
  static long lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

  const std::string scene_ = folder_ / "scene";
};

TEST_F(Examples, SegmentFilePrintsEveryObject) {
  const Outcome outcome = run("segment_file", scene_);
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  const auto result = expected();
  ASSERT_GE(result.segments.size(), 3u);
  EXPECT_EQ(lines(outcome.out), static_cast<long>(result.segments.size())) << outcome.out;
  EXPECT_EQ(outcome.out.find(std::to_string(result.segments[0].pixels.size()) + " pixels, objectness "), 0u)
      << outcome.out;
}

TEST_F(Examples, SegmentFileSaysWhatIsWrong) {
  for (const std::string& input : {std::string(), folder_ / "nothing"}) {
    const Outcome outcome = run("segment_file", input);
    EXPECT_EQ(outcome.exit_status, 1);
    EXPECT_EQ(outcome.errorLines(), 1) << outcome.err;
    EXPECT_TRUE(outcome.out.empty()) << outcome.out;
  }
}

TEST_F(Examples, OwnCameraTakesIntrinsicsAndUnit) {
  const auto camera = objectness::loadCamera(scene_ + "/camera.yaml");
  ASSERT_TRUE(camera.ok()) << camera.status.message;
  const objectness::PinholeCamera& pinhole = camera.value;
  std::string intrinsics;
  for (const double value : {pinhole.fx, pinhole.fy, pinhole.cx, pinhole.cy}) intrinsics += " " + std::to_string(value);
  const Outcome outcome = run("own_camera", scene_ + "/depth.png" + intrinsics + " 0.001 " + (folder_ / "labels.png"));
  ASSERT_EQ(outcome.exit_status, 0) << outcome.err;
  const cv::Mat labels = cv::imread(folder_ / "labels.png", cv::IMREAD_UNCHANGED);
  ASSERT_EQ(labels.type(), CV_16U);
  EXPECT_EQ(cv::countNonZero(labels != expected().labels), 0);

  // In centimetres everything is too far away to be depth.
  const Outcome far = run("own_camera", scene_ + "/depth.png" + intrinsics + " 0.01 " + (folder_ / "far.png"));
  EXPECT_EQ(far.exit_status, 1) << far.out;
  EXPECT_EQ(run("own_camera", "").exit_status, 2);
}

TEST_F(Examples, OwnModelTakesTheFile) {
  const Outcome outcome = run("own_model", std::string(kModel) + " " + scene_);
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_EQ(lines(outcome.out), static_cast<long>(expected().segments.size()) + 1) << outcome.out;
  EXPECT_EQ(outcome.out.find("learned from "), 0u) << outcome.out;

  writeBytes(folder_ / "bad.json", "{}");
  const Outcome bad = run("own_model", (folder_ / "bad.json") + " " + scene_);
  EXPECT_EQ(bad.exit_status, 1);
  EXPECT_EQ(bad.errorLines(), 1) << bad.err;
}

}  // namespace
