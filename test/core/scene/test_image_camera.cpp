// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/calib3d.hpp>

#include "objectness_segmentation/scene/frame.hpp"
#include "objectness_segmentation/scene/image_camera.hpp"

using namespace objectness;

namespace {

CameraCalibration calibration(const std::vector<double>& distortion, bool with_p) {
  CameraCalibration c;
  c.width = 640, c.height = 480;
  c.distortion_model = "plumb_bob";
  c.D = distortion;
  c.K = {525, 0, 319.5, 0, 525, 239.5, 0, 0, 1};
  if (with_p) c.P = {525, 0, 319.5, 0, 0, 525, 239.5, 0, 0, 0, 1, 0};
  return c;
}

const std::vector<double> kWide{-0.25, 0.08, 0.001, -0.001, 0};

/// What a camera with a lens sees of the plane z = 1 + 0.4 x, metres, beyond x = 0.1 of one that is 0.2 m nearer.
cv::Mat_<float> rawView(const CameraCalibration& c) {
  std::vector<cv::Point2d> pixels, rays;
  for (int v = 0; v < 480; ++v) {
    for (int u = 0; u < 640; ++u) pixels.emplace_back(u, v);
  }
  const cv::Matx33d k(c.K.data());
  if (c.distortion_model == "equidistant") {
    cv::fisheye::undistortPoints(pixels, rays, k, c.D);
  } else {
    cv::undistortPoints(pixels, rays, k, c.D, cv::noArray(), cv::noArray(),
                        cv::TermCriteria(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 100, 1e-12));
  }
  cv::Mat_<float> depth(480, 640);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const double far = 1 / (1 - 0.4 * rays[i].x), near = 0.8 / (1 - 0.4 * rays[i].x);
    depth(static_cast<int>(i / 640), static_cast<int>(i % 640)) =
        static_cast<float>(near * rays[i].x > 0.1 ? near : far);
  }
  return depth;
}

/// The largest distance of points from the two planes.
double largestError(const Frame& frame) {
  double largest = 0;
  for (const Eigen::Vector3f& p : frame.points) {
    if (!p.allFinite()) continue;
    const double far = 1 + 0.4 * p.x(), near = 0.8 + 0.4 * p.x();
    largest = std::max(largest, std::min(std::abs(p.z() - far), std::abs(p.z() - near)));
  }
  return largest;
}

}  // namespace

TEST(ImageCamera, WithoutDistortionIsAPinholeCamera) {
  for (const bool with_p : {true, false}) {
    const auto camera = imageCamera(calibration({0, 0, 0, 0, 0}, with_p));
    ASSERT_TRUE(camera.ok()) << camera.status.message;
    EXPECT_EQ(camera.value.pinhole.fx, 525);
    EXPECT_FALSE(camera.value.lens);
    EXPECT_TRUE(camera.value.remarks.empty());
  }
}

TEST(ImageCamera, IsRawForCertainOnlyWithoutP) {
  const auto raw = imageCamera(calibration(kWide, false));
  ASSERT_TRUE(raw.ok()) << raw.status.message;
  EXPECT_TRUE(raw.value.lens.has_value());
  const auto unclear = imageCamera(calibration(kWide, true));
  ASSERT_TRUE(unclear.ok());
  EXPECT_FALSE(unclear.value.lens);
  ASSERT_EQ(unclear.value.remarks.size(), 1u);
  EXPECT_NE(unclear.value.remarks[0].find("lens distortion"), std::string::npos) << unclear.value.remarks[0];
  CameraCalibration rectified = calibration(kWide, true);
  rectified.P[0] = 480;
  EXPECT_TRUE(imageCamera(rectified).value.remarks.empty()) << "P of its own describes rectified images";
}

TEST(ImageCamera, DistortionOfLessThanAPixelIsNoRemark) {
  EXPECT_TRUE(imageCamera(calibration({0.002, 0, 0, 0, 0}, true)).value.remarks.empty());
  const auto camera = imageCamera(calibration({0.02, 0, 0, 0, 0}, true));
  ASSERT_EQ(camera.value.remarks.size(), 1u);
  // 0.02 r^3 f in the corner
  EXPECT_NE(camera.value.remarks[0].find("up to 4.6 px"), std::string::npos) << camera.value.remarks[0];
}

TEST(ImageCamera, UnknownModelsAreRefusedWhereTheyMatter) {
  for (const bool with_p : {false, true}) {
    for (CameraCalibration c : {calibration({0.1, 0.2, 0.3}, with_p), calibration({0.1, 0, 0, 0, NAN}, with_p)}) {
      EXPECT_EQ(imageCamera(c).ok(), with_p);
    }
    CameraCalibration c = calibration({0.1, 0, 0, 0, 0}, with_p);
    c.distortion_model = "three_mirrors";
    const auto camera = imageCamera(c);
    EXPECT_EQ(camera.ok(), with_p);
    if (!with_p) {
      EXPECT_EQ(camera.status.code, StatusCode::kBadCamera);
      EXPECT_NE(camera.status.message.find("three_mirrors"), std::string::npos) << camera.status.message;
    }
  }
}

TEST(ImageCamera, RegionOfInterestAndBinningMoveRawCamerasToo) {
  CameraCalibration c = calibration(kWide, false);
  c.roi = {100, 60, 320, 240};
  c.binning_x = c.binning_y = 2;
  const auto camera = imageCamera(c);
  ASSERT_TRUE(camera.ok());
  EXPECT_DOUBLE_EQ(camera.value.pinhole.fx, 262.5);
  EXPECT_DOUBLE_EQ(camera.value.pinhole.cx, (319.5 - 100) / 2);
  EXPECT_EQ(camera.value.pinhole.width, 160);
  EXPECT_EQ(camera.value.pinhole.height, 120);
  EXPECT_TRUE(camera.value.lens.has_value());
}

TEST(ImageCamera, RawDepthIsRectified) {
  CameraCalibration fisheye = calibration({0.05, -0.01, 0.002, 0}, false);
  fisheye.distortion_model = "equidistant";
  CameraCalibration rational = calibration({0.5, 0.1, 0.001, -0.001, 0.02, 0.8, 0.3, 0.05}, false);
  rational.distortion_model = "rational_polynomial";
  for (const CameraCalibration& c : {calibration(kWide, false), rational, fisheye}) {
    const cv::Mat_<float> raw = rawView(c);
    const auto camera = imageCamera(c);
    ASSERT_TRUE(camera.ok()) << camera.status.message;
    const auto frame = makeFrame(raw, cv::Mat(480, 640, CV_8UC3, cv::Scalar(7, 8, 9)), camera.value, {});
    ASSERT_TRUE(frame.ok()) << frame.status.message;
    EXPECT_TRUE(frame.value.rectified);
    // Half a pixel along the slope beside the edge, where nothing is interpolated.
    EXPECT_LT(largestError(frame.value), 0.0006) << c.distortion_model;
    EXPECT_EQ(frame.value.color(240, 320), cv::Vec3b(7, 8, 9));
    ASSERT_EQ(frame.value.remarks.size(), 1u);
    EXPECT_NE(frame.value.remarks[0].find("rectified"), std::string::npos);
    const auto taken_as_it_is = makeFrame(raw, cv::Mat(), camera.value.pinhole, {});
    EXPECT_GT(largestError(taken_as_it_is.value), 0.01) << c.distortion_model << " would not matter";
  }
}

TEST(ImageCamera, NothingIsMadeUpWhereTheLensModelTurnsBack) {
  // r - 0.3 r^3 has its largest value at r = 1.05: pixels beyond would show the image a second time.
  CameraCalibration c = calibration({-0.3, 0, 0, 0, 0}, false);
  c.K = {200, 0, 319.5, 0, 200, 239.5, 0, 0, 1};
  const auto camera = imageCamera(c);
  ASSERT_TRUE(camera.ok());
  const auto frame = makeFrame(cv::Mat_<float>(480, 640, 1.0F), cv::Mat(), camera.value, {});
  ASSERT_TRUE(frame.ok());
  for (int i = 0; i < frame.value.size(); ++i) {
    const Eigen::Vector3f& p = frame.value.points[i];
    if (!p.allFinite()) continue;
    ASSERT_LT(p.head<2>().norm(), 1.06F);
  }
  EXPECT_TRUE(std::isnan(frame.value.points[0].z()));
}

TEST(ImageCamera, HolesStayHoles) {
  const CameraCalibration c = calibration(kWide, false);
  cv::Mat_<float> raw(480, 640, 1.0F);
  raw(cv::Rect(0, 0, 320, 480)).setTo(0);
  raw(240, 400) = std::nanf("");
  const auto frame = makeFrame(raw, cv::Mat(), imageCamera(c).value, {});
  ASSERT_TRUE(frame.ok());
  for (const int u : {10, 200, 317}) EXPECT_TRUE(std::isnan(frame.value.points[240 * 640 + u].z())) << u;
  EXPECT_FLOAT_EQ(frame.value.points[240 * 640 + 325].z(), 1);
}

TEST(CameraOfSize, WholeMultiplesAreThinnedOut) {
  const PinholeCamera camera{525, 524, 319.5, 239.5, 640, 480};
  std::vector<std::string> remarks;
  const auto same = cameraOfSize(camera, 640, 480, "depth image", remarks);
  ASSERT_TRUE(same.ok());
  EXPECT_EQ(same.value.cx, 319.5);
  EXPECT_TRUE(remarks.empty());
  const auto quarter = cameraOfSize(camera, 160, 120, "depth image", remarks);
  ASSERT_TRUE(quarter.ok()) << quarter.status.message;
  EXPECT_DOUBLE_EQ(quarter.value.fx, 131.25);
  EXPECT_DOUBLE_EQ(quarter.value.cy, 239.5 / 4);
  EXPECT_EQ(quarter.value.width, 160);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_NE(remarks[0].find("depth image is 160 x 120 but its camera is 640 x 480: taken as one row and column in 4"),
            std::string::npos)
      << remarks[0];
  const auto third = cameraOfSize({900, 900, 424, 240, 848, 480}, 282, 160, "depth image", remarks);
  ASSERT_TRUE(third.ok()) << "a last column may be missing";
  EXPECT_EQ(third.value.width, 282);
}

TEST(CameraOfSize, OtherSizesSayWhatHelps) {
  const PinholeCamera camera{525, 525, 319.5, 239.5, 640, 480};
  std::vector<std::string> remarks;
  for (const auto& [width, height] : {std::pair(300, 240), {320, 120}, {640, 240}, {1280, 960}, {640, 479}, {0, 0}}) {
    const auto sized = cameraOfSize(camera, width, height, "depth image", remarks);
    EXPECT_EQ(sized.status.code, StatusCode::kSizeMismatch) << width << " x " << height;
    EXPECT_NE(sized.status.message.find("binning"), std::string::npos) << sized.status.message;
  }
  EXPECT_TRUE(remarks.empty());
}
