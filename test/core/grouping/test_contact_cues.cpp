// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "fixtures/piece_view.hpp"
#include "grouping/contact_cues.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

ContactCues cuesOf(const PieceView& view) {
  return findContactCues(view.frame, view.normals, view.table, view.superpixels, view.pieces, view.borders, 0, 1);
}

/// Superpixels end a centimetre before the edges of their faces, as findSuperpixels() ends them.
bool clear(double x, double edge) { return std::abs(x - edge) > 0.012; }

Eigen::Isometry3d turned(double yaw_deg) {
  return Eigen::Isometry3d(Eigen::AngleAxisd(yaw_deg * M_PI / 180, Eigen::Vector3d::UnitZ()));
}

/// Two boxes whose fronts meet at x = 0 in a ridge (yaw < 0) or a valley (yaw > 0) of twice the yaw.
PieceView folded(double yaw_deg, double noise_m = 0) {
  Scene scene = sceneOf({kTable, moved(box({-0.14, 0, 0}, {0, 0.1, 0.15}), turned(yaw_deg)),
                         moved(box({0, 0, 0}, {0.14, 0.1, 0.15}), turned(-yaw_deg))});
  scene.T_world_camera = lookAt({0, -0.8, 0.1}, {0, 0, 0.07});  // too low to see the tops
  scene.s0 = noise_m;
  return PieceView(scene, [](int surface, const Eigen::Vector3d& p) { return clear(p.x(), 0) ? surface : 0; });
}

}  // namespace

TEST(ContactCues, FoldsHaveTheirSignedAngle) {
  for (const double yaw : {-35.0, -20.0, -10.0, 0.0, 10.0, 20.0, 35.0}) {
    SCOPED_TRACE(yaw);
    const ContactCues cues = cuesOf(folded(yaw));
    EXPECT_NEAR(cues.angle_median_deg, -2 * yaw, 2);
    EXPECT_LE(cues.angle_low_deg, cues.angle_median_deg);
    EXPECT_GE(cues.angle_high_deg, cues.angle_median_deg);
    EXPECT_NEAR(cues.concave_share, yaw > 0, 0.05);
    EXPECT_NEAR(cues.convex_share, yaw < 0, 0.05);
    EXPECT_NEAR(cues.contact_share, 1, 0.02);
    EXPECT_NEAR(cues.size_ratio, 1, 0.05);
    EXPECT_NEAR(cues.upper_upright, 0, 0.05);
    EXPECT_NEAR(cues.lower_upright, 0, 0.05);
    EXPECT_LT(cues.step, 1) << "both planes go through the border";
  }
}

TEST(ContactCues, NoiseBlursAnglesLittle) {
  const ContactCues cues = cuesOf(folded(20, 0.001));
  EXPECT_NEAR(cues.angle_median_deg, -40, 5);
  EXPECT_LT(cues.angle_high_deg, -20);
}

TEST(ContactCues, TheEdgeOfABoxIsConvex) {
  const PieceView view(sceneOf({kTable, box({-0.1, 0, 0}, {0.1, 0.1, 0.12})}), [](int, const Eigen::Vector3d& p) {
    const bool top = p.z() > 0.119;
    return clear(p.y(), 0) && top ? 1 : clear(p.z(), 0.12) && !top ? 2 : 0;
  });
  ASSERT_EQ(view.pieces.count(), 2);
  const ContactCues cues = cuesOf(view);
  EXPECT_NEAR(cues.angle_median_deg, 90, 3);
  EXPECT_NEAR(cues.convex_share, 1, 0.05);
  EXPECT_EQ(cues.concave_share, 0);
  EXPECT_NEAR(cues.upper_upright, 1, 0.03) << "the top";
  EXPECT_NEAR(cues.lower_upright, 0, 0.03) << "the front";
  EXPECT_LT(cues.step, 1);
}

TEST(ContactCues, ABoxOnABoxIsConcave) {
  // The top of the lower one and the front of the upper one; the rest is of no interest.
  const Scene scene = sceneOf({kTable, box({-0.1, -0.1, 0}, {0.1, 0.1, 0.05}), box({-0.1, 0, 0.05}, {0.1, 0.1, 0.15})});
  const PieceView view(scene, [](int surface, const Eigen::Vector3d& p) {
    if (surface == 1 && p.z() > 0.049) return clear(p.y(), 0) ? 2 : 0;
    if (surface == 2 && p.y() < 0.001) return clear(p.z(), 0.05) ? 1 : 0;
    return p.z() > 0.1 ? 3 : 4;
  });
  const ContactCues cues = cuesOf(view);
  EXPECT_NEAR(cues.angle_median_deg, -90, 3);
  EXPECT_NEAR(cues.concave_share, 1, 0.05);
  EXPECT_EQ(cues.convex_share, 0);
  EXPECT_NEAR(cues.upper_upright, 0, 0.03);
  EXPECT_NEAR(cues.lower_upright, 1, 0.03);
  EXPECT_NEAR(cues.contact_share, 1, 0.02);
  const double edge = view.seenLength({-0.1, 0, 0.05}, {0.1, 0, 0.05});
  const double upper = 2 * (edge + view.seenLength({0.1, 0, 0.05}, {0.1, 0, 0.15}));
  EXPECT_NEAR(cues.contact_of_outline, edge / upper, 0.05);
}

TEST(ContactCues, ParallelFacesHaveAStep) {
  // Fronts 8 mm apart in depth, 8 times the noise; the nearer one's side is hidden from straight in front of it.
  Scene scene = sceneOf({kTable, box({-0.14, 0, 0}, {0, 0.1, 0.15}), box({0, 0.008, 0}, {0.14, 0.1, 0.15})});
  scene.T_world_camera = lookAt({0, -0.8, 0.1}, {0, 0, 0.07});
  const PieceView view(scene, [](int surface, const Eigen::Vector3d& p) { return clear(p.x(), 0) ? surface : 0; });
  const ContactCues cues = cuesOf(view);
  EXPECT_NEAR(cues.angle_median_deg, 0, 2);
  EXPECT_NEAR(cues.step, 8, 1);
}

TEST(ContactCues, TheOrderOfThePiecesDoesNotCount) {
  const Scene scene =
      sceneOf({kTable, box({-0.1, -0.1, 0}, {0.1, 0.1, 0.05}), box({-0.05, 0, 0.05}, {0.05, 0.1, 0.15})});
  const auto labelled = [&](bool swap) {
    return PieceView(scene, [swap](int surface, const Eigen::Vector3d& p) {
      return !clear(p.y(), 0) && p.z() < 0.062 && p.z() > 0.049 ? 0 : swap ? 3 - surface : surface;
    });
  };
  const ContactCues one = cuesOf(labelled(false)), other = cuesOf(labelled(true));
  EXPECT_NEAR(one.angle_median_deg, other.angle_median_deg, 3);
  EXPECT_NEAR(one.contact_share, other.contact_share, 0.02);
  EXPECT_NEAR(one.contact_of_outline, other.contact_of_outline, 0.02);
  EXPECT_NEAR(one.upper_upright, other.upper_upright, 0.05);
  EXPECT_NEAR(one.lower_upright, other.lower_upright, 0.05);
  EXPECT_FLOAT_EQ(one.size_ratio, other.size_ratio);
}
