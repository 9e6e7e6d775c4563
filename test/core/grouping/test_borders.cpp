// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "fixtures/piece_view.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

constexpr double kLength_m = 0.008;  // tolerance: corners, and the first centimetre over the table

const Surface kWideTable = slab(-1, -0.6, 1, 1.5, 0);

/// Low enough to see fronts and tops, from the middle: edges along x are rows of the picture.
Scene fromTheFront(std::vector<Surface> surfaces) {
  Scene scene = sceneOf(std::move(surfaces));
  scene.T_world_camera = lookAt({0, -0.8, 0.45}, {0, 0, 0.05});
  return scene;
}

Labelling swapped() {
  return [](int surface, const Eigen::Vector3d&) { return 3 - surface; };
}

/// The silhouette of a box in front of what is behind it, without its lower edge: from the foot of one front edge over
/// the top to the other's.
double silhouette(const PieceView& view, const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  double length = view.seenLength({low.x(), high.y(), high.z()}, high);
  for (const double x : {low.x(), high.x()}) {
    length += view.seenLength({x, low.y(), low.z()}, {x, low.y(), high.z()});
    length += view.seenLength({x, low.y(), high.z()}, {x, high.y(), high.z()});
  }
  return length;
}

}  // namespace

TEST(Borders, BoxesApartHaveNone) {
  const PieceView view(
      fromTheFront({kWideTable, box({-0.15, 0, 0}, {-0.05, 0.1, 0.1}), box({0.05, 0, 0}, {0.15, 0.1, 0.1})}),
      bySurface);
  ASSERT_EQ(view.pieces.count(), 2);
  EXPECT_TRUE(view.borders.pairs.empty());
  for (const Outline& outline : view.borders.outlines) EXPECT_EQ(outline.pieces, 0);
}

TEST(Borders, BoxesSideBySideAreInContact) {
  const Scene scene = fromTheFront({kWideTable, box({-0.1, 0, 0}, {0, 0.1, 0.1}), box({0, 0, 0}, {0.1, 0.1, 0.1})});
  for (const Labelling& labelling : {Labelling(bySurface), swapped()}) {
    const PieceView view(scene, labelling);
    ASSERT_EQ(view.borders.pairs.size(), 1u);
    const PairBorder& pair = view.borders.pairs.at({0, 1});
    const double edge = view.seenLength({0, 0, 0}, {0, 0, 0.1}) + view.seenLength({0, 0, 0.1}, {0, 0.1, 0.1});
    EXPECT_NEAR(pair.contact, edge, kLength_m);
    EXPECT_EQ(pair.first_in_front, 0);
    EXPECT_EQ(pair.second_in_front, 0);
    EXPECT_FLOAT_EQ(pair.total(), pair.contact);
    for (const Outline& outline : view.borders.outlines) EXPECT_NEAR(outline.pieces, edge, kLength_m);
    ASSERT_FALSE(pair.samples.empty());
    for (const ContactSample& sample : pair.samples) {
      EXPECT_EQ(view.pieces.label(sample.first), 0);
      EXPECT_EQ(view.pieces.label(sample.second), 1);
      EXPECT_LT((view.frame.points[sample.first] - view.frame.points[sample.second]).norm(), 0.012f);
    }
  }
}

TEST(Borders, AHigherBoxIsInContactOnlyWhereItTouches) {
  // 4 cm higher: fronts flush up to the lower one's top, whose right edge then runs into the side of the other.
  const PieceView view(fromTheFront({kWideTable, box({-0.1, 0, 0}, {0, 0.1, 0.14}), box({0, 0, 0}, {0.1, 0.1, 0.1})}),
                       bySurface);
  const PairBorder& pair = view.borders.pairs.at({0, 1});
  const double flush = view.seenLength({0, 0, 0}, {0, 0, 0.1});
  EXPECT_GT(pair.contact, flush - kLength_m);
  EXPECT_GT(pair.first_in_front, 0.01);
  EXPECT_EQ(pair.second_in_front, 0);
}

TEST(Borders, TheNearerBoxIsInFront) {
  const Eigen::Vector3d low(-0.05, -0.15, 0), high(0.05, -0.1, 0.1);
  const Scene scene = fromTheFront({kWideTable, box(low, high), box({-0.2, 0, 0}, {0.2, 0.1, 0.2})});
  // Rays over the front edges of the near box meet the foot of the far one from this height on.
  const double from = 0.45 - 0.45 * 0.65 / 0.8;
  float lengths[2];
  for (const bool near_first : {true, false}) {
    const PieceView view(scene, near_first ? Labelling(bySurface) : swapped());
    const double expected = silhouette(view, {low.x(), low.y(), from}, high);
    const PairBorder& pair = view.borders.pairs.at({0, 1});
    EXPECT_NEAR(near_first ? pair.first_in_front : pair.second_in_front, expected, kLength_m);
    EXPECT_EQ(near_first ? pair.second_in_front : pair.first_in_front, 0);
    EXPECT_EQ(pair.contact, 0);
    EXPECT_TRUE(pair.samples.empty());
    lengths[near_first] = pair.total();
  }
  EXPECT_NEAR(lengths[0], lengths[1], 1e-4) << "a border is as long as its nearer side, whichever is first";
}

TEST(Borders, OutlinesTellWhatTheyLieAgainst) {
  const Eigen::Vector3d low(-0.1, 0, 0), high(0.1, 0.1, 0.12);
  const Surface thing = box(low, high);
  const Surface table_in_front = slab(-1, -0.6, 1, 0.02, 0);
  {
    const PieceView view(fromTheFront({kWideTable, thing}), bySurface);
    const Outline& outline = view.borders.outlines.at(0);
    EXPECT_NEAR(outline.table, view.seenLength(low, {0.1, 0, 0}), 2 * kLength_m);
    EXPECT_NEAR(outline.front, silhouette(view, low, high), 2 * kLength_m);
    EXPECT_EQ(outline.behind + outline.unknown + outline.outside + outline.pieces, 0);
  }
  {
    SCOPED_TRACE("nothing is measured behind it");
    const PieceView view(fromTheFront({table_in_front, thing}), bySurface);
    const Outline& outline = view.borders.outlines.at(0);
    EXPECT_NEAR(outline.unknown, silhouette(view, low, high), 4 * kLength_m);
    EXPECT_EQ(outline.behind + outline.outside + outline.pieces, 0);
  }
  {
    SCOPED_TRACE("something that is no piece stands in front of it");
    const PieceView view(fromTheFront({kWideTable, thing, box({-0.02, -0.3, 0}, {0.02, -0.28, 0.5})}), bySurface, 1);
    const Outline& outline = view.borders.outlines.at(0);
    const double height = view.seenLength({0, 0, 0}, {0, 0, 0.12}) + view.seenLength({0, 0, 0.12}, {0, 0.1, 0.12});
    EXPECT_NEAR(outline.behind, 2 * height, 2 * kLength_m);
    EXPECT_EQ(outline.unknown + outline.outside + outline.pieces, 0);
  }
  {
    SCOPED_TRACE("it leaves the picture");
    Scene scene = fromTheFront({kWideTable, box({0.2, 0, 0}, {0.9, 0.1, 0.12})});
    const PieceView view(scene, bySurface);
    const Outline& outline = view.borders.outlines.at(0);
    int pixels = 0;
    double expected = 0;
    for (int v = 0; v < view.frame.height(); ++v) {
      const int last = v * view.frame.width() + view.frame.width() - 1;
      if (view.pieces.label(last) != 0) continue;
      ++pixels;
      expected += view.frame.points[last].z() / view.frame.camera.fx;
    }
    ASSERT_GT(pixels, 20);
    // One more pixel of the picture's border is as good as seen: a step over missing depth may end there too.
    EXPECT_NEAR(outline.outside, expected, 1e-4);
    EXPECT_EQ(outline.unknown + outline.behind + outline.pieces, 0);
  }
}

TEST(Borders, AFewMissingPixelsAreSteppedOver) {
  PieceView view(fromTheFront({kWideTable, box({-0.1, 0, 0}, {0, 0.1, 0.1}), box({0, 0, 0}, {0.1, 0.1, 0.1})}),
                 bySurface);
  const auto removeColumns = [&](int from, int to) {
    for (int v = 0; v < view.frame.height(); ++v) {
      for (int u = from; u <= to; ++u) {
        view.frame.points[v * view.frame.width() + u].setConstant(std::nanf(""));
        view.pieces.label(v, u) = -1;
      }
    }
    view.borders = findBorders(view.frame, view.points, view.pieces);
  };
  const float contact = view.borders.pairs.at({0, 1}).contact;
  removeColumns(319, 321);
  EXPECT_NEAR(view.borders.pairs.at({0, 1}).contact, contact, 0.1 * contact);
  removeColumns(290, 350);  // 9 cm
  EXPECT_TRUE(view.borders.pairs.empty());
  for (const Outline& outline : view.borders.outlines) EXPECT_GT(outline.unknown, 0.5 * contact);
}
