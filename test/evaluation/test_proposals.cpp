// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "evaluation/proposals.hpp"
#include "fixtures/demo_images.hpp"
#include "objectness_segmentation/io/scene_folder.hpp"
#include "objectness_segmentation/pipeline.hpp"

using namespace objectness;
using namespace objectness::evaluation;
using Eigen::Vector3d;

namespace {

OrientedBox cube(double x, double side = 0.1) {
  OrientedBox box;
  box.T_camera_box.translation() = Vector3d(x, 0, 1);
  box.size_m = Vector3d::Constant(side);
  return box;
}

/// One row of pixels along x, a centimetre apart, at (x, 0, 1); all of them stand on the table.
struct Row {
  Frame frame;
  Segmentation result;
  cv::Mat_<ushort> labels;

  explicit Row(const std::vector<int>& label_of_pixel) : labels(1, static_cast<int>(label_of_pixel.size())) {
    const int count = labels.cols;
    frame.camera = {100, 100, 0, 0, count, 1};
    for (int i = 0; i < count; ++i) {
      frame.points.emplace_back(0.01f * i, 0.f, 1.f);
      labels(i) = static_cast<ushort>(label_of_pixel[i]);
    }
    result.object_points.mask = cv::Mat_<uchar>(1, count, static_cast<uchar>(255));
  }
};

}  // namespace

TEST(BoxRecall, CountsTrueBoxesThatOneOfTheFirstOverlaps) {
  // Boxes of one size overlap by (1 - s) / (1 + s) when they are shifted by s of it.
  const std::vector<TrueBox> truth{{2, cube(0)}, {3, cube(1)}, {4, cube(2)}, {5, cube(3)}};
  std::vector<OrientedBox> boxes{cube(0.03), cube(9), cube(1.01), cube(9), cube(9), cube(0.001)};  // 0.54, 0, 0.82, ...
  boxes.resize(15, cube(9));
  boxes.push_back(cube(2.035));  // 0.48
  boxes.resize(150, cube(9));
  boxes.push_back(cube(3));  // beyond all that are kept
  const BoxRecall recall = boxRecall(boxes, truth);
  EXPECT_EQ(recall.at_50, (std::array<double, 5>{0.25, 0.5, 0.5, 0.5, 0.5}));
  EXPECT_EQ(recall.at_70, (std::array<double, 5>{0, 0.25, 0.5, 0.5, 0.5}));
  EXPECT_EQ(boxRecall({}, truth).at_50.back(), 0);
  EXPECT_EQ(boxRecall(boxes, {}).at_50.back(), 0);
}

TEST(FixedBoxes, AreTheSameListWhateverItsLength) {
  Table table;
  table.T_table_camera = Eigen::Translation3d(0.3, -0.2, 0.9) * Eigen::AngleAxisd(2, Vector3d::UnitX());
  const Footprint footprint{{-0.5, -0.2}, {0.4, 0.5}};
  const auto few = fixedBoxes(table, footprint, 10), many = fixedBoxes(table, footprint, 100);
  ASSERT_EQ(many.size(), 100u);
  for (std::size_t i = 0; i < few.size(); ++i) {
    EXPECT_TRUE(few[i].T_camera_box.matrix() == many[i].T_camera_box.matrix());
    EXPECT_EQ(few[i].size_m, many[i].size_m);
  }
}

TEST(FixedBoxes, StandOnTheTableWithinTheFootprintAndFillIt) {
  Table table;
  table.T_table_camera = Eigen::Translation3d(0.3, -0.2, 0.9) * Eigen::AngleAxisd(2, Vector3d::UnitX());
  const Footprint footprint{{-0.5, -0.2}, {0.4, 0.5}};
  int quadrants[2][2] = {};
  for (const OrientedBox& box : fixedBoxes(table, footprint, 100)) {
    const Eigen::Isometry3d T_table_box = table.T_table_camera * box.T_camera_box;
    const Vector3d at = T_table_box.translation();
    EXPECT_NEAR(at.z(), 0.5 * box.size_m.z(), 1e-9);
    EXPECT_NEAR(T_table_box.linear()(2, 2), 1, 1e-9);
    for (const int i : {-1, 1}) {
      for (const int j : {-1, 1}) {
        const Vector3d corner = T_table_box * (0.5 * Vector3d(i, j, 1).cwiseProduct(box.size_m));
        EXPECT_TRUE((corner.head<2>().array() > footprint.low.array() - 1e-9).all()) << corner.transpose();
        EXPECT_TRUE((corner.head<2>().array() < footprint.high.array() + 1e-9).all()) << corner.transpose();
      }
    }
    ++quadrants[at.x() > -0.05][at.y() > 0.15];
  }
  for (const auto& row : quadrants) {
    for (const int count : row) EXPECT_GT(count, 18);
  }
}

TEST(FixedBoxes, AFootprintWithoutRoomHasThemInItsMiddle) {
  for (const OrientedBox& box : fixedBoxes(Table(), {{0.1, 0.2}, {0.1, 0.2}}, 5)) {
    EXPECT_TRUE(box.T_camera_box.translation().head<2>().isApprox(Eigen::Vector2d(0.1, 0.2)));
  }
}

TEST(BestBox, ItsPointsAgainstTheObjectThatHasMostOfThem) {
  //           0   1  2   3   4   5   6   7   8   9  cm
  Row row({20, 20, 20, 21, 30, 30, 1, 0, 0, 30});
  row.result.proposals = {{cube(0.045, 0.074), 1.2}, {cube(0, 1), 1.0}};  // the first holds pixels 1 to 8
  ProposalMetrics figures = measureProposals(row.frame, row.result, row.labels, {}, 0);
  EXPECT_DOUBLE_EQ(figures.best_box_precision, 3.0 / 6) << "void does not count, the table does";
  EXPECT_DOUBLE_EQ(figures.best_box_recall, 3.0 / 4);
  figures = measureProposals(row.frame, row.result, row.labels, {}, 0.011);  // and now 0 to 9
  EXPECT_DOUBLE_EQ(figures.best_box_precision, 4.0 / 8);
  EXPECT_DOUBLE_EQ(figures.best_box_recall, 1);
  row.result.object_points.mask(2) = 0;
  figures = measureProposals(row.frame, row.result, row.labels, {}, 0);
  EXPECT_DOUBLE_EQ(figures.best_box_recall, 2.0 / 4) << "only points above the table are in a box";
}

TEST(BestBox, OfBackgroundOrNoneIsWorthNothing) {
  Row row({20, 20, 1, 1});
  ProposalMetrics figures = measureProposals(row.frame, row.result, row.labels, {}, 0);
  EXPECT_EQ(figures.proposals, 0);
  EXPECT_EQ(figures.best_box_recall, 0);
  row.result.proposals = {{cube(0.03, 0.025), 1}};
  figures = measureProposals(row.frame, row.result, row.labels, {}, 0);
  EXPECT_EQ(figures.best_box_precision, 0);
  EXPECT_EQ(figures.best_box_recall, 0);
}

TEST(Proposals, OfTheDemoSceneHoldItsObjects) {
  const SceneImages scene = demoImages(1);
  Config config;
  config.pipeline.method = SegmentationMethod::kPaper;
  config.search.angle_step_deg = 15;
  const auto frame = makeFrame(scene.depth_mm, scene.color, scene.camera, config.input);
  const Segmentation result = segment(frame.value, config);
  ASSERT_TRUE(result.status.ok());
  ASSERT_FALSE(result.proposals.empty());
  for (std::size_t i = 1; i < result.proposals.size(); ++i) {
    EXPECT_LE(result.proposals[i].objectness, result.proposals[i - 1].objectness);
  }
  EXPECT_EQ(result.report.hypotheses, result.proposals.size());
  const auto truth = fitTrueBoxes(frame.value, result.table, scene.true_labels);
  const ProposalMetrics figures =
      measureProposals(frame.value, result, scene.true_labels, truth, config.filter.box_margin_m);
  EXPECT_EQ(figures.objects, 6);
  EXPECT_GE(figures.objectness.at_50.back(), 0.8);
  EXPECT_GT(figures.objectness.at_50.back(), figures.fixed.at_50.back());
  EXPECT_GT(figures.best_box_precision, 0.9);
  EXPECT_GT(figures.best_box_recall, 0.7);
}
