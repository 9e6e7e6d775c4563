// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "fixtures/ray_cast.hpp"
#include "objectness_segmentation/scene/frame.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

const float kNan = std::numeric_limits<float>::quiet_NaN();

Frame view() {
  Scene scene;
  scene.surfaces = {slab(-0.4, -0.4, 0.4, 0.4, 0), box({-0.1, -0.1, 0}, {0.1, 0.1, 0.15})};
  return scene.render();
}

RawCloud organizedCloud() {
  const Frame frame = view();
  RawCloud cloud{frame.width(), frame.height(), frame.points, {}};
  for (int i = 0; i < frame.size(); ++i) cloud.colors.emplace_back(i % 251, i % 13, 7);
  return cloud;
}

/// The valid points only, last one first.
RawCloud listCloud() {
  const RawCloud grid = organizedCloud();
  RawCloud list;
  for (std::size_t i = grid.points.size(); i-- > 0;) {
    if (!grid.points[i].allFinite()) continue;
    list.points.push_back(grid.points[i]);
    list.colors.push_back(grid.colors[i]);
  }
  list.width = static_cast<int>(list.points.size()), list.height = 1;
  return list;
}

void expectSamePoints(const Frame& frame, const std::vector<Eigen::Vector3f>& points) {
  ASSERT_EQ(frame.points.size(), points.size());
  int different = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool both_invalid = !frame.points[i].allFinite() && !points[i].allFinite();
    if (!both_invalid && frame.points[i] != points[i]) ++different;
  }
  EXPECT_EQ(different, 0);
}

}  // namespace

TEST(Frame, FromDepthInMillimetresAndMetres) {
  cv::Mat_<ushort> millimetres(480, 640, static_cast<ushort>(1000));
  millimetres(0, 0) = 0;
  cv::Mat_<float> metres(480, 640, 1.0f);
  metres(0, 0) = kNan;
  const cv::Mat color(480, 640, CV_8UC3, cv::Scalar(1, 2, 3));
  const Result<Frame> a = makeFrame(millimetres, color, kinect(), {}), b = makeFrame(metres, color, kinect(), {});
  ASSERT_TRUE(a.ok() && b.ok()) << a.status.message << b.status.message;
  expectSamePoints(a.value, b.value.points);
  EXPECT_TRUE(std::isnan(a.value.points[0].x()) && std::isnan(a.value.points[0].y()) &&
              std::isnan(a.value.points[0].z()));
  EXPECT_NEAR(a.value.points[639].x(), 319.5 / 525, 1e-6);
  EXPECT_EQ(a.value.color(3, 3), cv::Vec3b(1, 2, 3));
}

TEST(Frame, DepthImageErrorsAreNamed) {
  const auto code = [](const cv::Mat& depth, const cv::Mat& color, const PinholeCamera& camera) {
    const Result<Frame> frame = makeFrame(depth, color, camera, {});
    EXPECT_FALSE(frame.status.message.empty());
    return frame.status.code;
  };
  const cv::Mat depth(480, 640, CV_16U, cv::Scalar(1000));
  EXPECT_EQ(code(cv::Mat(), cv::Mat(), kinect()), StatusCode::kBadInput);
  EXPECT_EQ(code(cv::Mat(480, 640, CV_8UC3), cv::Mat(), kinect()), StatusCode::kBadInput);
  EXPECT_EQ(code(depth, cv::Mat(480, 640, CV_8U), kinect()), StatusCode::kBadInput);
  EXPECT_EQ(code(depth, cv::Mat(), {}), StatusCode::kBadCamera);
  EXPECT_EQ(code(depth(cv::Rect(0, 0, 300, 240)), cv::Mat(), kinect()), StatusCode::kSizeMismatch);
  EXPECT_EQ(code(depth, cv::Mat(240, 320, CV_8UC3), kinect()), StatusCode::kSizeMismatch);
  EXPECT_EQ(code(cv::Mat::zeros(480, 640, CV_16U), cv::Mat(), kinect()), StatusCode::kNoValidPoints);
  EXPECT_EQ(code(cv::Mat(480, 640, CV_16U, cv::Scalar(9000)), cv::Mat(), kinect()), StatusCode::kNoValidPoints);
}

TEST(Frame, OnePixelIsAFrame) {
  const Result<Frame> frame = makeFrame(cv::Mat(1, 1, CV_16U, cv::Scalar(700)), cv::Mat(), {500, 500, 0, 0, 1, 1}, {});
  ASSERT_TRUE(frame.ok()) << frame.status.message;
  EXPECT_FLOAT_EQ(frame.value.points[0].z(), 0.7f);
}

TEST(Frame, OrganizedCloudKeepsItsGridWithAndWithoutCamera) {
  const RawCloud cloud = organizedCloud();
  for (const bool with_camera : {true, false}) {
    const auto frame = makeFrame(cloud, with_camera ? std::optional<PinholeCamera>(kinect()) : std::nullopt, {});
    ASSERT_TRUE(frame.ok()) << frame.status.message;
    expectSamePoints(frame.value, cloud.points);
    EXPECT_NEAR(frame.value.camera.fx, 525, 0.01);
    EXPECT_EQ(frame.value.color(200, 300), cloud.colors[200 * 640 + 300]);
  }
}

TEST(Frame, ListIsPutBackOnItsGrid) {
  const RawCloud list = listCloud(), grid = organizedCloud();
  const Result<Frame> frame = makeFrame(list, kinect(), {});
  ASSERT_TRUE(frame.ok()) << frame.status.message;
  expectSamePoints(frame.value, grid.points);
  EXPECT_EQ(frame.value.color(240, 320), grid.colors[240 * 640 + 320]);
}

TEST(Frame, NearestOfTwoPointsOfAPixelWins) {
  RawCloud list = listCloud();
  const Eigen::Vector3f near = (kinect().ray(320, 240) * 0.5).cast<float>();
  list.points.push_back(near);
  list.colors.emplace_back(9, 9, 9);
  ++list.width;
  const Result<Frame> frame = makeFrame(list, kinect(), {});
  ASSERT_TRUE(frame.ok()) << frame.status.message;
  EXPECT_EQ(frame.value.points[240 * 640 + 320], near);
  EXPECT_EQ(frame.value.color(240, 320), cv::Vec3b(9, 9, 9));
}

TEST(Frame, ListWithoutCameraSaysWhatToGive) {
  const RawCloud list = listCloud();
  const Result<Frame> frame = makeFrame(list, std::nullopt, {});
  EXPECT_EQ(frame.status.code, StatusCode::kNotOrganized);
  EXPECT_NE(frame.status.message.find(std::to_string(list.width) + " x 1, not organized"), std::string::npos);
  EXPECT_NE(frame.status.message.find("--camera"), std::string::npos);
}

TEST(Frame, ListOfAnotherCameraIsRefused) {
  PinholeCamera other = kinect();
  other.fx = 580, other.fy = 570;
  EXPECT_EQ(makeFrame(listCloud(), other, {}).status.code, StatusCode::kNotOrganized);
}

TEST(Frame, CloudErrorsAreNamed) {
  const RawCloud cloud = organizedCloud();
  RawCloud bad = cloud;
  bad.points.pop_back();
  EXPECT_EQ(makeFrame(bad, kinect(), {}).status.code, StatusCode::kSizeMismatch);
  bad = cloud, bad.colors.pop_back();
  EXPECT_EQ(makeFrame(bad, kinect(), {}).status.code, StatusCode::kSizeMismatch);
  EXPECT_EQ(makeFrame(cloud, PinholeCamera{525, 525, 160, 120, 320, 240}, {}).status.code, StatusCode::kSizeMismatch);
  EXPECT_EQ(makeFrame(cloud, PinholeCamera{1050, 1050, 319.5, 239.5, 640, 480}, {}).status.code,
            StatusCode::kBadCamera);
  EXPECT_EQ(makeFrame(cloud, PinholeCamera{}, {}).status.code, StatusCode::kBadCamera);
  EXPECT_EQ(makeFrame(RawCloud{}, kinect(), {}).status.code, StatusCode::kNoValidPoints);
  bad = cloud;
  for (Eigen::Vector3f& p : bad.points) p.setConstant(kNan);
  EXPECT_EQ(makeFrame(bad, kinect(), {}).status.code, StatusCode::kNoValidPoints);
  EXPECT_EQ(makeFrame(bad, std::nullopt, {}).status.code, StatusCode::kNoValidPoints);
  bad.height = 1, bad.width = static_cast<int>(bad.points.size());
  EXPECT_EQ(makeFrame(bad, kinect(), {}).status.code, StatusCode::kNoValidPoints);
}

TEST(Frame, ThinnedOutImagesAndCloudsTakeTheWholeCamera) {
  const Frame whole = view();
  Frame small;
  small.camera = thinned(whole.camera, 4);
  cv::Mat_<float> depth(120, 160, 0.0f);
  for (int i = 0; i < small.size(); ++i) {
    small.points.push_back(whole.points[i / 160 * 4 * 640 + i % 160 * 4]);
    if (small.points[i].allFinite()) depth(i / 160, i % 160) = small.points[i].z();
  }
  const Result<Frame> of_image = makeFrame(depth, cv::Mat(), kinect(), {});
  const Result<Frame> of_cloud = makeFrame(RawCloud{160, 120, small.points, {}}, kinect(), {});
  for (const Result<Frame>& frame : {of_image, of_cloud}) {
    ASSERT_TRUE(frame.ok()) << frame.status.message;
    ASSERT_EQ(frame.value.width(), 160);
    EXPECT_EQ(frame.value.camera.fx, small.camera.fx);
    ASSERT_EQ(frame.value.remarks.size(), 1u);
    EXPECT_NE(frame.value.remarks[0].find("one row and column in 4"), std::string::npos) << frame.value.remarks[0];
    for (int i = 0; i < small.size(); ++i) {
      if (!small.points[i].allFinite()) continue;
      ASSERT_LT((frame.value.points[i] - small.points[i]).norm(), 1e-5f) << i;
    }
  }
}

TEST(Frame, PartsOfAViewAreNotTakenForThinnedOutOnes) {
  const Frame whole = view();
  RawCloud part{320, 240, {}, {}};
  for (int i = 0; i < 320 * 240; ++i) part.points.push_back(whole.points[(i / 320 + 120) * 640 + i % 320 + 160]);
  const Result<Frame> frame = makeFrame(part, kinect(), {});
  EXPECT_EQ(frame.status.code, StatusCode::kSizeMismatch);
  EXPECT_NE(frame.status.message.find("cloud is 320 x 240 but its camera is 640 x 480"), std::string::npos)
      << frame.status.message;
}

TEST(Frame, DepthOfOtherUnits) {
  cv::Mat_<ushort> fifths(480, 640, static_cast<ushort>(4321));
  InputConfig config;
  config.depth_unit_m = 0.0002;
  EXPECT_FLOAT_EQ(makeFrame(fifths, cv::Mat(), kinect(), config).value.points[0].z(), 0.8642f);
  ImageCamera camera = kinect();
  camera.depth_unit_m = 0.0001;
  EXPECT_FLOAT_EQ(makeFrame(fifths, cv::Mat(), camera, {}).value.points[0].z(), 0.4321f);
  EXPECT_FLOAT_EQ(makeFrame(fifths, cv::Mat(), camera, config).value.points[0].z(), 0.8642f)
      << "the configuration goes first";
  const cv::Mat_<float> metres(480, 640, 1.5f);
  EXPECT_FLOAT_EQ(makeFrame(metres, cv::Mat(), camera, config).value.points[0].z(), 1.5f);
}

namespace {

const Eigen::Isometry3d kPose = lookAt({0.4, -0.8, 1.3}, {0, 0, 0});

RawCloud movedCloud(const Eigen::Isometry3d& T_world_camera) {
  RawCloud cloud = organizedCloud();
  cloud.colors.clear();
  for (Eigen::Vector3f& p : cloud.points) p = (T_world_camera * p.cast<double>()).cast<float>();
  return cloud;
}

}  // namespace

TEST(Frame, CloudsInOtherFramesAreNamedWithAndWithoutCamera) {
  Eigen::Isometry3d body = Eigen::Isometry3d::Identity(), open_gl = Eigen::Isometry3d::Identity();
  body.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  open_gl.linear() << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  const struct {
    Eigen::Isometry3d pose;
    std::string text;
  } cases[] = {{body, "x axis points forward"}, {open_gl, "z axis points backward"}, {kPose, "turned or moved"}};
  for (const auto& c : cases) {
    for (const bool with_camera : {true, false}) {
      RawCloud cloud = movedCloud(c.pose);
      cloud.frame_id = "base_link";
      const Status status =
          makeFrame(cloud, with_camera ? std::optional<PinholeCamera>(kinect()) : std::nullopt, {}).status;
      EXPECT_EQ(status.code, StatusCode::kBadCamera) << c.text;
      EXPECT_NE(status.message.find("'base_link' is not the camera's optical frame"), std::string::npos)
          << status.message;
      EXPECT_NE(status.message.find(c.text), std::string::npos) << status.message;
      for (const char* circle : {"leave the camera out", "give the camera"}) {
        EXPECT_EQ(status.message.find(circle), std::string::npos) << status.message;
      }
    }
  }
}

TEST(Frame, CloudsAreSeenFromTheirViewpointWhereThatMakesThemAView) {
  RawCloud cloud = movedCloud(kPose), list = listCloud();
  for (Eigen::Vector3f& p : list.points) p = (kPose * p.cast<double>()).cast<float>();
  cloud.T_cloud_sensor = list.T_cloud_sensor = kPose;
  const RawCloud original = organizedCloud();
  for (const Result<Frame>& frame :
       {makeFrame(cloud, kinect(), {}), makeFrame(cloud, std::nullopt, {}), makeFrame(list, kinect(), {})}) {
    ASSERT_TRUE(frame.ok()) << frame.status.message;
    ASSERT_EQ(frame.value.remarks.size(), 1u);
    EXPECT_NE(frame.value.remarks[0].find("VIEWPOINT"), std::string::npos);
    for (int i = 0; i < frame.value.size(); ++i) {
      ASSERT_EQ(frame.value.points[i].allFinite(), original.points[i].allFinite()) << i;
      if (!original.points[i].allFinite()) continue;
      ASSERT_LT((frame.value.points[i] - original.points[i]).norm(), 1e-5f) << i;
    }
  }
}

TEST(Frame, ViewpointsOfCloudsThatAreViewsAlreadyAreLeftAlone) {
  RawCloud cloud = organizedCloud();
  cloud.T_cloud_sensor = kPose;
  const Result<Frame> frame = makeFrame(cloud, kinect(), {});
  ASSERT_TRUE(frame.ok());
  EXPECT_TRUE(frame.value.remarks.empty());
  expectSamePoints(frame.value, cloud.points);
  cloud = movedCloud(lookAt({0.1, -0.5, 0.5}, {0, 0, 0}));
  cloud.T_cloud_sensor = kPose;
  const Status status = makeFrame(cloud, kinect(), {}).status;
  EXPECT_EQ(status.code, StatusCode::kBadCamera);
  EXPECT_NE(status.message.find("VIEWPOINT"), std::string::npos) << status.message;
}

TEST(Frame, DepthRangeIsInclusive) {
  InputConfig config;
  config.min_depth_m = 0.5, config.max_depth_m = 1.0;
  cv::Mat_<float> depth(480, 640, 2.0f);
  depth(0, 0) = 0.5f, depth(0, 1) = 1.0f, depth(0, 2) = 0.4f;
  const Result<Frame> frame = makeFrame(depth, cv::Mat(), kinect(), config);
  ASSERT_TRUE(frame.ok());
  EXPECT_TRUE(frame.value.points[0].allFinite());
  EXPECT_TRUE(frame.value.points[1].allFinite());
  EXPECT_FALSE(frame.value.points[2].allFinite());
  EXPECT_FALSE(frame.value.points[3].allFinite());
}
