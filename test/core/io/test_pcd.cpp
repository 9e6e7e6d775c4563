// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <sstream>

#include "fixtures/temporary_folder.hpp"
#include "objectness_segmentation/io/camera_yaml.hpp"
#include "objectness_segmentation/io/input_file.hpp"
#include "objectness_segmentation/io/pcd_file.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

const PinholeCamera kCamera{50, 51, 15.5, 11.5, 32, 24};

Eigen::Vector3f pointAt(int u, int v) {
  const double z = 1 + 0.3 * std::sin(0.4 * u) + 0.01 * v;
  return (kCamera.ray(u, v) * z).cast<float>();
}

std::string header(const std::string& size, const std::string& points, const std::string& data) {
  return "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\n" + size +
         "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + points + "\nDATA " + data + "\n";
}

std::string data(bool ascii) {
  std::ostringstream text;
  for (int i = 0; i < 24 * 32; ++i) {
    const Eigen::Vector3f p = pointAt(i % 32, i / 32);
    const std::uint32_t rgb = 10u << 16 | 20u << 8 | static_cast<std::uint32_t>(i % 256);
    if (ascii) {
      text << p.x() << ' ' << p.y() << ' ' << p.z() << ' ' << rgb << '\n';
    } else {
      text.write(reinterpret_cast<const char*>(p.data()), 12).write(reinterpret_cast<const char*>(&rgb), 4);
    }
  }
  return text.str();
}

class PcdFile : public testing::Test {
 protected:
  Result<RawCloud> load(const std::string& bytes) const {
    writeBytes(folder_ / "cloud.pcd", bytes);
    return loadPcd(folder_ / "cloud.pcd");
  }
  /// One clear sentence, and nothing printed by PCL.
  void expectError(const std::string& bytes, const std::string& text) const {
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    const Result<RawCloud> cloud = load(bytes);
    const std::string printed = testing::internal::GetCapturedStderr() + testing::internal::GetCapturedStdout();
    EXPECT_FALSE(cloud.ok()) << text;
    EXPECT_NE(cloud.status.message.find(text), std::string::npos) << cloud.status.message;
    EXPECT_EQ(printed, "");
  }

  TemporaryFolder folder_;
};

}  // namespace

TEST_F(PcdFile, AsciiAndBinaryHoldTheSame) {
  for (const bool ascii : {true, false}) {
    const Result<RawCloud> cloud = load(header("WIDTH 32\nHEIGHT 24", "768", ascii ? "ascii" : "binary") + data(ascii));
    ASSERT_TRUE(cloud.ok()) << cloud.status.message;
    EXPECT_EQ(cloud.value.width, 32);
    EXPECT_EQ(cloud.value.height, 24);
    EXPECT_TRUE(cloud.value.points[100].isApprox(pointAt(100 % 32, 100 / 32), 1e-4f));
    EXPECT_EQ(cloud.value.colors[100], cv::Vec3b(100, 20, 10));
  }
}

TEST_F(PcdFile, OrganizedRecoversItsCamera) {
  writeBytes(folder_ / "cloud.pcd", header("WIDTH 32\nHEIGHT 24", "768", "binary") + data(false));
  const Result<Frame> frame = loadInput(folder_ / "cloud.pcd", {}, InputConfig());
  ASSERT_TRUE(frame.ok()) << frame.status.message;
  EXPECT_NEAR(frame.value.camera.fx, 50, 0.01);
  EXPECT_NEAR(frame.value.camera.cy, 11.5, 0.01);
}

TEST_F(PcdFile, ListNeedsTheCamera) {
  writeBytes(folder_ / "cloud.pcd", header("WIDTH 768\nHEIGHT 1", "768", "binary") + data(false));
  const Result<Frame> without = loadInput(folder_ / "cloud.pcd", {}, InputConfig());
  EXPECT_EQ(without.status.code, StatusCode::kNotOrganized);
  EXPECT_NE(without.status.message.find("--camera"), std::string::npos);
  const Result<Frame> with = loadInput(folder_ / "cloud.pcd", kCamera, InputConfig());
  ASSERT_TRUE(with.ok()) << with.status.message;
  EXPECT_TRUE(with.value.points[5 * 32 + 9].isApprox(pointAt(9, 5), 1e-4f));
}

TEST_F(PcdFile, ViewpointIsTheSensorsPose) {
  const auto withViewpoint = [&](const std::string& viewpoint) {
    std::string text = header("WIDTH 32\nHEIGHT 24", "768", "binary");
    text.replace(text.find("0 0 0 1 0 0 0"), 13, viewpoint);
    return load(text + data(false));
  };
  EXPECT_FALSE(withViewpoint("0 0 0 1 0 0 0").value.T_cloud_sensor) << "that of files that say nothing";
  const auto cloud = withViewpoint("1 -2 0.5 0.6 0.8 0 0");
  ASSERT_TRUE(cloud.ok() && cloud.value.T_cloud_sensor);
  EXPECT_TRUE(cloud.value.T_cloud_sensor->translation().isApprox(Eigen::Vector3d(1, -2, 0.5), 1e-6));
  EXPECT_TRUE(cloud.value.T_cloud_sensor->linear().isApprox(Eigen::Quaterniond(0.6, 0.8, 0, 0).matrix(), 1e-6));
  for (const char* none : {"1 2 3 0 0 0 0", "1 2 3 5 0 0 0", "nan 0 0 1 0 0 0"}) {
    const auto odd = withViewpoint(none);
    EXPECT_TRUE(odd.ok()) << odd.status.message;
    EXPECT_FALSE(odd.value.T_cloud_sensor) << none;
  }
}

TEST_F(PcdFile, BadFiles) {
  const std::string good = header("WIDTH 32\nHEIGHT 24", "768", "binary");
  expectError("", "is empty");
  expectError("this is no cloud", "is not a PCD file");
  expectError(good.substr(0, 60), "is cut off within its header");
  expectError(good + data(false).substr(0, 500), "is cut off: its header announces 768 points");
  expectError(header("WIDTH 32\nHEIGHT 24", "768", "ascii") + data(true).substr(0, 500), "is cut off");
  expectError(header("WIDTH 32\nHEIGHT 24", "768", "binary_compressed") + "abcd", "is cut off");
  expectError(header("WIDTH 32\nHEIGHT 24", "768", "zip") + data(false), "unknown kind 'zip'");
  expectError(header("WIDTH 0\nHEIGHT 0", "0", "ascii"), "has no points");
  expectError(header("WIDTH -5\nHEIGHT 24", "768", "binary") + data(false), "has no points: its header says -5 x 24");
  expectError(header("WIDTH 32\nHEIGHT 24", "700", "binary") + data(false), "POINTS is 700");
  expectError(header("WIDTH 4000000000\nHEIGHT 4000000000", "16000000000000000000", "binary") + data(false),
              "claims 4000000000 x 4000000000 points");
  expectError(header("WIDTH 32\nHEIGHT 24\nWIDTH 1", "768", "binary") + data(false), "has two lines WIDTH");
  expectError(header("WIDTH 32\nHEIGHT 24\nWIDTHS 1", "768", "binary") + data(false), "has a line 'WIDTHS'");
  expectError(header("WIDTH 32\nHEIGHT 24\x01", "768", "binary") + data(false), "its header is no text");
  for (const char* more : {"FIELDS x", "\nDATA", "# a comment\n \nSIZES 8"}) {  // PCL takes them for its header
    expectError(good + more + data(false), "its header goes on after its DATA");
  }
  for (const char* blanks : {" ", "\r", "\v"}) {  // PCL ends its header there, an empty line it passes over
    const std::string line = std::string(blanks) + "\n";
    expectError(line + good + data(false), "a line of blanks");
    expectError(header("WIDTH 32\n" + line + "HEIGHT 24", "768", "binary") + data(false), "is damaged");
  }
  EXPECT_TRUE(load("\n" + good + data(false)).ok());
  expectError(header("WIDTH 8192\nHEIGHT 8192", "67108864", "binary") + data(false), "is cut off");
  EXPECT_NE(loadPcd(folder_ / "missing.pcd").status.message.find("no such file"), std::string::npos);
}

TEST_F(PcdFile, CompressedDataThatContradictTheHeader) {
  const std::uint32_t sizes[2] = {100, 4000000000u};
  const std::string lie(reinterpret_cast<const char*>(sizes), 8);
  expectError(header("WIDTH 32\nHEIGHT 24", "768", "binary_compressed") + lie + std::string(100, 'x'),
              "contradicts itself");
}

TEST_F(PcdFile, GarbageNeitherThrowsNorIsAccepted) {
  std::string text = data(true);
  for (std::size_t i = 7; i < text.size(); i += 13) text[i] = '?';
  const Result<RawCloud> cloud = load(header("WIDTH 32\nHEIGHT 24", "768", "ascii") + text);
  if (cloud.ok()) {
    EXPECT_EQ(cloud.value.points.size(), 768u);
  }
  std::string missing = header("WIDTH 32\nHEIGHT 24", "768", "binary") + data(false);
  missing.replace(missing.find("x y z"), 5, "a b c");
  expectError(missing, "has no floating-point fields x, y and z");
}

TEST(SharedData, PcdAndDepthImageOfASceneAgree) {
  const std::string data = sharedData();
  if (data.empty()) GTEST_SKIP() << "no shared data: set OBJECTNESS_DATA";
  for (const std::string name : {"learn0", "test58"}) {
    const Result<PinholeCamera> camera = loadCamera(data + "/mosd/" + name + "/camera.yaml");
    ASSERT_TRUE(camera.ok()) << camera.status.message;
    const Result<Frame> cloud = loadInput(data + "/pcd/" + name + ".pcd", camera.value, InputConfig());
    const Result<Frame> image = loadInput(data + "/mosd/" + name, {}, InputConfig());
    ASSERT_TRUE(cloud.ok()) << cloud.status.message;
    ASSERT_TRUE(image.ok()) << image.status.message;
    ASSERT_EQ(cloud.value.size(), image.value.size());
    int both = 0, either = 0;
    for (int i = 0; i < image.value.size(); ++i) {
      const float a = cloud.value.points[i].z(), b = image.value.points[i].z();
      either += std::isfinite(a) || std::isfinite(b);
      if (!std::isfinite(a) || !std::isfinite(b)) continue;
      ++both;
      ASSERT_NEAR(a, b, 0.0006) << name << " pixel " << i;  // the image is rounded to millimetres
      ASSERT_LT((cloud.value.points[i] - image.value.points[i]).norm(), 0.003) << name << " pixel " << i;
    }
    EXPECT_GT(both, 0.999 * either) << name;
    EXPECT_EQ(cloud.value.color.size(), image.value.color.size());
  }
}
