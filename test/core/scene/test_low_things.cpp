// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "fixtures/ray_cast.hpp"
#include "objectness_segmentation/scene/object_points.hpp"

using namespace objectness;
using namespace objectness_test;
using Eigen::Vector3d;

namespace {

/// A table that is not flat to the sensor: waves across x of that height.
Surface wavyTable(double amplitude_m, double length_m) {
  return [=](const Vector3d& o, const Vector3d& d) {
    double t = -o.z() / d.z();
    for (int round = 0; round < 20; ++round) {
      const double x = o.x() + t * d.x();
      t = (amplitude_m * std::sin(2 * M_PI * x / length_m) - o.z()) / d.z();
    }
    const Vector3d p = o + t * d;
    return t > 0 && std::abs(p.x()) < 0.5 && std::abs(p.y()) < 0.4 ? t : kMiss;
  };
}

/// The object points of a scene whose first surface is the table.
struct View {
  Scene scene;
  Frame frame;
  ObjectPoints points;

  View(std::vector<Surface> surfaces, double s0, double s2, bool low_things, int threads = 1) {
    scene.surfaces = std::move(surfaces);
    scene.s0 = s0, scene.s2 = s2;
    frame = scene.render();
    const Normals normals = estimateNormals(frame, {});
    const Result<Table> table = findTable(frame, normals, {});
    EXPECT_TRUE(table.ok()) << table.status.message;
    ObjectPointsConfig config;
    config.low_things = low_things;
    points = findObjectPoints(frame, normals, table.value, config, threads);
  }

  double masked(int surface) const {
    int all = 0, in = 0;
    for (int i = 0; i < frame.size(); ++i) {
      if (scene.seen[i] != surface) continue;
      ++all;
      in += points.mask(i / frame.width(), i % frame.width()) != 0;
    }
    return all == 0 ? 0 : double(in) / all;
  }
};

const Surface kTable = slab(-0.5, -0.4, 0.5, 0.4, 0), kPlate = slab(-0.1, -0.1, 0.1, 0.1, 0.009);

}  // namespace

TEST(LowThings, APlateWithinTheNoiseOfAPixelIsSeenWhole) {
  const View without({kTable, kPlate}, 0.002, 0.004, false), with({kTable, kPlate}, 0.002, 0.004, true);
  EXPECT_LT(without.masked(1), 0.5) << "then the noise is not what this test is about";
  EXPECT_GT(with.masked(1), 0.9);
  EXPECT_LT(with.masked(0), 0.01);
}

TEST(LowThings, ABareTableStaysBare) {
  for (const double noise : {0.0, 1.0, 4.0}) {
    SCOPED_TRACE(noise);
    const View view({kTable}, 0.0005 * noise, 0.001 * noise, true);
    EXPECT_LT(view.masked(0), 1e-4);
  }
}

TEST(LowThings, WhatTheWholeTableDoesIsNoThing) {
  const View view({wavyTable(0.006, 0.6)}, 0.0005, 0.001, true);
  EXPECT_LT(view.masked(0), 0.001);
}

TEST(LowThings, TheFootOfATallThingStaysTable) {
  const Surface tall = box({-0.1, -0.05, 0}, {0.1, 0.05, 0.2});
  const View without({kTable, tall}, 0.0005, 0.001, false), with({kTable, tall}, 0.0005, 0.001, true);
  EXPECT_NEAR(with.masked(0), without.masked(0), 5e-4);
  EXPECT_GE(with.masked(1), without.masked(1));
}

TEST(LowThings, LessThanTheLeastHeightIsTable) {
  const View view({kTable, slab(-0.1, -0.1, 0.1, 0.1, 0.0025)}, 0.0002, 0.0005, true);
  EXPECT_LT(view.masked(1), 0.05);
}

TEST(LowThings, DoNotDependOnTheThreads) {
  const View one({kTable, kPlate}, 0.002, 0.004, true, 1), four({kTable, kPlate}, 0.002, 0.004, true, 4);
  EXPECT_EQ(cv::countNonZero(one.points.mask != four.points.mask), 0);
  EXPECT_EQ(cv::countNonZero(one.points.on_table != four.points.on_table), 0);
}
