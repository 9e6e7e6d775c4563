// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "common/angles.hpp"
#include "evaluation/stability.hpp"
#include "fixtures/figure.hpp"
#include "fixtures/label_pictures.hpp"

using namespace objectness;
using namespace objectness::evaluation;
using namespace objectness_test;
using Eigen::Vector3d;

namespace {

const cv::Size kSize(60, 40);

/// A segment's pixels and its box.
struct Thing {
  cv::Rect area;
  Vector3d centre = Vector3d::Zero();
  double yaw_deg = 0;
  Vector3d size = {0.1, 0.06, 0.2};
};

StillFrame frameOf(const std::vector<Thing>& things) {
  StillFrame frame;
  std::vector<std::pair<cv::Rect, int>> areas;
  for (const Thing& thing : things) {
    areas.emplace_back(thing.area, 2 + static_cast<int>(areas.size()));
    OrientedBox box;
    box.T_camera_box.translation() = thing.centre;
    box.T_camera_box.rotate(Eigen::AngleAxisd(thing.yaw_deg * kDegree, Vector3d::UnitZ()));
    box.size_m = thing.size;
    frame.boxes.push_back(box);
  }
  frame.labels = paintLabels(kSize, 1, areas);
  return frame;
}

const cv::Rect kLeft(5, 5, 10, 10), kRight(30, 5, 20, 20);

}  // namespace

TEST(Stability, NothingMoves) {
  const StillFrame frame = frameOf({{kLeft}, {kRight, {0.3, 0, 0}}});
  const StillFrame other_order = frameOf({{kRight, {0.3, 0, 0}}, {kLeft}});
  const Metrics figures = measureStability({frame, other_order, frame});
  EXPECT_EQ(figure(figures, "frames"), 3);
  EXPECT_EQ(figure(figures, "count"), 2);
  EXPECT_EQ(figure(figures, "segment_IoU"), 1);
  for (const char* none :
       {"count_spread", "switches", "turn_median_deg", "turn_max_deg", "centre_spread_mm", "side_spread_mm"}) {
    EXPECT_NEAR(figure(figures, none), 0, 1e-5) << none;
  }
  EXPECT_TRUE(measureStability({}).empty());
  EXPECT_TRUE(measureStability({frame}).empty());
}

TEST(Stability, OfBoxesThatTurnShiftAndGrow) {
  // The left thing turns by 10 and back, the right one by 80 degrees, which is one by -10 with sides exchanged.
  const Metrics figures = measureStability(
      {frameOf({{kLeft}, {kRight}}), frameOf({{kLeft, {0.02, 0, 0}, 10}, {kRight, {0, 0, 0}, 80, {0.06, 0.1, 0.2}}}),
       frameOf({{kLeft}, {kRight, {0, 0, 0}, 80, {0.06, 0.1, 0.26}}})});
  EXPECT_NEAR(figure(figures, "turn_max_deg"), 10, 1e-5);
  EXPECT_NEAR(figure(figures, "turn_median_deg"), 10, 1e-5) << "10, 10, 10 and 0";
  // Centres: 0, 20, 0 and three equal ones. Sides: those of the right one's height 200, 200, 260, of six times three.
  const double centre = (2 * 20. * 20 / 9 + 40. * 40 / 9) / 6, side = (2 * 20. * 20 + 40. * 40) / 18;
  EXPECT_NEAR(figure(figures, "centre_spread_mm"), std::sqrt(centre), 1e-6);
  EXPECT_NEAR(figure(figures, "side_spread_mm"), std::sqrt(side), 1e-6);
}

TEST(Stability, OfSegmentsThatChange) {
  // The right one is cut to 0.6, then to a third of that, which is another thing; the left one goes.
  const Metrics figures = measureStability(
      {frameOf({{kLeft}, {kRight}}), frameOf({{kLeft}, {{30, 5, 20, 12}}}), frameOf({{{30, 5, 20, 4}}})});
  EXPECT_NEAR(figure(figures, "count"), 5. / 3, 1e-12);
  EXPECT_NEAR(figure(figures, "count_spread"), std::sqrt(2.) / 3, 1e-12);
  EXPECT_NEAR(figure(figures, "switches"), 2. / 2, 1e-12);
  EXPECT_NEAR(figure(figures, "segment_IoU"), (1 + 0.6) / 2, 1e-12);
}
