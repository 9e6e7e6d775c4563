// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <set>

#include "fixtures/cue_view.hpp"
#include "objectness_segmentation/cues/superpixels.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

Superpixels superpixelsOf(const CueView& view, const SuperpixelsConfig& config = {}) {
  return findSuperpixels(view.frame, view.normals, view.table, view.points, config);
}

/// Pixels of every label among the points (table frame) that satisfy a condition.
std::map<int, int> labelsWhere(const CueView& view, const Superpixels& superpixels,
                               const std::function<bool(int surface, const Eigen::Vector3d& point)>& condition) {
  std::map<int, int> pixels;
  for (int i = 0; i < view.frame.size(); ++i) {
    const Eigen::Vector3d point = view.table.T_table_camera * view.frame.points[i].cast<double>();
    if (condition(view.scene.seen[i], point)) ++pixels[superpixels.label(i)];
  }
  return pixels;
}

std::map<int, int> labelsOf(const CueView& view, const Superpixels& superpixels, int surface) {
  return labelsWhere(view, superpixels, [&](int seen, const Eigen::Vector3d&) { return seen == surface; });
}

void expectNoneInCommon(std::map<int, int> a, std::map<int, int> b) {
  a.erase(0), b.erase(0);
  EXPECT_FALSE(a.empty());
  EXPECT_FALSE(b.empty());
  for (const auto& entry : a) EXPECT_EQ(b.count(entry.first), 0u) << "superpixel " << entry.first;
}

}  // namespace

TEST(Superpixels, ThingsSideBySideShareNone) {
  Scene scene = sceneOf({kTable, box({-0.12, -0.1, 0}, {0, 0.05, 0.12}), box({0, -0.06, 0}, {0.1, 0.06, 0.08})});
  scene.s0 = 0.0003, scene.s2 = 0.001;
  const CueView view(scene);
  const Superpixels superpixels = superpixelsOf(view);
  expectNoneInCommon(labelsOf(view, superpixels, 1), labelsOf(view, superpixels, 2));
}

TEST(Superpixels, ThingOnAThingSharesNone) {
  Scene scene =
      sceneOf({kTable, box({-0.15, -0.1, 0}, {0.15, 0.1, 0.05}), box({-0.06, -0.05, 0.05}, {0.05, 0.06, 0.13})});
  scene.s0 = 0.0003, scene.s2 = 0.001;
  const CueView view(scene);
  const Superpixels superpixels = superpixelsOf(view);
  expectNoneInCommon(labelsOf(view, superpixels, 1), labelsOf(view, superpixels, 2));
}

TEST(Superpixels, StepBetweenParallelFacesCuts) {
  const CueView view(sceneOf({kTable, box({-0.12, -0.1, 0}, {0, 0.1, 0.10}), box({0, -0.1, 0}, {0.1, 0.1, 0.115})}));
  const Superpixels superpixels = superpixelsOf(view);
  const auto top = [&](int surface, double height) {
    return labelsWhere(view, superpixels, [&](int seen, const Eigen::Vector3d& point) {
      return seen == surface && point.z() > height - 1e-4;
    });
  };
  expectNoneInCommon(top(1, 0.10), top(2, 0.115));
}

TEST(Superpixels, SmallStepBetweenFlushFacesCuts) {
  // One box on another, their fronts 4 mm apart: less than the window of a normal, which sees no bend there.
  Scene scene = sceneOf({kTable, box({-0.1, -0.1, 0}, {0.1, 0.1, 0.1}), box({-0.1, -0.096, 0.1}, {0.1, 0.1, 0.2})});
  scene.s0 = 0.0003, scene.s2 = 0.0005;
  scene.T_world_camera = lookAt({0, -0.8, 0.3}, {0, 0, 0.1});
  const CueView view(scene);
  const auto fronts = [&](const Superpixels& superpixels, int surface) {
    return labelsWhere(view, superpixels, [&](int seen, const Eigen::Vector3d& p) {
      return seen == surface && p.y() < -0.09 && std::abs(p.z() - 0.1) < 0.08;
    });
  };
  const Superpixels cut = superpixelsOf(view);
  expectNoneInCommon(fronts(cut, 1), fronts(cut, 2));
  const Superpixels uncut = superpixelsOf(view, superpixelsForBoxes({}));
  std::map<int, int> low = fronts(uncut, 1), high = fronts(uncut, 2);
  low.erase(0), high.erase(0);
  EXPECT_EQ(low.begin()->first, high.begin()->first) << "the step cut would not be tested";
}

TEST(Superpixels, CutsHoldWhereTheyAreOpenSomewhere) {
  // Two tops side by side with a narrow bridge between them.
  const CueView view(
      sceneOf({kTable, box({-0.17, -0.12, 0}, {-0.02, 0.12, 0.10}), box({0.02, -0.12, 0}, {0.15, 0.12, 0.10}),
               box({-0.02, -0.012, 0}, {0.02, 0.012, 0.10})}));
  const auto top = [&](const Superpixels& superpixels, int surface) {
    std::map<int, int> labels = labelsWhere(view, superpixels, [&](int seen, const Eigen::Vector3d& point) {
      return seen == surface && point.z() > 0.0999;
    });
    labels.erase(0);
    return labels;
  };
  const Superpixels cut = superpixelsOf(view);
  std::map<int, int> left = top(cut, 1), right = top(cut, 2);
  ASSERT_EQ(left.size(), 1u);
  const int own = left.begin()->first;
  EXPECT_LE(right[own], 10) << "pixels at the end of the bridge";
  right.erase(own);
  ASSERT_EQ(right.size(), 1u);
  EXPECT_GT(right.begin()->second, 4000);

  const Superpixels uncut = superpixelsOf(view, superpixelsForBoxes({}));
  EXPECT_EQ(top(uncut, 1).begin()->first, top(uncut, 2).begin()->first);
}

TEST(Superpixels, RoundThingsStayWhole) {
  Scene scene = sceneOf({kTable, tube(-0.1, 0, 0, 0.15, 0.04), sphere({0.1, 0, 0.05}, 0.05)});
  scene.T_world_camera = lookAt({0, -0.9, 0.25}, {0, 0, 0.06});  // low: does not see into the tube
  const CueView view(scene);
  const Superpixels superpixels = superpixelsOf(view);
  const auto outside = [](int seen, const Eigen::Vector3d& point) { return seen == 1 && point.y() < -0.005; };
  for (std::map<int, int> labels : {labelsWhere(view, superpixels, outside), labelsOf(view, superpixels, 2)}) {
    int pixels = 0, largest = 0;
    for (const auto& entry : labels) {
      pixels += entry.second;
      if (entry.first > 0) largest = std::max(largest, entry.second);
    }
    EXPECT_GT(largest, 0.6 * pixels);
    labels.erase(0);
    EXPECT_EQ(labels.size(), 1u);
  }
}

TEST(Superpixels, ConvexRightAngleCuts) {
  const CueView view(sceneOf({kTable, box({-0.1, -0.1, 0}, {0.1, 0.1, 0.12})}));
  const Superpixels superpixels = superpixelsOf(view);
  const auto where = [&](bool top) {
    return labelsWhere(view, superpixels, [&](int seen, const Eigen::Vector3d& point) {
      return seen == 1 && (point.z() > 0.1199) == top;
    });
  };
  expectNoneInCommon(where(true), where(false));
  EXPECT_EQ(superpixels.count, 2);
}

TEST(Superpixels, LabelsAreObjectPointsNumberedByTheirFirstPixel) {
  const CueView view(sceneOf({kTable, box({-0.2, -0.1, 0}, {-0.05, 0.05, 0.12}),
                              box({0.05, -0.15, 0}, {0.2, 0.1, 0.06}), sphere({0, 0.1, 0.04}, 0.04)}));
  const Superpixels superpixels = superpixelsOf(view);
  int highest = 0;
  std::vector<int> pixels(superpixels.count + 1, 0);
  for (int i = 0; i < view.frame.size(); ++i) {
    const int label = superpixels.label(i);
    ASSERT_TRUE(label == 0 || view.points.mask(i)) << "label outside the object points";
    ASSERT_LE(label, highest + 1) << "a number is skipped";
    highest = std::max(highest, label);
    ++pixels[label];
  }
  EXPECT_EQ(highest, superpixels.count);
  EXPECT_GE(superpixels.count, 5);
  for (int label = 1; label <= superpixels.count; ++label) EXPECT_GE(pixels[label], SuperpixelsConfig{}.min_pixels);
}

TEST(Superpixels, SmallPiecesGetNoLabel) {
  const CueView view(sceneOf({kTable, box({-0.1, -0.1, 0}, {0.1, 0.1, 0.12})}));
  SuperpixelsConfig config;
  config.min_pixels = 100000;
  EXPECT_EQ(superpixelsOf(view, config).count, 0);
  config = {};
  config.min_area_m2 = 0.01;  // the top shows 0.026 m^2 to the camera, the front less than 0.018
  config.min_pixels = 1;
  const int large = superpixelsOf(view, config).count;
  EXPECT_GE(large, 1);
  EXPECT_LE(large, 2);
}

TEST(Superpixels, SameTwice) {
  Scene scene = sceneOf({kTable, box({-0.15, -0.1, 0}, {0.15, 0.1, 0.05}), sphere({0, 0, 0.1}, 0.05)});
  scene.s0 = 0.0008, scene.s2 = 0.0016;
  const CueView view(scene);
  const Superpixels first = superpixelsOf(view), second = superpixelsOf(view);
  EXPECT_EQ(first.count, second.count);
  EXPECT_EQ(cv::countNonZero(first.label != second.label), 0);
}

TEST(Superpixels, NoneWithoutObjectPoints) {
  const CueView view(sceneOf({kTable}));
  const Superpixels superpixels = superpixelsOf(view);
  EXPECT_EQ(superpixels.count, 0);
  EXPECT_EQ(superpixels.label.size(), cv::Size(640, 480));
  EXPECT_EQ(cv::countNonZero(superpixels.label), 0);
}
