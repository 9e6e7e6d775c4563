// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "fixtures/piece_view.hpp"
#include "grouping/links.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

constexpr double kFar_m = 0.25;

std::optional<GapCues> cuesOf(const PieceView& view, double max_distance_m = kFar_m) {
  return findGapCues(view.frame, view.table, view.points, view.pieces, outlinePixels(view.pieces, 64), 0, 1,
                     max_distance_m);
}

Scene lowView(std::vector<Surface> surfaces) {
  Scene scene = sceneOf(std::move(surfaces));
  scene.T_world_camera = lookAt({0, -0.8, 0.3}, {0, 0, 0.05});
  return scene;
}

/// Only the fronts (y = at) of a surface left and right of x = 0 are 1 and 2; all else is 3.
Labelling fronts(double at) {
  return [at](int surface, const Eigen::Vector3d& p) {
    return surface > 1 || p.y() > at + 1e-3 ? 3 : p.x() < 0 ? 1 : 2;
  };
}

void expectShares(const GapCues& cues) {
  EXPECT_LE(cues.occluded_share + cues.free_share + cues.surface_share, 1.001);
  EXPECT_GE(cues.best_occluded, cues.occluded_share - 1e-4);
  EXPECT_GE(cues.most_free, cues.free_share - 1e-4);
}

}  // namespace

TEST(GapCues, ABarBehindAPostIsHiddenInBetween) {
  const PieceView view(
      lowView({kTable, box({-0.15, 0.1, 0}, {0.15, 0.15, 0.1}), box({-0.03, -0.1, 0}, {0.03, -0.06, 0.25})}),
      fronts(0.1));
  const auto cues = cuesOf(view);
  ASSERT_TRUE(cues);
  expectShares(*cues);
  EXPECT_GT(cues->occluded_share, 0.9);
  EXPECT_GT(cues->best_occluded, 0.9);
  EXPECT_EQ(cues->free_share, 0);
  EXPECT_EQ(cues->most_free, 0);
  EXPECT_NEAR(cues->cosine, 1, 0.01);
  EXPECT_NEAR(cues->plane_offset, 0, 0.02);
  EXPECT_LT(cues->flush, 1.5);
  EXPECT_NEAR(cues->size_ratio, 1, 0.05);
  // The post's shadow: its width by the distances of bar and post from the camera, in the plane of the ground.
  const double hidden = 0.06 * 0.9 / 0.7, area = view.pieces.pieces[0].area_m2;
  EXPECT_NEAR(cues->distance, hidden / std::sqrt(area), 0.05);
}

TEST(GapCues, BetweenThingsInTheAirIsFreeSpace) {
  const PieceView view(lowView({slab(-1, -0.6, 1, 1.5, 0), box({-0.15, 0, 0.1}, {-0.05, 0.02, 0.14}),
                                box({0.05, 0, 0.1}, {0.15, 0.02, 0.14})}),
                       bySurface);
  const auto cues = cuesOf(view);
  ASSERT_TRUE(cues);
  expectShares(*cues);
  EXPECT_GT(cues->free_share, 0.9);
  EXPECT_EQ(cues->occluded_share, 0);
  EXPECT_NEAR(cues->cosine, 1, 0.02);
}

TEST(GapCues, TheBareTableBetweenLowThingsIsFree) {
  // From above the table lies only 1 cm behind the segments between them: too little to be told by depth.
  Scene scene = sceneOf({kTable, box({-0.15, 0, 0}, {-0.05, 0.05, 0.01}), box({0.05, 0, 0}, {0.15, 0.05, 0.01})});
  scene.T_world_camera = lookAt({0, -0.1, 0.8}, {0, 0, 0});
  PieceView view(scene, bySurface);
  const auto cues = cuesOf(view);
  ASSERT_TRUE(cues);
  expectShares(*cues);
  EXPECT_GT(cues->free_share, 0.9);
  view.points.on_table.setTo(0);
  EXPECT_EQ(cuesOf(view)->free_share, 0);
}

TEST(GapCues, AMeasuredSurfaceInBetweenIsSeen) {
  const PieceView view(lowView({kTable, box({-0.15, 0, 0}, {0.15, 0.1, 0.1})}), [](int, const Eigen::Vector3d& p) {
    return p.y() > 1e-3 || std::abs(p.x()) < 0.05 ? 3 : p.x() < 0 ? 1 : 2;
  });
  const auto cues = cuesOf(view);
  ASSERT_TRUE(cues);
  expectShares(*cues);
  EXPECT_GT(cues->surface_share, 0.9);
  EXPECT_EQ(cues->free_share + cues->occluded_share, 0);
}

TEST(GapCues, FacesOfDifferentPlanes) {
  // Fronts side by side, one 6 cm behind the other; and a top beside a front.
  const PieceView parallel(
      lowView({kTable, box({-0.15, 0, 0}, {-0.05, 0.1, 0.1}), box({0.05, 0.06, 0}, {0.15, 0.16, 0.1})}),
      [](int surface, const Eigen::Vector3d& p) {
        return p.y() > (surface == 1 ? 0 : 0.06) + 1e-3 || std::abs(p.x()) < 0.0505 ? 3 : surface;
      });
  const auto apart = cuesOf(parallel);
  ASSERT_TRUE(apart);
  EXPECT_NEAR(apart->cosine, 1, 0.02);
  EXPECT_NEAR(apart->plane_offset, 0.06 / std::hypot(0.06, 0.2), 0.04);
  EXPECT_NEAR(apart->flush, 60, 6) << "in units of 1 mm of noise";

  const PieceView square(lowView({kTable, box({-0.15, 0, 0}, {-0.05, 0.1, 0.1}), box({0.05, 0, 0}, {0.15, 0.1, 0.1})}),
                         [](int surface, const Eigen::Vector3d& p) {
                           const bool top = p.z() > 0.099, front = p.y() < 1e-3;
                           return surface == 1 ? (front ? 1 : 3) : top ? 2 : 4;
                         });
  const auto bent = cuesOf(square);
  ASSERT_TRUE(bent);
  EXPECT_NEAR(bent->cosine, 0, 0.2) << "normals are rounded off at edges";
}

TEST(GapCues, NoneFartherApartThanAsked) {
  const PieceView view(lowView({kTable, box({-0.15, 0, 0}, {-0.05, 0.1, 0.1}), box({0.05, 0, 0}, {0.15, 0.1, 0.1})}),
                       bySurface);
  EXPECT_FALSE(cuesOf(view, 0.09));
  EXPECT_TRUE(cuesOf(view, 0.11));
}

TEST(GapCues, OutlinesAreEvenSamplesOfTheBorderPixels) {
  const PieceView view(lowView({kTable, box({-0.15, 0, 0}, {-0.05, 0.1, 0.1})}), bySurface);
  const cv::Mat_<int>& label = view.pieces.label;
  const auto all = outlinePixels(view.pieces, 1000000).at(0);
  std::vector<int> expected;
  for (const int i : view.pieces.pieces[0].pixels) {
    if (label(i - 1) || label(i + 1) || label(i - label.cols) || label(i + label.cols)) expected.push_back(i);
  }
  EXPECT_EQ(all, expected);
  const auto some = outlinePixels(view.pieces, 20).at(0);
  EXPECT_EQ(some.size(), 20u);
  EXPECT_TRUE(std::includes(all.begin(), all.end(), some.begin(), some.end()));
}

TEST(Links, ContactsOfPairsThatTouchGapsOfOthersNearEnough) {
  // 0 touches 1; 2 stands 10 cm off; 3 is far from all but 2.
  const PieceView view(lowView({kTable, box({-0.3, 0, 0}, {-0.2, 0.1, 0.1}), box({-0.2, 0, 0}, {-0.1, 0.1, 0.1}),
                                box({0, 0, 0}, {0.1, 0.1, 0.1}), box({0.2, 0, 0}, {0.3, 0.1, 0.1})}),
                       bySurface);
  LinksConfig config;
  config.max_gap_m = 0.15;
  const auto evidence = findPairEvidence(view.frame, view.normals, view.table, view.points, view.superpixels,
                                         view.pieces, view.borders, config);
  std::vector<std::tuple<int, int, bool>> found;
  for (const PairEvidence& pair : evidence) {
    found.emplace_back(pair.first, pair.second, std::holds_alternative<ContactCues>(pair.cues));
  }
  const std::vector<std::tuple<int, int, bool>> expected = {{0, 1, true}, {1, 2, false}, {2, 3, false}};
  EXPECT_EQ(found, expected);

  LearnedObjectness model;
  model.contact.trees = {{{-1, 0, 0, 0, 0.75f}}};
  model.gap.trees = {{{-1, 0, 0, 0, 0.25f}}};
  const std::vector<Link> links = judgePairs(evidence, view.borders, model);
  ASSERT_EQ(links.size(), evidence.size());
  EXPECT_TRUE(links[0].contact);
  EXPECT_EQ(links[0].probability, 0.75f);
  EXPECT_EQ(links[0].contact_length_m, view.borders.pairs.at({0, 1}).contact);
  EXPECT_FALSE(links[1].contact);
  EXPECT_EQ(links[1].probability, 0.25f);
  EXPECT_EQ(links[1].contact_length_m, 0);
}
