// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "common/angles.hpp"
#include "evaluation/box_fits.hpp"
#include "evaluation/box_overlap.hpp"
#include "evaluation/box_tables.hpp"
#include "fixtures/cue_view.hpp"
#include "fixtures/figure.hpp"

using namespace objectness;
using namespace objectness::evaluation;
using namespace objectness_test;
using Eigen::AngleAxisd;
using Eigen::Vector3d;

namespace {

const Vector3d kUp = Vector3d::UnitZ();

OrientedBox boxAt(const Vector3d& centre, const Vector3d& size, double yaw_deg = 0) {
  OrientedBox box;
  box.T_camera_box.translation() = centre;
  box.T_camera_box.rotate(AngleAxisd(yaw_deg * kDegree, kUp));
  box.size_m = size;
  return box;
}

/// Intersection over union of a square and itself turned about its centre: the common part is an octagon of 2 / (1 +
/// sin + cos) of its area.
double overlapOfTurnedSquare(double angle_deg) {
  const double shared = 2 / (1 + std::sin(angle_deg * kDegree) + std::cos(angle_deg * kDegree));
  return shared / (2 - shared);
}

void expectSides(const BoxErrors& errors, double longer_mm, double shorter_mm, double height_mm) {
  EXPECT_NEAR(errors.sides_mm[0], longer_mm, 1e-6);
  EXPECT_NEAR(errors.sides_mm[1], shorter_mm, 1e-6);
  EXPECT_NEAR(errors.sides_mm[2], height_mm, 1e-6);
}

}  // namespace

TEST(BoxFits, TheSameBoxByAnyNamesOfItsAxes) {
  const Vector3d size(0.1, 0.06, 0.2);
  const OrientedBox truth = boxAt({0.1, 0.2, 0.8}, size, 20);
  const Vector3d axes[] = {Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ()};
  for (const Vector3d& axis : axes) {
    for (const double turn_deg : {0, 90, 180, 270}) {
      OrientedBox found = truth;
      const AngleAxisd turn(turn_deg * kDegree, axis);
      found.T_camera_box.rotate(turn);
      found.size_m = (turn.inverse().toRotationMatrix() * size).cwiseAbs();
      const BoxErrors errors = compareBoxes(found, truth, false, kUp);
      EXPECT_NEAR(errors.overlap, 1, 1e-6);
      EXPECT_NEAR(errors.centre_mm, 0, 1e-6);
      EXPECT_NEAR(errors.yaw_deg.value(), 0, 1e-5);
      expectSides(errors, 0, 0, 0);
    }
  }
}

TEST(BoxFits, ShiftTurnAndSidesAreThoseMade) {
  const OrientedBox truth = boxAt({0, 0, 0}, {0.1, 0.06, 0.2});
  const BoxErrors shifted = compareBoxes(boxAt({0.01, 0, 0}, truth.size_m), truth, false, kUp);
  EXPECT_NEAR(shifted.overlap, 0.09 / 0.11, 1e-6);
  EXPECT_NEAR(shifted.centre_mm, 10, 1e-9);
  expectSides(shifted, 0, 0, 0);

  // Longer in x, shorter in y, higher: one within the other but for y.
  const BoxErrors sized = compareBoxes(boxAt({0, 0, 0}, {0.12, 0.05, 0.25}), truth, false, kUp);
  const double shared = 0.1 * 0.05 * 0.2, all = 0.12 * 0.05 * 0.25 + 0.1 * 0.06 * 0.2 - shared;
  EXPECT_NEAR(sized.overlap, shared / all, 1e-6);
  expectSides(sized, 20, -10, 50);

  for (const double turn_deg : {-30., 10., 44.}) {
    const BoxErrors turned = compareBoxes(boxAt({0, 0, 0}, truth.size_m, turn_deg), truth, false, kUp);
    EXPECT_NEAR(turned.yaw_deg.value(), std::abs(turn_deg), 1e-6);
    expectSides(turned, 0, 0, 0);
  }
  // A turn by 70 degrees is the same box as one by -20 with the sides exchanged.
  const BoxErrors crossed = compareBoxes(boxAt({0, 0, 0}, truth.size_m, 70), truth, false, kUp);
  EXPECT_NEAR(crossed.yaw_deg.value(), 20, 1e-6);
  expectSides(crossed, -40, 40, 0);
}

TEST(BoxFits, YawIsAboutTheVerticalOnly) {
  const OrientedBox truth = boxAt({0, 0, 0}, {0.1, 0.06, 0.2});
  OrientedBox tilted = truth;
  tilted.T_camera_box.rotate(AngleAxisd(15 * kDegree, Vector3d::UnitX()));
  EXPECT_NEAR(compareBoxes(tilted, truth, false, kUp).yaw_deg.value(), 0, 1e-6);
  EXPECT_NEAR(compareBoxes(tilted, truth, false, Vector3d::UnitX()).yaw_deg.value(), 15, 1e-6);
}

TEST(BoxFits, RoundThingsMayBeTurnedAboutTheirAxis) {
  const OrientedBox truth = boxAt({0, 0, 0}, {0.1, 0.1, 0.2});
  for (const double turn_deg : {0., 7., 45., 101.3}) {
    const OrientedBox found = boxAt({0, 0, 0}, truth.size_m, turn_deg);
    const BoxErrors round = compareBoxes(found, truth, true, kUp);
    EXPECT_NEAR(round.overlap, 1, 1e-3) << turn_deg;
    EXPECT_FALSE(round.yaw_deg.has_value());
    const BoxErrors edged = compareBoxes(found, truth, false, kUp);
    const double turn = std::abs(std::remainder(turn_deg, 90));
    EXPECT_NEAR(edged.overlap, overlapOfTurnedSquare(turn), 1e-6) << turn_deg;
    EXPECT_NEAR(edged.yaw_deg.value(), turn, 1e-6) << turn_deg;
  }
  // One that lies on its side, found turned about its own axis, which is the camera's x.
  OrientedBox lying = truth;
  lying.T_camera_box.rotate(AngleAxisd(90 * kDegree, Vector3d::UnitY()));
  OrientedBox rolled = lying;
  rolled.T_camera_box.rotate(AngleAxisd(33 * kDegree, Vector3d::UnitZ()));
  EXPECT_NEAR(compareBoxes(rolled, lying, true, kUp).overlap, 1, 1e-3);
  EXPECT_LT(compareBoxes(rolled, lying, false, kUp).overlap, 0.9);
  // A turn about the vertical is none of its symmetries.
  OrientedBox aside = lying;
  aside.T_camera_box.linear() = AngleAxisd(40 * kDegree, kUp) * aside.T_camera_box.linear();
  EXPECT_LT(compareBoxes(aside, lying, true, kUp).overlap, 0.6);
}

TEST(BoxFits, NoTurnOfARoundThingOverlapsMore) {
  const OrientedBox truth = boxAt({0, 0, 0}, {0.1, 0.1, 0.2}),
                    found = boxAt({0.03, 0.01, 0.02}, {0.05, 0.11, 0.15}, 25);
  double best = 0;
  for (double turn_deg = 0; turn_deg < 180; turn_deg += 0.05) {
    best = std::max(best, boxOverlap(found, boxAt({0, 0, 0}, truth.size_m, turn_deg)));
  }
  EXPECT_NEAR(compareBoxes(found, truth, true, kUp).overlap, best, 1e-4);
}

namespace {

/// Two boxes on a table, found as they are but for what a test changes.
class MeasuredFits : public testing::Test {
 protected:
  MeasuredFits() : view_(sceneOf({kTable, box({-0.2, 0, 0}, {-0.05, 0.1, 0.12}), box({0.1, 0, 0}, {0.2, 0.2, 0.06})})) {
    labels_ = cv::Mat_<ushort>(view_.frame.height(), view_.frame.width(), ushort{0});
    found_.table = view_.table;
    found_.segments.resize(2);
    found_.labels = labels_.clone();
    for (int i = 0; i < view_.frame.size(); ++i) {
      const int surface = view_.scene.seen[i];
      if (surface == 0) labels_(i) = 1;
      if (surface <= 0) continue;
      labels_(i) = static_cast<ushort>(10 * (surface + 1));
      found_.labels(i) = static_cast<ushort>(1 + surface);
      found_.segments[surface - 1].pixels.push_back(i);
    }
    truth_ = {{0, modelBox({-0.2, 0, 0}, {-0.05, 0.1, 0.12}), "box"}, {1, modelBox({0.1, 0, 0}, {0.2, 0.2, 0.06}), ""}};
  }
  OrientedBox modelBox(const Vector3d& low, const Vector3d& high) const {
    return {view_.scene.T_world_camera.inverse() * Eigen::Translation3d((low + high) / 2), high - low};
  }
  std::vector<BoxFit> fits() const { return measureBoxFits(view_.frame, found_, labels_, truth_); }

  CueView view_;
  cv::Mat_<ushort> labels_;
  Segmentation found_;
  std::vector<TrueBox> truth_;
};

}  // namespace

TEST_F(MeasuredFits, BoxesOfSegmentsAndOfTheirPoints) {
  found_.segments[0].box = truth_[0].box;
  const std::vector<BoxFit> found = fits();
  ASSERT_EQ(found.size(), 2u);
  for (const BoxFit& fit : found) {
    EXPECT_EQ(fit.dice, 1);
    EXPECT_TRUE(fit.isSegmented());
    // Top and front of a box tell all of it; the picture's pixels end within it.
    EXPECT_GT(fit.points_overlap, 0.85);
    EXPECT_LT(fit.points_overlap, 1);
  }
  EXPECT_EQ(found[0].kind, "box");
  EXPECT_NEAR(found[0].errors.overlap, 1, 1e-6);
  EXPECT_NEAR(found[1].errors.overlap, found[1].points_overlap, 1e-12) << "a segment without a box";
  EXPECT_LT(found[1].errors.yaw_deg.value(), 2);
  EXPECT_LT(found[1].errors.sides_mm.cwiseAbs().maxCoeff(), 10);
}

TEST_F(MeasuredFits, ObjectsWithoutASegmentOfTheirOwn) {
  found_.labels.setTo(2, found_.labels == 3);  // both are one segment, which is the larger one's
  auto& pixels = found_.segments[0].pixels;
  pixels.insert(pixels.end(), found_.segments[1].pixels.begin(), found_.segments[1].pixels.end());
  found_.segments.resize(1);
  found_.segments[0].box = truth_[0].box;
  const std::vector<BoxFit> found = fits();
  ASSERT_EQ(found.size(), 2u);
  const BoxFit& lost = found[0].dice == 0 ? found[0] : found[1];
  EXPECT_EQ(lost.dice, 0);
  EXPECT_FALSE(lost.isSegmented());
  EXPECT_EQ(lost.errors.overlap, 0);
  EXPECT_EQ(lost.points_overlap, 0);
  EXPECT_GT(std::max(found[0].dice, found[1].dice), 0.5);
}

TEST(BoxTables, MeansOfObjectsSegmentedByGroupAndKind) {
  objectness::evaluation::Run run;
  run.methods = {{"paper", "", ""}, {"lccp", "", ""}};
  run.scenes = {{"a", "easy"}, {"b", "all"}};
  const auto fit = [](const char* kind, double dice, double overlap, std::optional<double> yaw_deg, double side_mm) {
    BoxFit fit;
    fit.kind = kind;
    fit.dice = dice;
    fit.errors.overlap = overlap;
    fit.errors.yaw_deg = yaw_deg;
    fit.errors.sides_mm = {side_mm, 0, -side_mm};
    fit.points_overlap = overlap / 2;
    return fit;
  };
  std::vector<SceneResult> results(2);
  results[0].scene = "a";
  results[1].scene = "b";
  for (SceneResult& result : results) result.method = "paper";
  results[0].box_fits = {fit("box", 0.9, 0.8, 10, -20), fit("mug", 0.75, 0.4, 40, 8)};  // the mug is not segmented
  results[1].box_fits = {fit("box", 0.8, 0.6, {}, 9)};
  const std::vector<BoxRow> rows = summarizeBoxes(run, results);
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[0].by, "all");
  EXPECT_EQ(figure(rows[0].columns, "objects"), 3);
  EXPECT_EQ(figure(rows[0].columns, "segmented"), 2);
  EXPECT_NEAR(figure(rows[0].columns, "IoU_all"), 0.6, 1e-12);
  EXPECT_NEAR(figure(rows[0].columns, "IoU"), 0.7, 1e-12);
  EXPECT_NEAR(figure(rows[0].columns, "IoU50"), 1, 1e-12);
  EXPECT_NEAR(figure(rows[0].columns, "IoU70"), 0.5, 1e-12);
  EXPECT_NEAR(figure(rows[0].columns, "points_IoU"), 0.35, 1e-12);
  EXPECT_NEAR(figure(rows[0].columns, "yaw_deg"), 10, 1e-12);
  EXPECT_NEAR(figure(rows[0].columns, "long_mm"), 14.5, 1e-12);
  EXPECT_NEAR(figure(rows[0].columns, "height_mm"), 14.5, 1e-12);
  EXPECT_NEAR(figure(rows[0].columns, "sides_10mm"), 0.5, 1e-12);
  EXPECT_EQ(rows[1].by + " " + rows[1].name, "group easy");
  EXPECT_EQ(rows[2].by + " " + rows[2].name, "kind box");
  EXPECT_EQ(figure(rows[2].columns, "objects"), 2);
  EXPECT_EQ(rows[3].name, "mug");
  EXPECT_EQ(figure(rows[3].columns, "segmented"), 0);
  EXPECT_NEAR(figure(rows[3].columns, "IoU_all"), 0.4, 1e-12);
  EXPECT_NE(toText(rows).find("paper      kind       mug"), std::string::npos) << toText(rows);
  EXPECT_TRUE(toText(std::vector<BoxRow>{}).empty());
}
