// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "fixtures/cue_view.hpp"
#include "objectness_segmentation/cues/edges.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

/// A low box in front of a high one, 15 cm apart.
Scene boxBeforeBox() {
  return sceneOf({kTable, box({-0.15, 0.1, 0}, {0.15, 0.2, 0.25}), box({-0.05, -0.1, 0}, {0.05, -0.05, 0.2})});
}

/// The shadow of a projector: of the far box, ten pixels to the left of the near one are not measured. Returns the
/// pixels on either side, near and far.
std::vector<std::pair<int, int>> addShadow(CueView& view) {
  std::vector<std::pair<int, int>> sides;
  for (int i = 12; i < view.frame.size(); ++i) {
    if (view.scene.seen[i] != 2 || view.scene.seen[i - 1] != 1) continue;
    for (int k = 1; k <= 10; ++k) view.frame.points[i - k].setConstant(std::numeric_limits<float>::quiet_NaN());
    sides.emplace_back(i, i - 11);
  }
  view.describe();
  return sides;
}

int count(const cv::Mat_<uchar>& kinds, int bits) {
  int found = 0;
  for (const uchar kind : kinds) found += (kind & bits) != 0;
  return found;
}

/// Share of the points of a line of the model that have an edge of this kind within reach_px.
double covered(const CueView& view, const EdgeMap& edges, EdgeKind kind, const Eigen::Vector3d& from,
               const Eigen::Vector3d& to, int reach_px) {
  int hits = 0;
  constexpr int kSamples = 50;
  for (int k = 0; k < kSamples; ++k) {
    const Eigen::Vector2i p = view.pixelOf(from + (to - from) * (k + 0.5) / kSamples);
    const cv::Rect around(p.x() - reach_px, p.y() - reach_px, 2 * reach_px + 1, 2 * reach_px + 1);
    hits += count(edges.kinds(around), kind) > 0;
  }
  return double(hits) / kSamples;
}

EdgesConfig detector(bool pcl) {
  EdgesConfig config;
  config.pcl = pcl;
  return config;
}

EdgeMap edgesOf(const CueView& view, const EdgesConfig& config = {}) {
  return findEdges(view.frame, view.normals, view.table, view.points, config);
}

class EitherDetector : public testing::TestWithParam<bool> {};

}  // namespace

INSTANTIATE_TEST_SUITE_P(Edges, EitherDetector, testing::Bool(),
                         [](const auto& info) { return std::string(info.param ? "Pcl" : "Metric"); });

TEST_P(EitherDetector, NearSideOfAStepOccludesTheFarSide) {
  const CueView view(boxBeforeBox());
  const EdgeMap edges = edgesOf(view, detector(GetParam()));
  int steps = 0;
  for (int i = 0; i + 1 < view.frame.size(); ++i) {
    for (const auto& [near, far] : {std::make_pair(i, i + 1), std::make_pair(i + 1, i)}) {
      if (view.scene.seen[near] != 2 || view.scene.seen[far] != 1) continue;
      if (view.points.height_m(far) < 0.01f) continue;  // so low it may be the table's
      ++steps;
      EXPECT_TRUE(edges.kinds(near) & kOccluding) << i % 640 << ", " << i / 640;
      EXPECT_FALSE(edges.kinds(near) & kOccluded);
      EXPECT_TRUE(edges.kinds(far) & kOccluded);
      EXPECT_FALSE(edges.kinds(far) & kOccluding);
    }
  }
  EXPECT_GT(steps, 20);
}

TEST_P(EitherDetector, LooksAcrossMissingDepth) {
  CueView view(boxBeforeBox());
  const auto sides = addShadow(view);
  ASSERT_GT(sides.size(), 10u);
  const EdgeMap edges = edgesOf(view, detector(GetParam()));
  int near_sides = 0, far_sides = 0;
  for (const auto& [near, far] : sides) {
    near_sides += edges.kinds(near) == kOccluding;
    far_sides += edges.kinds(far) == kOccluded;
  }
  EXPECT_GT(near_sides, 0.85 * sides.size());
  EXPECT_GT(far_sides, 0.85 * sides.size());
}

TEST_P(EitherDetector, BorderWhereNothingLiesBehind) {
  // The box rises over the far end of all that is measured.
  const CueView view(sceneOf({slab(-0.6, -0.4, 0.6, 0.06, 0), box({-0.1, -0.05, 0}, {0.1, 0.05, 0.3})}));
  const EdgeMap edges = edgesOf(view, detector(GetParam()));
  const auto along = [&](EdgeKind kind) {
    return covered(view, edges, kind, {-0.095, 0.05, 0.3}, {0.095, 0.05, 0.3}, 1);
  };
  EXPECT_GT(along(kBorder), 0.95);
  EXPECT_EQ(along(kOccluding), 0);
  EXPECT_EQ(along(kOccluded), 0);
}

TEST_P(EitherDetector, CreasesOfABoxAndOfItsFoot) {
  const CueView view(sceneOf({kTable, box({-0.1, -0.1, 0}, {0.1, 0.05, 0.12})}));
  const EdgeMap edges = edgesOf(view, detector(GetParam()));
  EXPECT_GT(covered(view, edges, kHighCurvature, {-0.08, -0.1, 0.12}, {0.08, -0.1, 0.12}, 1), 0.95);
  EXPECT_GT(covered(view, edges, kHighCurvature, {-0.08, -0.1, 0}, {0.08, -0.1, 0}, 2), 0.95);
  const int length_px = view.pixelOf({0.1, -0.1, 0.12}).x() - view.pixelOf({-0.1, -0.1, 0.12}).x();
  EXPECT_LT(count(edges.kinds, kHighCurvature), 2.6 * length_px) << "two lines, thin";
}

TEST_P(EitherDetector, NothingInsideNoisyFaces) {
  Scene scene = sceneOf({kTable, box({-0.15, -0.15, 0}, {0.15, 0.15, 0.1})});
  scene.s0 = 0.0003, scene.s2 = 0.001;
  const CueView view(scene);
  const EdgeMap edges = edgesOf(view, detector(GetParam()));
  int inside = 0, found = 0;
  for (int i = 0; i < view.frame.size(); ++i) {
    if (view.scene.seen[i] != 1) continue;
    const Eigen::Vector3d p = view.table.T_table_camera * view.frame.points[i].cast<double>();
    if (p.z() < 0.09 || p.head<2>().cwiseAbs().maxCoeff() > 0.12) continue;
    ++inside;
    found += edges.kinds(i) != 0;
  }
  ASSERT_GT(inside, 5000);
  EXPECT_EQ(found, 0);
}

TEST_P(EitherDetector, NoneOnABareTable) {
  const CueView view(sceneOf({kTable}));
  EXPECT_EQ(cv::countNonZero(edgesOf(view, detector(GetParam())).kinds), 0);
}

TEST_P(EitherDetector, ShadowsOutlineOnTheTableIsNoObject) {
  const CueView view(boxBeforeBox());
  const EdgeMap edges = edgesOf(view, detector(GetParam()));
  for (int i = 0; i < view.frame.size(); ++i) {
    ASSERT_TRUE(view.scene.seen[i] > 0 || (edges.kinds(i) & ~kHighCurvature) == 0) << i % 640 << ", " << i / 640;
  }
}

TEST(MetricEdges, HoleInAFaceIsNoEdge) {
  CueView view(sceneOf({kTable, box({-0.15, -0.15, 0}, {0.15, 0.15, 0.1})}));
  const Eigen::Vector2i centre = view.pixelOf({0, 0, 0.1});
  const cv::Rect hole(centre.x() - 6, centre.y() - 4, 12, 9);
  for (int v = hole.y; v < hole.br().y; ++v) {
    for (int u = hole.x; u < hole.br().x; ++u) {
      view.frame.points[v * 640 + u].setConstant(std::numeric_limits<float>::quiet_NaN());
    }
  }
  view.describe();
  const cv::Rect around(hole.x - 5, hole.y - 5, hole.width + 10, hole.height + 10);
  EXPECT_EQ(cv::countNonZero(edgesOf(view).kinds(around)), 0);
}

TEST(MetricEdges, GapWiderThanTheSearchIsABorder) {
  CueView view(boxBeforeBox());
  const auto sides = addShadow(view);
  EdgesConfig config;
  config.gap_m = 0.01;
  const EdgeMap edges = edgesOf(view, config);
  int borders = 0;
  for (const auto& side : sides) borders += edges.kinds(side.first) == kBorder && edges.kinds(side.second) == kBorder;
  EXPECT_GT(borders, 0.85 * sides.size());
}

TEST(MetricEdges, ImageBorderCutsObjects) {
  Scene scene = sceneOf({kTable, box({-0.1, -0.1, 0}, {0.1, 0.05, 0.12})});
  scene.camera.cx -= scene.camera.width / 2;  // the left half of the box is out of the picture
  const CueView view(scene);
  const EdgeMap edges = edgesOf(view);
  int rows = 0;
  for (int v = 1; v + 1 < 480; ++v) {
    if (!view.points.mask(v, 0) || !view.points.mask(v - 1, 0) || !view.points.mask(v + 1, 0)) continue;
    ++rows;
    EXPECT_TRUE(edges.kinds(v, 0) & kBorder) << v;
  }
  EXPECT_GT(rows, 30);
}

TEST(MetricEdges, SpecksAreNoise) {
  CueView view(sceneOf({kTable, box({-0.15, -0.15, 0}, {0.15, 0.15, 0.1})}));
  const Eigen::Vector2i centre = view.pixelOf({0, 0, 0.1});
  view.frame.points[centre.y() * 640 + centre.x()] *= 0.95f;
  view.describe();
  const cv::Rect around(centre.x() - 20, centre.y() - 15, 41, 31);
  EXPECT_EQ(cv::countNonZero(edgesOf(view).kinds(around)), 0);
  EdgesConfig config;
  config.min_length_m = 0;
  EXPECT_GT(cv::countNonZero(edgesOf(view, config).kinds(around)), 0);
}

TEST(MetricEdges, ReadTheSameAtTwiceTheResolution) {
  Scene coarse = sceneOf({kTable, box({-0.1, -0.1, 0}, {0.1, 0.05, 0.12})});
  Scene fine = coarse;
  fine.camera = {1050, 1050, 639.5, 479.5, 1280, 960};
  const CueView coarse_view(coarse), fine_view(fine);
  const EdgeMap coarse_edges = edgesOf(coarse_view), fine_edges = edgesOf(fine_view);
  for (const EdgeKind kind : {kHighCurvature, kOccluding}) {
    const double longer = double(count(fine_edges.kinds, kind)) / count(coarse_edges.kinds, kind);
    EXPECT_NEAR(longer, 2.0, 0.3) << "length in pixels";
  }
}
