// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "fixtures/ray_cast.hpp"
#include "objectness_segmentation/pipeline.hpp"
#include "segments/background.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

/// One segment of each surface but the first, which is the table.
struct Sight {
  Scene scene;
  Frame frame;
  Table table;
  ObjectPoints above;
  std::vector<Segment> segments, background;

  explicit Sight(std::vector<Surface> things) {
    scene.surfaces = {slab(-0.4, -0.3, 0.4, 0.3, 0)};
    scene.surfaces.insert(scene.surfaces.end(), things.begin(), things.end());
    frame = scene.render();
    const Normals normals = estimateNormals(frame, {});
    const Result<Table> found = findTable(frame, normals, {});
    EXPECT_TRUE(found.ok()) << found.status.message;
    table = found.value;
    // No more than what is there: the search for the table lets it go on under what hides its edge.
    for (int row = 0; row < table.extent.cells.rows; ++row) {
      for (int column = 0; column < table.extent.cells.cols; ++column) {
        const Eigen::Vector2d at = table.extent.origin + table.extent.cell_m * Eigen::Vector2d(column + 0.5, row + 0.5);
        const Eigen::Vector3d p =
            scene.T_world_camera * table.T_table_camera.inverse() * Eigen::Vector3d(at.x(), at.y(), 0);
        table.extent.cells(row, column) = std::abs(p.x()) < 0.4 && std::abs(p.y()) < 0.3 ? 255 : 0;
      }
    }
    above.height_m = cv::Mat_<float>(frame.height(), frame.width(), std::nanf(""));
    segments.resize(things.size());
    for (int i = 0; i < frame.size(); ++i) {
      above.height_m(i / frame.width(), i % frame.width()) =
          static_cast<float>(table.normal.dot(frame.points[i].cast<double>()) + table.d);
      if (scene.seen[i] > 0) segments[scene.seen[i] - 1].pixels.push_back(i);
    }
    for (std::size_t k = 0; k < segments.size(); ++k) segments[k].objectness = 1 - 0.1 * static_cast<double>(k);
    background = takeBackground(frame, table, above, segments);
  }
};

/// Whether a thing beside the table is taken that stands where the table may go on, in a picture that is cut.
bool takenBesideTable(const Surface& thing, double cx, double cy) {
  Scene scene;
  scene.surfaces = {slab(-0.4, -0.3, 0.4, 0.3, 0), thing};
  const Normals normals = estimateNormals(scene.render(), {});
  const Result<Table> found = findTable(scene.render(), normals, {});
  EXPECT_TRUE(found.ok()) << found.status.message;
  Table table = found.value;
  const Eigen::Isometry3d T_world_table = scene.T_world_camera * table.T_table_camera.inverse();
  table.extent = {cv::Mat_<uchar>(400, 400, TableExtent::kMargin), Eigen::Vector2d(-2, -2), 0.01};
  for (int row = 0; row < 400; ++row) {
    for (int column = 0; column < 400; ++column) {
      const Eigen::Vector3d p = T_world_table * Eigen::Vector3d(column * 0.01 - 1.995, row * 0.01 - 1.995, 0);
      if (std::abs(p.x()) < 0.4 && std::abs(p.y()) < 0.3) table.extent.cells(row, column) = TableExtent::kCore;
    }
  }
  scene.camera.cx = cx, scene.camera.cy = cy;
  const Frame frame = scene.render();
  ObjectPoints above;
  above.height_m = cv::Mat_<float>(frame.height(), frame.width(), std::nanf(""));
  std::vector<Segment> segments(1);
  for (int i = 0; i < frame.size(); ++i) {
    if (scene.seen[i] != 1) continue;
    above.height_m(i / frame.width(), i % frame.width()) = static_cast<float>(table.height(frame.points[i]));
    segments[0].pixels.push_back(i);
  }
  EXPECT_GT(segments[0].pixels.size(), 500u);
  return !takeBackground(frame, table, above, segments).empty();
}

const Surface kThing = box({-0.05, -0.05, 0}, {0.05, 0.05, 0.1});

}  // namespace

TEST(Background, AnArmFromBesideTheTableAndOutOfThePictureIsTaken) {
  const Sight sight({kThing, box({0.3, -0.05, 0.05}, {1.5, 0.05, 0.12})});
  ASSERT_EQ(sight.segments.size(), 1u);
  EXPECT_EQ(sight.segments[0].objectness, 1);
  ASSERT_EQ(sight.background.size(), 1u);
  EXPECT_EQ(sight.background[0].objectness, 0.9);
}

TEST(Background, AThingThatJutsOutOverTheTableStays) {
  const Sight sight({box({0.3, -0.05, 0}, {0.5, 0.05, 0.1}), kThing});
  EXPECT_EQ(sight.segments.size(), 2u);
  EXPECT_TRUE(sight.background.empty());
}

TEST(Background, AThingOnTheTableThatThePictureCutsStays) {
  Sight sight({kThing});
  // The picture ends in the middle of the thing.
  const double half = 0.5 * sight.frame.width();
  Scene shifted = sight.scene;
  shifted.camera.cx -= half - 5;
  Frame frame = shifted.render();
  Segment cut;
  ObjectPoints above;
  above.height_m = cv::Mat_<float>(frame.height(), frame.width(), 0.1f);
  for (int i = 0; i < frame.size(); ++i) {
    if (shifted.seen[i] == 1) cut.pixels.push_back(i);
  }
  ASSERT_FALSE(cut.pixels.empty());
  std::vector<Segment> segments{cut};
  EXPECT_TRUE(takeBackground(frame, sight.table, above, segments).empty());
  // No higher than the table bends at the end of the picture.
  above.height_m = 0.012f;
  EXPECT_EQ(takeBackground(frame, sight.table, above, segments).size(), 1u);
  EXPECT_TRUE(segments.empty());
}

TEST(Background, WhatLeavesThePictureAndComesDownNowhereIsTaken) {
  const double cx = 379.5, cy = 239.5;  // the picture ends 10 cm beside the table
  EXPECT_TRUE(takenBesideTable(box({0.43, -0.1, 0.08}, {1.5, 0.1, 0.12}), cx, cy)) << "the rim of a bin";
  EXPECT_FALSE(takenBesideTable(box({0.43, -0.1, 0}, {1.5, 0.1, 0.12}), cx, cy)) << "stands there";
}

TEST(Background, WhatHasItsFootOutOfThePictureStays) {
  // Before the table; the picture ends in the middle of its front side.
  EXPECT_FALSE(takenBesideTable(box({-0.1, -0.4, 0}, {0.1, -0.32, 0.12}), 319.5, 170));
}

TEST(Background, NothingIsTakenOfNothing) {
  const Sight sight({});
  EXPECT_TRUE(sight.segments.empty());
  EXPECT_TRUE(sight.background.empty());
}

TEST(Background, ThePipelinePublishesItWhenItIsNotJudged) {
  Scene scene;
  scene.surfaces = {slab(-0.4, -0.3, 0.4, 0.3, 0), kThing, box({0.3, -0.05, 0.05}, {1.5, 0.05, 0.12})};
  scene.s0 = 0.0003, scene.s2 = 0.0008;
  const Frame frame = scene.render();
  Config config;
  config.object_points.min_inside_share = 0;
  const Segmentation judged = segment(frame, config);
  config.background.judged = false;
  const Segmentation all = segment(frame, config);
  ASSERT_TRUE(judged.status.ok() && all.status.ok());
  EXPECT_EQ(judged.report.background, all.segments.size() - judged.segments.size());
  EXPECT_FALSE(all.report.background);
}
