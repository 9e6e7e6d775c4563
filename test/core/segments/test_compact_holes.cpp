// SPDX-License-Identifier: BSD-3-Clause
// What circles cover in holes of a picture, and what explains a hole, beside pixel by pixel counting.
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>
#include <random>

#include "fixtures/ray_cast.hpp"
#include "segments/compact_holes.hpp"
#include "segments/hole_box.hpp"
#include "segments/hole_explanations.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

const PinholeCamera kCamera{262.5, 262.5, 79.5, 59.5, 160, 120};

/// A table that fills the picture, one metre straight ahead.
Plane tableAhead() {
  Plane plane;
  plane.normal = -Eigen::Vector3d::UnitZ();
  plane.d = 1;
  return plane;
}

/// Distance to the nearest pixel outside, by looking at all; infinite without any.
cv::Mat_<float> plainDistance(const cv::Mat_<uchar>& mask) {
  cv::Mat_<float> distance(mask.size(), std::numeric_limits<float>::infinity());
  for (int v = 0; v < mask.rows; ++v) {
    for (int u = 0; u < mask.cols; ++u) {
      if (!mask(v, u)) distance(v, u) = 0;
      for (int y = 0; mask(v, u) && y < mask.rows; ++y) {
        for (int x = 0; x < mask.cols; ++x) {
          if (!mask(y, x)) distance(v, u) = std::min(distance(v, u), std::hypot(float(x - u), float(y - v)));
        }
      }
    }
  }
  return distance;
}

cv::Mat_<uchar> blobs(int count, unsigned seed) {
  std::mt19937 random(seed);
  cv::Mat_<uchar> mask(60, 80, uchar(0));
  for (int k = 0; k < count; ++k) {
    const cv::Point at(static_cast<int>(random() % 80u), static_cast<int>(random() % 60u));
    cv::ellipse(mask, at, {static_cast<int>(1 + random() % 14u), static_cast<int>(1 + random() % 9u)},
                static_cast<double>(random() % 180u), 0, 360, cv::Scalar(255), cv::FILLED);
  }
  return mask;
}

CompactHole holeOf(const cv::Rect& place) {
  CompactHole hole;
  hole.area = {place.x - 1, place.y - 1, place.width + 2, place.height + 2};
  hole.mask = cv::Mat_<uchar>(hole.area.size(), uchar(0));
  hole.mask(cv::Rect(1, 1, place.width, place.height)).setTo(255);
  hole.pixels = place.area();
  hole.radius_px = static_cast<float>(0.5 * std::min(place.width, place.height));
  return hole;
}

/// Everything at one depth but what is left of `edge`, which is nearer; nothing in the hole.
Frame stepAt(int edge, float near_m, float far_m, const cv::Rect& hole) {
  Frame frame;
  frame.camera = kCamera;
  for (int i = 0; i < frame.size(); ++i) {
    const int u = i % kCamera.width, v = i / kCamera.width;
    const float z = hole.contains({u, v}) ? std::nanf("") : u < edge ? near_m : far_m;
    frame.points.push_back(kCamera.ray(u, v).cast<float>() * z);
  }
  return frame;
}

}  // namespace

TEST(CompactHoles, AreWhatCirclesCover) {
  const cv::Mat_<uchar> all_table(60, 80, uchar(255));
  PinholeCamera camera = kCamera;
  camera.width = 80, camera.height = 60, camera.cx = 39.5, camera.cy = 29.5;
  UnmeasuredConfig config;
  config.noise_factor = 1;
  config.min_width_m = 0.04;  // 5.25 pixels in radius
  constexpr double kLeast = 0.5 * 0.04 * 262.5;
  int found = 0;
  for (unsigned seed = 0; seed < 12; ++seed) {
    const cv::Mat_<uchar> mask = blobs(5, seed);
    const std::vector<CompactHole> holes = compactHoles(camera, tableAhead(), mask, all_table, config);
    cv::Mat_<uchar> united(mask.size(), uchar(0));
    for (const CompactHole& hole : holes) {
      ++found;
      EXPECT_EQ(hole.pixels, cv::countNonZero(hole.mask));
      united(hole.area).setTo(255, hole.mask);
    }
    // Plainly: holes within the picture, of each what circles of half the wanted radius cover, and of that the
    // connected parts that hold a whole one.
    cv::Mat_<int> labels, cores;
    const int count = cv::connectedComponents(mask, labels, 4);
    cv::Mat_<uchar> expected(mask.size(), uchar(0));
    for (int k = 1; k < count; ++k) {
      const cv::Mat_<uchar> part = labels == k;
      const cv::Rect box = cv::boundingRect(part);
      if (box.x == 0 || box.y == 0 || box.br().x == 80 || box.br().y == 60) continue;
      const cv::Mat_<float> distance = plainDistance(part);
      double noise = 0;
      for (const CompactHole& hole : holes) noise = hole.noise_radius_px;
      const double opening = std::max(noise + 1, 0.5 * std::max(kLeast, noise));
      const cv::Mat_<uchar> opened = (plainDistance(distance < opening) < opening) & part;
      const int core_count = cv::connectedComponents(opened, cores, 4);
      for (int core = 1; core < core_count; ++core) {
        double radius = 0;
        cv::minMaxLoc(distance, nullptr, &radius, nullptr, nullptr, cores == core);
        if (radius >= std::max(kLeast, noise)) expected.setTo(255, cores == core);
      }
    }
    if (!holes.empty()) {
      // Distances in the picture are good to 2 %.
      EXPECT_LE(cv::countNonZero(united != expected), 0.03 * cv::countNonZero(expected)) << seed;
    }
  }
  EXPECT_GT(found, 3);
}

TEST(CompactHoles, NoiseIsLearnedFromHolesInTheTableAlone) {
  cv::Mat_<uchar> no_depth(120, 160, uchar(0)), on_table(120, 160, uchar(0));
  on_table(cv::Rect(0, 0, 160, 70)).setTo(255);
  cv::circle(no_depth, {80, 40}, 12, cv::Scalar(255), cv::FILLED);
  for (int k = 0; k < 12; ++k) cv::circle(no_depth, {6 + 13 * k, 95}, 5, cv::Scalar(255), cv::FILLED);
  UnmeasuredConfig config;
  const auto off_table = compactHoles(kCamera, tableAhead(), no_depth, on_table, config);
  ASSERT_EQ(off_table.size(), 1u);
  EXPECT_EQ(off_table[0].noise_radius_px, 1);
  on_table.setTo(255);
  EXPECT_TRUE(compactHoles(kCamera, tableAhead(), no_depth, on_table, config).empty());
}

TEST(HoleExplanations, AShadowIsNoWiderThanItsStepAllows) {
  // 26.25 pixels times the step in inverse depth, 1, and 3 more.
  for (const int width : {10, 25, 29, 30, 40}) {
    const cv::Rect place(60, 30, width, 50);
    EXPECT_EQ(isShadow(holeOf(place), stepAt(60, 0.5f, 1, place)), width <= 29) << width;
    EXPECT_FALSE(isShadow(holeOf(place), stepAt(60, 1, 1, place))) << width;
  }
  // Turned by a quarter.
  for (const int height : {10, 25, 35}) {
    const cv::Rect place(30, 50, 60, height);
    Frame frame = stepAt(0, 1, 1, place);
    for (int i = 0; i < 50 * kCamera.width; ++i) frame.points[i] *= 0.5f;
    EXPECT_EQ(isShadow(holeOf(place), frame), height < 30) << height;
  }
}

TEST(HoleExplanations, TableAroundIsCounted) {
  std::mt19937 random(5);
  for (int round = 0; round < 20; ++round) {
    const cv::Rect place(static_cast<int>(5 + random() % 80u), static_cast<int>(5 + random() % 60u),
                         static_cast<int>(8 + random() % 30u), static_cast<int>(8 + random() % 30u));
    const CompactHole hole = holeOf(place);
    cv::Mat_<ushort> labels(120, 160);
    cv::Mat_<float> height_m(120, 160);
    for (ushort& label : labels) label = static_cast<ushort>(random() % 8u < 5 ? 1 : random() % 3u);
    for (float& height : height_m) height = static_cast<float>(random() % 3u) - 1;
    const int reach = std::max(3, static_cast<int>(0.5 * hole.radius_px));
    int all = 0, table = 0, own = 0;
    for (int v = -20; v < 140; ++v) {
      for (int u = -20; u < 180; ++u) {
        const int x = std::clamp(u, place.x, place.br().x - 1), y = std::clamp(v, place.y, place.br().y - 1);
        const double distance = std::hypot(u - x, v - y);
        if (distance == 0 || distance > reach) continue;
        ++all;
        if (u < 0 || v < 0 || u >= 160 || v >= 120) continue;
        table += labels(v, u) == 1;
        own += labels(v, u) == 0 && height_m(v, u) > 0;
      }
    }
    EXPECT_NEAR(tableAround(hole, labels, height_m), table / double(all - own), 0.02);
  }
  EXPECT_TRUE(std::isnan(
      tableAround(holeOf({40, 40, 20, 20}), cv::Mat_<ushort>(120, 160, ushort{0}), cv::Mat_<float>(120, 160, 0.1f))));
}

TEST(HoleExplanations, KnownThingsHoldWhatTheirBoxesHide) {
  Segment segment;
  segment.box.T_camera_box.translation() = Eigen::Vector3d(0, 0, 1);
  segment.box.size_m = {0.1, 0.1, 0.1};  // its front: 27.6 pixels wide
  const KnownThings known(kCamera, {segment});
  EXPECT_TRUE(known.hold(holeOf({70, 50, 20, 20})));
  EXPECT_TRUE(known.hold(holeOf({85, 50, 15, 20})));
  EXPECT_FALSE(known.hold(holeOf({88, 50, 15, 20})));
  EXPECT_FALSE(known.hold(holeOf({10, 50, 20, 20})));
  // Around the camera it has no picture.
  segment.box.T_camera_box.translation().z() = 0.03;
  EXPECT_FALSE(KnownThings(kCamera, {segment}).hold(holeOf({70, 50, 20, 20})));
}

// Upright cylinders, seen by rays past them.
TEST(HoleBox, IsThatOfACylinder) {
  Table table;
  table.d = 0.8;
  table.T_table_camera.translation().z() = 0.8;  // what the camera's own axes are does not matter
  for (const double radius : {0.03, 0.06}) {
    for (const double height : {0.02, 0.06, 0.12, 0.25}) {
      const Eigen::Vector2d centre(0.3, 0.6);
      std::vector<Eigen::Vector2d> outline;
      for (int k = 0; k < 360; ++k) {
        const Eigen::Vector2d rim =
            centre + radius * Eigen::Vector2d(std::cos(k * M_PI / 180), std::sin(k * M_PI / 180));
        outline.push_back(rim);
        outline.push_back(rim * (table.d / (table.d - height)));  // where the ray over the top's rim meets the table
      }
      const std::optional<OrientedBox> box = boxOfHole(table, outline);
      ASSERT_EQ(box.has_value(), height > 1.2 * radius) << radius << " " << height;
      if (!box) continue;
      EXPECT_NEAR(box->size_m.z(), height, 0.01 * height);
      EXPECT_NEAR(box->size_m.x(), 2 * radius, 0.01 * radius);
      EXPECT_NEAR(box->size_m.y(), 2 * radius, 0.01 * radius);
      const Eigen::Vector3d at = (table.T_table_camera * box->T_camera_box).translation();
      EXPECT_LT((at - Eigen::Vector3d(0.3, 0.6, 0.5 * height)).norm(), 0.005);
    }
  }
  EXPECT_FALSE(boxOfHole(table, {}));
}
