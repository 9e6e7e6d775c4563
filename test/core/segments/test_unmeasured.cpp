// SPDX-License-Identifier: BSD-3-Clause
// TableClusters that a simulated sensor cannot measure: which of the holes they leave are reported, and where.
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "fixtures/small_scene.hpp"
#include "fixtures/table_scene.hpp"
#include "objectness_segmentation/pipeline.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

const Eigen::Vector3f kNoPoint = Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
constexpr int kFirstThing = 2;  // of the surfaces of tableWith()

/// A table with things, of which those from the first on have no depth.
struct View {
  Scene scene;
  Frame frame;
  cv::Mat_<uchar> hole;  ///< 255 = sees a thing without depth

  explicit View(std::vector<Surface> without_depth, std::vector<Surface> measured = {}) {
    const std::size_t count = without_depth.size();
    without_depth.insert(without_depth.end(), measured.begin(), measured.end());
    scene = tableWith(without_depth);
    frame = scene.render();
    hole = cv::Mat_<uchar>(frame.height(), frame.width(), uchar(0));
    for (int i = 0; i < frame.size(); ++i) {
      const int thing = scene.seen[i] - kFirstThing;
      if (thing >= 0 && thing < static_cast<int>(count)) hole(i / frame.width(), i % frame.width()) = 255;
    }
    blind(hole);
  }

  void blind(const cv::Mat_<uchar>& pixels) {
    for (int i = 0; i < frame.size(); ++i) {
      if (pixels(i / frame.width(), i % frame.width())) frame.points[i] = kNoPoint;
    }
  }
  void blindCircle(const cv::Point& centre, int radius) {
    cv::Mat_<uchar> pixels(frame.height(), frame.width(), uchar(0));
    cv::circle(pixels, centre, radius, cv::Scalar(255), cv::FILLED);
    blind(pixels);
  }
  /// Small holes as a sensor leaves them.
  void addNoise(int count, int largest_px) {
    std::mt19937 random(3);
    for (int k = 0; k < count; ++k) {
      const cv::Point at(static_cast<int>(40 + random() % 560u), static_cast<int>(150 + random() % 300u));
      blindCircle(at, static_cast<int>(random() % static_cast<unsigned>(largest_px + 1)));
    }
  }
  std::vector<Unmeasured> found(const Config& config = {}) const {
    const Segmentation result = segment(frame, config);
    EXPECT_TRUE(result.status.ok()) << result.status.message;
    return result.unmeasured;
  }
};

const Surface kBlock = box({-0.04, -0.04, 0}, {0.04, 0.04, 0.13});

std::vector<cv::Point> inPicture(const Frame& frame, const std::vector<Eigen::Vector3d>& outline) {
  std::vector<cv::Point> pixels;
  for (const Eigen::Vector3d& corner : outline) {
    const Eigen::Vector2d pixel = frame.camera.project(corner);
    pixels.emplace_back(static_cast<int>(std::lround(pixel.x())), static_cast<int>(std::lround(pixel.y())));
  }
  return pixels;
}

/// Share of what either holds that both hold.
double overlap(const cv::Mat_<uchar>& a, const cv::Mat_<uchar>& b) {
  return cv::countNonZero(a & b) / static_cast<double>(cv::countNonZero(a | b));
}

/// Of the table behind the pixels, by the corners of each.
double areaBehind(const cv::Mat_<uchar>& pixels, const Frame& frame, const Table& table) {
  const auto place = [&](double u, double v) {
    const Eigen::Vector3d ray = frame.camera.ray(u, v);
    return Eigen::Vector3d(ray * (-table.d / table.normal.dot(ray)));
  };
  double area = 0;
  for (int v = 0; v < pixels.rows; ++v) {
    for (int u = 0; u < pixels.cols; ++u) {
      if (!pixels(v, u)) continue;
      const Eigen::Vector3d a = place(u - 0.5, v - 0.5), b = place(u + 0.5, v - 0.5), c = place(u + 0.5, v + 0.5),
                            d = place(u - 0.5, v + 0.5);
      area += 0.5 * ((b - a).cross(c - a).norm() + (c - a).cross(d - a).norm());
    }
  }
  return area;
}

void expectSame(const std::vector<Unmeasured>& a, const std::vector<Unmeasured>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].outline, b[k].outline);
    EXPECT_EQ(a[k].pixels, b[k].pixels);
    EXPECT_EQ(a[k].area_m2, b[k].area_m2);
    EXPECT_EQ(a[k].table_share, b[k].table_share);
    EXPECT_EQ(a[k].noise_ratio, b[k].noise_ratio);
    ASSERT_EQ(a[k].box.has_value(), b[k].box.has_value());
    if (!a[k].box) continue;
    EXPECT_EQ(a[k].box->T_camera_box.matrix(), b[k].box->T_camera_box.matrix());
    EXPECT_EQ(a[k].box->size_m, b[k].box->size_m);
  }
}

}  // namespace

TEST(Unmeasured, ABlockWithoutDepthHasItsOutlineAndIsNoSegment) {
  View view({kBlock});
  view.addNoise(60, 2);
  const Segmentation result = segment(view.frame, {});
  ASSERT_TRUE(result.status.ok()) << result.status.message;
  EXPECT_TRUE(result.segments.empty());
  ASSERT_EQ(result.unmeasured.size(), 1u);
  const Unmeasured& thing = result.unmeasured[0];
  cv::Mat_<uchar> painted(view.hole.size(), uchar(0));
  cv::fillPoly(painted, std::vector<std::vector<cv::Point>>{inPicture(view.frame, thing.outline)}, cv::Scalar(255));
  EXPECT_GT(overlap(painted, view.hole), 0.95);
  EXPECT_NEAR(thing.pixels, cv::countNonZero(view.hole), 0.04 * thing.pixels);
  EXPECT_NEAR(thing.area_m2, areaBehind(view.hole, view.frame, result.table), 0.05 * thing.area_m2);
  EXPECT_GT(thing.table_share, 0.9);
  EXPECT_GT(thing.noise_ratio, 5);
  EXPECT_EQ(cv::countNonZero((result.labels != 0) & view.hole), 0);
  double turns = 0;
  for (std::size_t k = 0; k < thing.outline.size(); ++k) {
    const Eigen::Vector3d &p = thing.outline[k], &q = thing.outline[(k + 1) % thing.outline.size()];
    EXPECT_NEAR(result.table.height(p.cast<float>()), 0, 1e-6);
    turns += result.table.normal.dot(p.cross(q));
  }
  EXPECT_GT(turns, 0);
}

// A block that is as deep as it is wide, square to the camera.
TEST(Unmeasured, TheBoxIsThatOfTheThing) {
  const auto found = View({kBlock}).found();
  ASSERT_EQ(found.size(), 1u);
  ASSERT_TRUE(found[0].box);
  const Eigen::Isometry3d T_world_box = Scene().T_world_camera * found[0].box->T_camera_box;
  EXPECT_NEAR(found[0].box->size_m.z(), 0.13, 0.008);
  EXPECT_NEAR(found[0].box->size_m.x(), 0.08, 0.006);
  EXPECT_NEAR(found[0].box->size_m.y(), 0.08, 0.006);
  EXPECT_LT((T_world_box.translation() - Eigen::Vector3d(0, 0, 0.065)).norm(), 0.01);
  EXPECT_NEAR(T_world_box.linear()(2, 2), 1, 1e-3);
  EXPECT_NEAR(T_world_box.linear()(1, 0), 1, 1e-2);
}

TEST(Unmeasured, WhatLiesFlatOrIsRoundAboveHasNoBox) {
  const auto ball = View({sphere({0.2, 0.1, 0.04}, 0.04)}).found();
  ASSERT_EQ(ball.size(), 1u);
  EXPECT_FALSE(ball[0].box);

  const auto found = View({box({-0.05, -0.05, 0}, {0.05, 0.05, 0.002})}).found();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_FALSE(found[0].box);
  EXPECT_NEAR(found[0].area_m2, 0.01, 0.0008);
}

TEST(Unmeasured, NoiseIsNone) {
  View view({});
  view.addNoise(300, 6);
  EXPECT_TRUE(view.found().empty());
  // The same holes would be things where there are no others.
  View quiet({});
  Config config;
  config.unmeasured.min_width_m = 0.015;
  quiet.blindCircle({320, 300}, 6);
  EXPECT_EQ(quiet.found(config).size(), 1u);
  view.blindCircle({320, 300}, 6);
  EXPECT_TRUE(view.found(config).empty());
}

TEST(Unmeasured, SlitsAndRaggedHolesAreNone) {
  View view({box({-0.2, -0.005, 0}, {0.2, 0.005, 0.005})});
  EXPECT_TRUE(view.found().empty());
  View cross({box({-0.15, -0.02, 0}, {0.15, 0.02, 0.002}), box({-0.02, -0.15, 0}, {0.02, 0.15, 0.002})});
  EXPECT_TRUE(cross.found().empty());
}

TEST(Unmeasured, WhatThePictureCutsIsNone) {
  View view({});
  view.blindCircle({320, 470}, 30);
  EXPECT_TRUE(view.found().empty());
  view.blindCircle({320, 430}, 15);
  EXPECT_TRUE(view.found().empty());
}

TEST(Unmeasured, HolesInAnObjectAreItsOwn) {
  View view({}, {box({-0.15, -0.1, 0}, {0.15, 0.1, 0.1})});
  const Eigen::Vector2d top =
      view.scene.camera.project(view.scene.T_world_camera.inverse() * Eigen::Vector3d(0, 0, 0.1));
  view.blindCircle({static_cast<int>(top.x()), static_cast<int>(top.y())}, 20);
  const Segmentation result = segment(view.frame, {});
  EXPECT_EQ(result.segments.size(), 1u);
  EXPECT_TRUE(result.unmeasured.empty());
}

TEST(Unmeasured, TheRestOfAKnownThingIsNone) {
  // All of its front but a strip at the top: its box reaches down to the table.
  const Surface known = box({-0.06, -0.06, 0}, {0.06, 0.06, 0.15});
  View view({}, {known});
  cv::Mat_<uchar> front(view.hole.size(), uchar(0));
  for (int i = 0; i < view.frame.size(); ++i) {
    const Eigen::Vector3d p = view.scene.T_world_camera * view.frame.points[i].cast<double>();
    if (view.scene.seen[i] == kFirstThing && p.z() < 0.13) front(i / view.frame.width(), i % view.frame.width()) = 255;
  }
  ASSERT_GT(cv::countNonZero(front), 3000);
  view.blind(front);
  const Segmentation result = segment(view.frame, {});
  ASSERT_EQ(result.segments.size(), 1u);
  EXPECT_TRUE(result.unmeasured.empty());
}

TEST(Unmeasured, BesideTheTableIsNone) {
  View view({box({-0.25, 1.9, -0.7}, {0.25, 2.3, -0.4})});
  ASSERT_GT(cv::countNonZero(view.hole), 1000);
  EXPECT_TRUE(view.found().empty());
}

// The projector stands beside the camera: tall boxes have wide strips without depth beside them.
TEST(Unmeasured, ShadowsOfASimulatedSensorAreNone) {
  for (const std::uint32_t seed : {1u, 2u, 3u}) {
    const SceneImages images = sim::takePicture(smallScene().bodies, smallScene().T_world_camera, smallSensor(), seed);
    const Result<Frame> frame = makeFrame(images.depth_mm, images.color, images.camera, {});
    ASSERT_TRUE(frame.ok());
    const Segmentation result = segment(frame.value, {});
    ASSERT_TRUE(result.status.ok()) << result.status.message;
    EXPECT_EQ(result.segments.size(), 2u);
    EXPECT_TRUE(result.unmeasured.empty());
  }
}

TEST(Unmeasured, DoesNotDependOnThreadsAndCanBeSwitchedOff) {
  View view({kBlock, sphere({0.2, 0.1, 0.04}, 0.04)});
  view.addNoise(100, 3);
  Config config;
  config.runtime.threads = 1;
  const std::vector<Unmeasured> one = view.found(config);
  EXPECT_EQ(one.size(), 2u);
  config.runtime.threads = 4;
  expectSame(view.found(config), one);
  config.unmeasured.report = false;
  const Segmentation off = segment(view.frame, config);
  EXPECT_TRUE(off.unmeasured.empty());
  EXPECT_FALSE(off.report.unmeasured);
}

TEST(Unmeasured, PixelsAreThoseOfAFinePicture) {
  View usual({kBlock});
  Scene scene = usual.scene;
  scene.camera = {1050, 1050, 639.5, 479.5, 1280, 960};
  View fine({kBlock});
  fine.scene = scene;
  fine.frame = fine.scene.render();
  fine.hole = cv::Mat_<uchar>(960, 1280, uchar(0));
  for (int i = 0; i < fine.frame.size(); ++i) {
    if (fine.scene.seen[i] == kFirstThing) fine.hole(i / 1280, i % 1280) = 255;
  }
  fine.blind(fine.hole);
  Config config;
  config.resolution.finest_pixel_m = 0.002;
  const auto found = fine.found(config);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].pixels, cv::countNonZero(fine.hole), 0.06 * found[0].pixels);
}
