// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "fixtures/random_frame.hpp"
#include "fixtures/ray_cast.hpp"
#include "fixtures/temporary_folder.hpp"
#include "objectness_segmentation/io/scene_folder.hpp"
#include "objectness_segmentation/pipeline.hpp"
#include "objectness_segmentation/scene/normals.hpp"
#include "scene/bridged_gaps.hpp"
#include "segments/segments.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

const float kNan = std::numeric_limits<float>::quiet_NaN();

Frame bareTable() {
  Scene scene;
  scene.surfaces = {slab(-5, -5, 5, 5, 0)};
  return scene.render();
}

template <class IsHole>
Frame withHoles(Frame frame, const IsHole& is_hole) {
  for (int i = 0; i < frame.size(); ++i) {
    if (is_hole(i % frame.width(), i / frame.width())) frame.points[i].setConstant(kNan);
  }
  return frame;
}

/// Every pair of measured pixels with the hole between them on a straight line, by what the header says.
std::map<int, float> bridgedByTheBook(const Frame& frame, int max_gap_px) {
  std::map<int, float> bridged;
  const auto depth = [&](int u, int v) {
    const bool inside = u >= 0 && v >= 0 && u < frame.width() && v < frame.height();
    return inside ? frame.points[v * frame.width() + u].z() : kNan;
  };
  for (int i = 0; i < frame.size(); ++i) {
    const int u = i % frame.width(), v = i / frame.width();
    if (depth(u, v) > 0) continue;
    std::pair<float, float> least{1e9f, 1e9f};  // length, difference
    for (const auto& [du, dv] : {std::pair{1, 0}, {0, 1}, {1, 1}, {1, -1}}) {
      for (int ahead = 1; ahead <= max_gap_px; ++ahead) {
        for (int behind = 1; ahead + behind - 1 <= max_gap_px; ++behind) {
          bool empty_between = true;
          for (int k = -behind + 1; k < ahead; ++k)
            empty_between = empty_between && !(depth(u + k * du, v + k * dv) > 0);
          const float a = depth(u + ahead * du, v + ahead * dv), b = depth(u - behind * du, v - behind * dv);
          if (!empty_between || !(a > 0) || !(b > 0)) continue;
          const float length = (ahead + behind) * (du != 0 && dv != 0 ? std::sqrt(2.0f) : 1.0f), near = std::min(a, b);
          const double allowed = std::max(6 * DepthNoise().sigma(near), 8 * near * length / frame.camera.focal());
          if (std::abs(a - b) > static_cast<float>(allowed)) continue;
          if (std::pair(length, std::abs(a - b)) >= least) continue;
          least = {length, std::abs(a - b)};
          bridged[i] = (ahead + behind) / (ahead / b + behind / a);
        }
      }
    }
  }
  return bridged;
}

}  // namespace

TEST(BridgedGaps, ExactOnAPlane) {
  const Frame whole = bareTable();
  Frame frame = withHoles(whole, [](int u, int v) { return u % 5 < 2 || v % 3 == 1; });
  bridgeGaps(2, frame);
  EXPECT_GT(frame.bridged.size(), 0.55 * frame.size());
  EXPECT_TRUE(std::is_sorted(frame.bridged.begin(), frame.bridged.end()));
  for (const int i : frame.bridged) {
    ASSERT_LT((frame.points[i] - whole.points[i]).norm(), 2e-6f * whole.points[i].norm()) << i;
  }
  int left = 0;
  for (int v = 2; v < frame.height() - 2; ++v) {
    for (int u = 2; u < frame.width() - 2; ++u) left += !(frame.points[v * frame.width() + u].z() > 0);
  }
  EXPECT_EQ(left, 0) << "the lattice is gone but at the border of the image";
}

TEST(BridgedGaps, AsByTheBookInRandomPictures) {
  std::mt19937 random(3);
  for (const int max_gap_px : {1, 2, 4}) {
    for (const double share : {0.05, 0.3, 0.6}) {
      const Frame holes =
          withHoles(randomFrame(60, 40, 11 + max_gap_px), [&](int, int) { return random() / 4294967296.0 < share; });
      Frame frame = holes;
      bridgeGaps(max_gap_px, frame);
      const std::map<int, float> expected = bridgedByTheBook(holes, max_gap_px);
      ASSERT_EQ(frame.bridged.size(), expected.size());
      ASSERT_GT(expected.size(), 50u);
      for (const int i : frame.bridged) {
        ASSERT_TRUE(expected.count(i));
        ASSERT_FLOAT_EQ(frame.points[i].z(), expected.at(i));
        const Eigen::Vector2d pixel = frame.camera.project(frame.points[i].cast<double>());
        ASSERT_LT((pixel - Eigen::Vector2d(i % 60, i / 60)).norm(), 1e-3) << "on the ray of its pixel";
      }
    }
  }
}

TEST(BridgedGaps, WideHolesAndTheirRimsStay) {
  Frame frame = withHoles(bareTable(), [](int u, int v) { return u >= 300 && u < 303 && v < 400; });
  bridgeGaps(2, frame);
  EXPECT_TRUE(std::all_of(frame.bridged.begin(), frame.bridged.end(), [](int i) { return i / 640 >= 398; }))
      << "but at the end of the slit, where diagonals are short";
}

TEST(BridgedGaps, ABoundaryIsNotBridged) {
  Frame frame = bareTable();
  for (int i = 0; i < frame.size(); ++i) {
    if (i % 640 > 320) frame.points[i] *= 0.9f;  // a step of 6 cm and more
    if (i % 640 == 320) frame.points[i].setConstant(kNan);
  }
  bridgeGaps(2, frame);
  EXPECT_TRUE(frame.bridged.empty());
}

TEST(BridgedGaps, SwitchedOff) {
  const Frame holes = withHoles(bareTable(), [](int u, int) { return u % 8 == 3; });
  Frame frame = holes;
  bridgeGaps(0, frame);
  EXPECT_TRUE(frame.bridged.empty());
  EXPECT_TRUE(std::isnan(frame.points[3].z()));
}

TEST(BridgedGaps, MakeFrameBridgesByTheConfiguration) {
  const Frame table = bareTable();
  cv::Mat_<float> depth(table.height(), table.width());
  for (int i = 0; i < table.size(); ++i) depth(i / 640, i % 640) = i % 640 % 8 == 3 ? 0.0f : table.points[i].z();
  InputConfig config;
  const Result<Frame> bridged = makeFrame(depth, {}, table.camera, config);
  ASSERT_TRUE(bridged.ok());
  EXPECT_EQ(bridged.value.bridged.size(), 80u * 480);
  config.max_gap_px = 0;
  EXPECT_TRUE(makeFrame(depth, {}, table.camera, config).value.bridged.empty());
}

TEST(BridgedGaps, ABridgedPixelHasTheLabelOfAllItsNeighbours) {
  Segment left, right;
  for (int v = 0; v < 3; ++v) {
    for (int u = 0; u < 4; ++u) left.pixels.push_back(v * 8 + u);
    for (int u = 4; u < 8; ++u) right.pixels.push_back(v * 8 + u);
  }
  const std::vector<int> bridged = {9, 12};
  std::vector<Segment> segments = {left, right};
  keepMeasured(bridged, segments);
  EXPECT_EQ(segments[0].pixels.size(), 11u);
  EXPECT_EQ(std::count(segments[1].pixels.begin(), segments[1].pixels.end(), 12), 0);
  const cv::Mat_<ushort> labels = labelImage(cv::Mat_<uchar>(3, 8, uchar{0}), bridged, segments);
  EXPECT_EQ(labels(1, 1), 2);
  EXPECT_EQ(labels(1, 4), 0) << "its neighbours do not agree";
}
