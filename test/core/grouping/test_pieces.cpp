// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "fixtures/piece_view.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

/// From straight above, 0.7 m over the table: what lies at one height is measured without foreshortening.
Scene fromAbove(std::vector<Surface> surfaces) {
  Scene scene = sceneOf(std::move(surfaces));
  scene.T_world_camera = lookAt({0, -1e-6, 0.7}, {0, 0, 0});
  return scene;
}

/// Each pixel of a piece is labelled so, once, in order; area, centroid and counts follow from the pixels.
void expectConsistent(const PieceView& view) {
  int labelled = 0, listed = 0;
  for (int i = 0; i < view.frame.size(); ++i) {
    const int label = view.pieces.label(i);
    labelled += label >= 0;
    ASSERT_LT(label, view.pieces.count());
    if (label >= 0) {
      ASSERT_TRUE(view.points.mask(i)) << "no object point";
    }
    if (view.superpixels.label(i) > 0) {
      ASSERT_EQ(label, view.superpixels.label(i) - 1) << "superpixels keep their number";
    }
  }
  for (int k = 0; k < view.pieces.count(); ++k) {
    const Piece& piece = view.pieces.pieces[k];
    ASSERT_FALSE(piece.pixels.empty());
    EXPECT_TRUE(std::is_sorted(piece.pixels.begin(), piece.pixels.end()));
    int smooth = 0;
    double area = 0;
    Eigen::Vector3d sum(0, 0, 0);
    for (const int pixel : piece.pixels) {
      ASSERT_EQ(view.pieces.label(pixel), k);
      const Eigen::Vector3d p = view.frame.points[pixel].cast<double>();
      smooth += view.superpixels.label(pixel) > 0;
      area += p.z() * p.z() / (view.frame.camera.fx * view.frame.camera.fy);
      sum += p;
    }
    listed += static_cast<int>(piece.pixels.size());
    EXPECT_EQ(piece.smooth_pixels, smooth);
    EXPECT_NEAR(piece.area_m2, area, 1e-3 * area);
    EXPECT_LT((sum / piece.pixels.size() - piece.centroid.cast<double>()).norm(), 1e-4);
  }
  EXPECT_EQ(labelled, listed);
}

}  // namespace

TEST(Pieces, FollowTheirSuperpixelsOverTheRoughPointsAroundThem) {
  // Tops of 0.2 x 0.1 m and 0.1 x 0.1 m side by side, rough within a centimetre of their edges.
  const auto within = [](double x, double low, double high) { return x > low + 0.01 && x < high - 0.01; };
  const PieceView view(fromAbove({kTable, box({-0.2, 0, 0}, {0, 0.1, 0.05}), box({0, 0, 0}, {0.1, 0.1, 0.05})}),
                       [&](int surface, const Eigen::Vector3d& p) {
                         const bool inner =
                             within(p.y(), 0, 0.1) && (surface == 1 ? within(p.x(), -0.2, 0) : within(p.x(), 0, 0.1));
                         return inner && p.z() > 0.049 ? surface : 0;
                       });
  expectConsistent(view);
  ASSERT_EQ(view.pieces.count(), 2);
  const double expected[] = {0.02, 0.01};
  const Eigen::Vector3d centres[] = {{-0.1, 0.05, 0.05}, {0.05, 0.05, 0.05}};
  for (int k = 0; k < 2; ++k) {
    const Piece& piece = view.pieces.pieces[k];
    EXPECT_NEAR(piece.area_m2, expected[k], 0.02 * expected[k]) << "the rough points count";
    EXPECT_LT((view.scene.T_world_camera * piece.centroid.cast<double>() - centres[k]).norm(), 0.002);
    EXPECT_GT(piece.mean_normal.dot(view.table.normal.cast<float>()), 0.9);
    EXPECT_LE(piece.mean_normal.norm(), 1.0001f);
    EXPECT_LT(piece.smooth_pixels, static_cast<int>(piece.pixels.size()));
  }
  for (int i = 0; i < view.frame.size(); ++i) {
    const int seen = view.scene.seen[i];
    if (seen > 0 && view.world(i).z() > 0.049) {
      ASSERT_EQ(view.pieces.label(i), seen - 1) << "the nearer one";
    }
  }
}

TEST(Pieces, RoughRestsBecomePiecesWhenTheyShowEnough) {
  // Beyond the reach of the one superpixel: a large rest, and a thing of 4 x 4 mm.
  const Labelling corner = [](int surface, const Eigen::Vector3d& p) { return surface == 1 && p.x() < -0.15; };
  PieceView view(fromAbove({kTable, box({-0.2, 0, 0}, {0.1, 0.1, 0.05}), box({0.2, 0, 0}, {0.204, 0.004, 0.005}),
                            box({0.2, 0.1, 0}, {0.22, 0.12, 0.02})}),
                 corner);
  const auto pieceAt = [&](const Eigen::Vector3d& p) {
    const Eigen::Vector2i pixel = view.pixelOf(p);
    return view.pieces.label(pixel.y(), pixel.x());
  };
  const Eigen::Vector3d superpixel(-0.18, 0.05, 0.05), near(-0.13, 0.05, 0.05), far(0, 0.05, 0.05),
      speck(0.202, 0.002, 0.005), cube(0.21, 0.11, 0.02);
  expectConsistent(view);
  EXPECT_EQ(view.pieces.count(), 3);
  EXPECT_EQ(pieceAt(superpixel), 0);
  EXPECT_EQ(pieceAt(near), 0);
  const int rest = pieceAt(far);
  EXPECT_GT(rest, 0);
  EXPECT_GT(pieceAt(cube), 0);
  EXPECT_NE(pieceAt(cube), rest);
  EXPECT_EQ(pieceAt(speck), -1);
  EXPECT_EQ(view.pieces.pieces[rest].smooth_pixels, 0);
  EXPECT_NEAR(view.pieces.pieces[rest].area_m2, 0.1 * (0.3 - 0.05 - 0.04), 0.0012);

  PiecesConfig config;
  config.min_area_m2 = 0, config.min_pixels = 1;
  view.describePieces(config);
  expectConsistent(view);
  EXPECT_EQ(view.pieces.count(), 4);
  EXPECT_GT(pieceAt(speck), 0);
  for (int i = 0; i < view.frame.size(); ++i) ASSERT_EQ(view.pieces.label(i) >= 0, view.points.mask(i) > 0);

  config.max_reach_m = 0.5;
  view.describePieces(config);
  EXPECT_EQ(pieceAt(far), 0);
  config.max_reach_m = 0.005;
  view.describePieces(config);
  EXPECT_EQ(pieceAt(near), pieceAt(far));
}

TEST(Pieces, NoPathCrossesAStep) {
  // A superpixel on the upper of two boxes one behind the other: the lower one is nearer in the picture than along it.
  const PieceView view(fromAbove({kTable, box({-0.1, 0, 0}, {0, 0.1, 0.1}), box({0, 0, 0}, {0.02, 0.1, 0.05})}),
                       [](int surface, const Eigen::Vector3d& p) { return surface == 1 && p.z() > 0.099; });
  const Eigen::Vector2i low = view.pixelOf({0.015, 0.05, 0.05});
  expectConsistent(view);
  EXPECT_EQ(view.pieces.count(), 2);
  EXPECT_EQ(view.pieces.label(low.y(), low.x()), 1) << "a piece of its own";
}

TEST(Pieces, NoneWithoutObjectPoints) {
  const PieceView view(fromAbove({kTable}), bySurface);
  EXPECT_EQ(view.pieces.count(), 0);
  EXPECT_EQ(cv::countNonZero(view.pieces.label != -1), 0);
  EXPECT_TRUE(view.borders.outlines.empty());
  EXPECT_TRUE(view.borders.pairs.empty());
}
