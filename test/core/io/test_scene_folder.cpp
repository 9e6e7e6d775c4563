// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "fixtures/temporary_folder.hpp"
#include "objectness_segmentation/io/camera_yaml.hpp"
#include "objectness_segmentation/io/input_file.hpp"
#include "objectness_segmentation/io/scene_folder.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

const PinholeCamera kCamera{50, 51, 15.5, 11.5, 32, 24};

/// A scene of 32 x 24 pixels, 1 m + 1 mm a pixel deep, that each test breaks in its own way.
class SceneFolder : public testing::Test {
 protected:
  void SetUp() override {
    SceneImages scene;
    scene.camera = kCamera;
    scene.depth_mm.create(24, 32);
    scene.color.create(24, 32);
    for (int i = 0; i < 24 * 32; ++i) {
      scene.depth_mm(i / 32, i % 32) = static_cast<ushort>(1000 + i);
      scene.color(i / 32, i % 32) = {static_cast<uchar>(i % 256), 20, 200};
    }
    scene.depth_mm(3, 4) = 0;
    const Status saved = saveSceneFolder(folder_ / "scene", scene);
    ASSERT_TRUE(saved.ok()) << saved.message;
  }

  Result<Frame> load() const { return loadInput(folder_ / "scene", {}, InputConfig()); }
  std::string file(const std::string& name) const { return folder_ / ("scene/" + name); }
  void expectError(const std::string& text) const {
    const Result<Frame> frame = load();
    EXPECT_FALSE(frame.ok());
    EXPECT_NE(frame.status.message.find(text), std::string::npos) << frame.status.message;
  }

  TemporaryFolder folder_;
};

}  // namespace

TEST_F(SceneFolder, ReadsWhatWasWritten) {
  const Result<Frame> frame = load();
  ASSERT_TRUE(frame.ok()) << frame.status.message;
  EXPECT_EQ(frame.value.camera.fy, 51);
  EXPECT_EQ(frame.value.width(), 32);
  EXPECT_TRUE(std::isnan(frame.value.points[3 * 32 + 4].z()));
  const Eigen::Vector3f p = frame.value.points[10 * 32 + 20];
  EXPECT_NEAR(p.z(), 1.340f, 1e-6);
  EXPECT_NEAR(p.x(), (20 - 15.5) / 50 * 1.340, 1e-6);
  EXPECT_NEAR(p.y(), (10 - 11.5) / 51 * 1.340, 1e-6);
  EXPECT_EQ(frame.value.color(10, 20), cv::Vec3b(340 % 256, 20, 200));
}

TEST_F(SceneFolder, ColorIsOptional) {
  std::filesystem::remove(file("color.png"));
  ASSERT_TRUE(load().ok());
  EXPECT_TRUE(load().value.color.empty());
}

TEST_F(SceneFolder, MissingFiles) {
  EXPECT_NE(loadInput(folder_ / "nothing", {}, {}).status.message.find("no such file or folder"), std::string::npos);
  std::filesystem::remove(file("camera.yaml"));
  expectError("camera.yaml: there is no such file");
  EXPECT_TRUE(loadInput(folder_ / "scene", kCamera, {}).ok());
  std::filesystem::remove(file("depth.png"));
  expectError("holds no depth.png");
  writeBytes(folder_ / "notes.txt", "x");
  EXPECT_NE(loadInput(folder_ / "notes.txt", {}, {}).status.message.find("neither a scene folder"), std::string::npos);
}

TEST_F(SceneFolder, CutOffDepth) {
  for (const double share : {0.95, 0.5, 0.02}) {
    truncateFile(file("depth.png"), share);
    expectError(std::filesystem::file_size(file("depth.png")) > 8 ? "depth.png: is cut off after" : "depth.png: is");
  }
  writeBytes(file("depth.png"), "");
  expectError("depth.png: is empty");
}

TEST_F(SceneFolder, DamagedDepth) {
  std::string bytes = readBytes(file("depth.png"));
  bytes[bytes.size() / 2] ^= 0x55;
  writeBytes(file("depth.png"), bytes);
  expectError("depth.png: is damaged");
}

TEST_F(SceneFolder, TextNamedPng) {
  writeBytes(file("depth.png"), "this is no picture at all");
  expectError("depth.png: is not a PNG image");
}

TEST_F(SceneFolder, DepthOfEightBits) {
  cv::imwrite(file("depth.png"), cv::Mat(24, 32, CV_8UC1, cv::Scalar(9)));
  expectError("depth.png: is 8-bit with 1 channel, must be 16-bit with 1 channel");
  cv::imwrite(file("depth.png"), cv::Mat(24, 32, CV_16UC3, cv::Scalar(9, 9, 9)));
  expectError("depth.png: is 16-bit with 3 channels");
}

TEST_F(SceneFolder, DepthOfAnotherKindIsNamed) {
  std::filesystem::remove(file("depth.png"));
  for (const char* name : {"depth.exr", "depth.npy", "depth.tiff"}) {
    writeBytes(file(name), "x");
    expectError(std::string("holds ") + name + ", which is not read: convert it to depth.png");
  }
  const std::pair<std::string, std::string> formats[] = {
      {std::string("II*\0", 4), "TIFF"}, {"\xff\xd8\xff\xe0", "JPEG"}, {"P5\n2 2\n65535\n", "PGM"}};
  for (const auto& [bytes, name] : formats) {
    writeBytes(file("depth.png"), bytes + "rest");
    expectError("depth.png: is a " + name + " image, must be PNG");
  }
}

TEST_F(SceneFolder, ColourThatDoesNotFitIsARemark) {
  const auto expectRemark = [&](const std::string& text) {
    const Result<Frame> frame = load();
    ASSERT_TRUE(frame.ok()) << frame.status.message;
    EXPECT_TRUE(frame.value.color.empty());
    ASSERT_EQ(frame.value.remarks.size(), 1u);
    EXPECT_NE(frame.value.remarks[0].find(text), std::string::npos) << frame.value.remarks[0];
  };
  cv::imwrite(file("color.png"), cv::Mat(12, 16, CV_8UC3));
  expectRemark("color.png is 16 x 12, depth.png 32 x 24: the results have no colour");
  writeBytes(file("color.png"), "no picture");
  expectRemark("color.png: is not a PNG image");
}

TEST_F(SceneFolder, SizesThatDiffer) {
  std::filesystem::remove(file("color.png"));
  cv::imwrite(file("depth.png"), cv::Mat(12, 20, CV_16UC1, cv::Scalar(1000)));
  expectError("depth image is 20 x 12 but its camera is 32 x 24");
  cv::imwrite(file("depth.png"), cv::Mat(12, 16, CV_16UC1, cv::Scalar(1000)));
  const Result<Frame> half = load();
  ASSERT_TRUE(half.ok()) << half.status.message;
  EXPECT_EQ(half.value.camera.fx, 25);
  ASSERT_EQ(half.value.remarks.size(), 1u);
}

TEST_F(SceneFolder, TheUnitOfTheDepthStandsInTheCameraFile) {
  const std::string camera = readBytes(file("camera.yaml"));
  for (const char* scale : {"5000", "0.0002", "1/5000"}) {
    writeBytes(file("camera.yaml"), camera + "depth_scale: " + scale + "\n");
    const Result<Frame> frame = load();
    ASSERT_TRUE(frame.ok()) << frame.status.message;
    EXPECT_NEAR(frame.value.points[10 * 32 + 20].z(), 0.268F, 1e-6) << scale;
  }
  writeBytes(file("camera.yaml"), camera + "depth_scale: mm\n");
  expectError("camera.yaml: has a depth_scale that is 'mm', must be");
  writeBytes(file("camera.yaml"), camera + "depth_scale: [1, 2]\n");
  expectError("camera.yaml: has a depth_scale that");
}

TEST_F(SceneFolder, NoDepthAtAll) {
  cv::imwrite(file("depth.png"), cv::Mat(24, 32, CV_16UC1, cv::Scalar(0)));
  expectError("none of the 768 pixels has a depth");
}

TEST_F(SceneFolder, AbsurdImageSize) {
  // A header of 60000 x 60000 pixels with its right checksum (of "IHDR", 0x0000ea60 twice, 16 bits, grey).
  std::string bytes = readBytes(file("depth.png"));
  const std::string size("\x00\x00\xea\x60\x00\x00\xea\x60", 8);
  bytes.replace(16, 8, size);
  std::uint32_t crc = 0xffffffff;
  for (int i = 12; i < 29; ++i) {
    crc ^= static_cast<unsigned char>(bytes[i]);
    for (int bit = 0; bit < 8; ++bit) crc = crc & 1 ? 0xedb88320 ^ crc >> 1 : crc >> 1;
  }
  crc = ~crc;
  for (int i = 0; i < 4; ++i) bytes[29 + i] = static_cast<char>(crc >> (24 - 8 * i));
  writeBytes(file("depth.png"), bytes);
  expectError("depth.png: claims to be 60000 x 60000 pixels");
}

TEST_F(SceneFolder, BrokenCameras) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"image_width: [", "is not valid YAML"},
      {"", "is not a camera file"},
      {"hello", "is not a camera file"},
      {"image_width: 32", "lacks image_width or image_height"},
      {"{image_width: 32, image_height: 24}", "has no intrinsics"},
      {"{image_width: 32, image_height: tall}", "has an entry that is no number"},
      {"{image_width: 32, image_height: 24, camera_matrix: {data: [0, 0, 0, 0, 0, 0, 0, 0, 0]}}", "has no intrinsics"},
      {"{image_width: 32, image_height: 24, camera_matrix: {data: [50, 0, 15]}}",
       "camera_matrix of 3 numbers, must be 9"},
      {"{image_width: 32, image_height: 24, camera_matrix: {data: [50, 0, 15, 0, x, 11, 0, 0, 1]}}", "no number"},
      {"{image_width: 32, image_height: 24, camera_matrix: {data: [-50, 0, 15, 0, 50, 11, 0, 0, 1]}}", "focal lengths"},
      {"{image_width: 32, image_height: 24, camera_matrix: {data: [50, 0, 15, 0, 50, 11, 0, 0, 1]}, "
       "distortion_model: mirror, distortion_coefficients: {data: [0.1, 0, 0, 0, 0]}}",
       "the distortion model 'mirror' is not known"},
      {"{image_width: 32, image_height: 24, camera_matrix: {data: [50, 0, 15, 0, 50, 11, 0, 0, 1]}, binning_x: few}",
       "no number"}};
  for (const auto& [yaml, expected] : cases) {
    writeBytes(file("camera.yaml"), yaml);
    expectError("camera.yaml: ");
    expectError(expected);
  }
}

TEST_F(SceneFolder, CameraForms) {
  writeBytes(file("camera.yaml"),
             "{image_width: 32, image_height: 24, camera_matrix: {data: [1, 0, 2, 0, 3, 4, 0, 0, 1]}, "
             "distortion_coefficients: {data: [0.1, 0]}, projection_matrix: {data: [50, 0, 15, 0, 0, 60, 11, 0, 0, 0, "
             "1, 0]}}");
  EXPECT_EQ(loadCamera(file("camera.yaml")).value.fy, 60) << "the projection matrix goes first";
  writeBytes(file("camera.yaml"),
             "height: 24\nwidth: 32\nD: [0, 0]\nK: [40, 0, 15, 0, 41, 11, 0, 0, 1]\n"
             "P: [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]\n---\n");
  const Result<PinholeCamera> message = loadCamera(file("camera.yaml"));
  ASSERT_TRUE(message.ok()) << message.status.message;
  EXPECT_EQ(message.value.fy, 41) << "a projection matrix of zeros is none";
}

TEST_F(SceneFolder, TheTextOfACameraInfoMessage) {
  // As rostopic echo prints it.
  writeBytes(
      file("camera.yaml"),
      "header: \n  seq: 7\n  stamp: \n    secs: 1\n    nsecs: 2\n  frame_id: \"optical\"\nheight: 96\nwidth: 128\n"
      "distortion_model: \"plumb_bob\"\nD: [0.0, 0.0, 0.0, 0.0, 0.0]\n"
      "K: [100.0, 0.0, 63.5, 0.0, 102.0, 47.5, 0.0, 0.0, 1.0]\nR: [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]\n"
      "P: [100.0, 0.0, 63.5, 0.0, 0.0, 102.0, 47.5, 0.0, 0.0, 0.0, 1.0, 0.0]\nbinning_x: 2\nbinning_y: 2\n"
      "roi: \n  x_offset: 30\n  y_offset: 20\n  height: 48\n  width: 64\n  do_rectify: False\n---\n");
  const Result<PinholeCamera> camera = loadCamera(file("camera.yaml"));
  ASSERT_TRUE(camera.ok()) << camera.status.message;
  EXPECT_EQ(camera.value.width, 32);
  EXPECT_EQ(camera.value.height, 24);
  EXPECT_EQ(camera.value.fy, 51);
  EXPECT_EQ(camera.value.cx, (63.5 - 30) / 2);
  const Result<Frame> frame = load();
  ASSERT_TRUE(frame.ok()) << frame.status.message;
  EXPECT_TRUE(frame.value.remarks.empty());
}

TEST_F(SceneFolder, DepthThatIsNotRectified) {
  const std::string camera =
      "{image_width: 32, image_height: 24, camera_matrix: {data: [50, 0, 15.5, 0, 51, 11.5, 0, 0, 1]}, "
      "distortion_model: plumb_bob, distortion_coefficients: {data: [-0.8, 0.1, 0, 0, 0]}";
  writeBytes(file("camera.yaml"), camera + "}");
  const Result<Frame> frame = load();
  ASSERT_TRUE(frame.ok()) << frame.status.message;
  EXPECT_TRUE(frame.value.rectified);
  EXPECT_EQ(frame.value.remarks.size(), 1u);
  const Result<PinholeCamera> rectified = loadCamera(file("camera.yaml"));
  EXPECT_EQ(rectified.status.code, StatusCode::kBadCamera);
  EXPECT_NE(rectified.status.message.find("has lens distortion and no projection_matrix"), std::string::npos);
  writeBytes(file("camera.yaml"),
             camera + ", projection_matrix: {data: [50, 0, 15.5, 0, 0, 51, 11.5, 0, 0, 0, 1, 0]}}");
  const Result<Frame> unclear = load();
  ASSERT_TRUE(unclear.ok()) << unclear.status.message;
  EXPECT_FALSE(unclear.value.rectified);
  ASSERT_EQ(unclear.value.remarks.size(), 1u);
  EXPECT_NE(unclear.value.remarks[0].find("lens distortion, up to"), std::string::npos);
}

TEST(InputName, FolderOrStem) {
  EXPECT_EQ(inputName("data/scene7/"), "scene7");
  EXPECT_EQ(inputName("data/scene.7"), "scene.7");
  EXPECT_EQ(inputName("data/../cloud.v2.pcd"), "cloud.v2");
  EXPECT_EQ(inputName("/"), "");
}
