// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "fixtures/ray_cast.hpp"
#include "objectness_segmentation/scene/object_points.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

const float kNan = std::numeric_limits<float>::quiet_NaN();

/// A rendered scene with its object points, and how many pixels of each surface they hold. The first surface has no
/// depth behind `depth_ends_y`, as a shiny table far from the camera.
struct View {
  explicit View(std::vector<Surface> surfaces, ObjectPointsConfig config = {}, double noise = 1,
                double depth_ends_y = kMiss) {
    scene.surfaces = std::move(surfaces);
    scene.s0 = 0.0005 * noise, scene.s2 = 0.0015 * noise;
    frame = scene.render();
    for (int i = 0; i < frame.size(); ++i) {
      const bool behind = (scene.T_world_camera * frame.points[i].cast<double>()).y() > depth_ends_y;
      if (scene.seen[i] == 0 && behind) frame.points[i].setConstant(kNan);
    }
    const Normals normals = estimateNormals(frame, {});
    const Result<Table> found = findTable(frame, normals, {});
    EXPECT_TRUE(found.ok()) << found.status.message;
    table = found.value;
    points = findObjectPoints(frame, normals, table, config);
  }
  double share(int surface, const cv::Mat_<uchar>& mask) const {
    int all = 0, in = 0;
    for (int i = 0; i < frame.size(); ++i) {
      if (scene.seen[i] != surface || !(frame.points[i].z() > 0)) continue;
      ++all;
      in += mask.data[i] != 0;
    }
    return double(in) / std::max(1, all);
  }
  double masked(int surface) const { return share(surface, points.mask); }

  Scene scene;
  Frame frame;
  Table table;
  ObjectPoints points;
};

const Surface kTable = slab(-0.5, -0.4, 0.5, 0.4, 0);

}  // namespace

TEST(ObjectPoints, SeparateThingsFromTheTable) {
  const View view({kTable, box({-0.1, -0.1, 0}, {0.1, 0, 0.12}), sphere({0.25, 0.1, 0.05}, 0.05)});
  EXPECT_LT(view.masked(0), 0.005);
  EXPECT_GT(view.share(0, view.points.on_table), 0.95);
  EXPECT_GT(view.masked(1), 0.97);
  EXPECT_GT(view.masked(2), 0.90) << "a ball's lower rim is at table height";
  EXPECT_EQ(cv::countNonZero(view.points.mask & view.points.on_table), 0);
}

TEST(ObjectPoints, HeightIsAlongTheNormal) {
  const View view({kTable, box({-0.1, -0.1, 0}, {0.1, 0, 0.12})}, {}, 0);
  const Eigen::Isometry3d& T = view.scene.T_world_camera;
  for (int i = 0; i < view.frame.size(); i += 97) {
    const float h = view.points.height_m(i / 640, i % 640);
    if (view.scene.seen[i] < 0) {
      EXPECT_TRUE(std::isnan(h));
    } else {
      EXPECT_NEAR(h, (T * view.frame.points[i].cast<double>()).z(), 1e-3);
    }
  }
}

TEST(ObjectPoints, EmptyTableHasNone) {
  const View view({kTable});
  EXPECT_EQ(cv::countNonZero(view.points.mask), 0);
  EXPECT_GT(view.share(0, view.points.on_table), 0.95);
}

TEST(ObjectPoints, KeepThinSlabsOnTheTable) {
  const View view({kTable, box({-0.1, -0.1, 0}, {0.05, 0.05, 0.008}), box({0.15, -0.1, 0}, {0.25, 0.05, 0.02})});
  EXPECT_GT(view.masked(1), 0.9);
  EXPECT_GT(view.masked(2), 0.97);
  EXPECT_LT(view.masked(0), 0.005);
}

TEST(ObjectPoints, ThresholdFollowsTheNoise) {
  const View view({kTable, box({-0.1, -0.1, 0}, {0.1, 0, 0.12})}, {}, 3);
  EXPECT_LT(view.masked(0), 0.01) << "noise of the far table stays below";
  EXPECT_GT(view.masked(1), 0.85);
}

TEST(ObjectPoints, FloorAndNeighboursOfTheTableAreNone) {
  const View view({kTable, slab(-3, -3, 3, 3, -0.5), box({0.8, -0.2, -0.5}, {1.2, 0.4, 0.1}),
                   box({-0.1, -0.1, 0}, {0.1, 0, 0.12})});
  EXPECT_EQ(view.masked(1), 0);
  EXPECT_EQ(view.masked(2), 0) << "a box on the floor beside the table, higher than the table";
  EXPECT_GT(view.masked(3), 0.97);
}

TEST(ObjectPoints, KeepWhatStandsOutOverTheEdge) {
  const View view({slab(-0.3, -0.3, 0.3, 0.3, 0), slab(-3, -3, 3, 3, -0.7), box({0.1, -0.1, 0}, {0.42, 0.0, 0.08})});
  EXPECT_GT(view.masked(2), 0.95);
}

TEST(ObjectPoints, KeepWhatStandsWhereTheTableHasNoDepth) {
  const auto kept = [](const Surface& thing) { return View({kTable, thing}, {}, 1, 0.05).masked(1); };
  EXPECT_GT(kept(box({-0.05, 0.28, 0}, {0.05, 0.36, 0.1})), 0.9);
  EXPECT_GT(kept(box({-0.4, 0.28, 0}, {-0.32, 0.36, 0.03})), 0.9);
  EXPECT_EQ(kept(box({-0.05, 0.28, 0.08}, {0.05, 0.36, 0.16})), 0) << "does not come down to the table";
  EXPECT_EQ(kept(box({-0.05, 0.6, 0}, {0.05, 0.7, 0.1})), 0) << "far from all that was seen of it";
  EXPECT_EQ(kept(box({-2, 0.28, 0}, {0.05, 0.36, 0.1})), 0) << "comes from out of the picture";
}

TEST(ObjectPoints, LeaveOutWhatStandsBehindATableThatIsSeenToEnd) {
  const View view({slab(-0.5, -0.4, 0.5, 0.05, 0), slab(-3, -3, 3, 3, -0.5),
                   box({-0.05, 0.28, -0.5}, {0.05, 0.36, 0.1}), box({0.2, 0.28, 0}, {0.3, 0.36, 0.1}),
                   box({-0.1, -0.2, 0}, {0.0, -0.1, 0.1})});
  EXPECT_EQ(view.masked(2), 0) << "stands on the floor";
  EXPECT_EQ(view.masked(3), 0) << "at the height of the table, on nothing that is seen";
  EXPECT_GT(view.masked(4), 0.95);
}

TEST(ObjectPoints, LeaveOutWalls) {
  // The rear wall of a bin rises from the table's edge, runs out of the picture, and a box stands before it.
  const View view({kTable, box({-2, 0.4, -0.2}, {2, 0.5, 0.4}), box({-0.1, 0.1, 0}, {0.1, 0.2, 0.12})});
  EXPECT_LT(view.masked(1), 0.02);
  EXPECT_GT(view.masked(2), 0.95);
}

TEST(ObjectPoints, LeaveOutWhatReachesOverTheCeilingFromBesideTheTable) {
  // An arm whose foot is behind the table.
  ObjectPointsConfig config;
  config.max_height_m = 0.2;
  const View view({kTable, box({-0.15, 0.1, 0.25}, {-0.05, 0.6, 0.35}), box({0.1, -0.05, 0}, {0.2, 0.05, 0.15})},
                  config);
  EXPECT_EQ(view.masked(1), 0);
  EXPECT_GT(view.masked(2), 0.95);
}

TEST(ObjectPoints, LeaveOutWhatReachesOverTheCeilingOutOfThePicture) {
  ObjectPointsConfig config;
  config.max_height_m = 0.2;
  const View view({kTable, box({-0.15, -0.05, 0}, {-0.05, 0.05, 2}), box({0.1, -0.05, 0}, {0.2, 0.05, 0.15})}, config);
  EXPECT_EQ(view.masked(1), 0);
  EXPECT_GT(view.masked(2), 0.95);
}

TEST(ObjectPoints, KeepATallStackThatStandsAlone) {
  ObjectPointsConfig config;
  config.max_height_m = 0.2;
  const std::vector<Surface> scene{kTable, box({-0.15, -0.05, 0}, {-0.05, 0.05, 0.35})};
  EXPECT_GT(View(scene, config).masked(1), 0.95);
  config.max_height_m = 0.15;
  EXPECT_EQ(View(scene, config).masked(1), 0) << "over twice the height";
}

TEST(ObjectPoints, FloorOfABowlBelongsToItTheHoleOfARingDoesNot) {
  const Surface floor = [](const Eigen::Vector3d& o, const Eigen::Vector3d& d) {
    const double t = (0.003 - o.z()) / d.z();
    const Eigen::Vector3d p = o + t * d;
    return t > 0 && std::hypot(p.x() + 0.15, p.y()) < 0.075 ? t : kMiss;
  };
  const std::vector<Surface> surfaces = {kTable, tube(-0.15, 0, 0, 0.05, 0.075), floor, tube(0.15, 0, 0, 0.05, 0.075)};
  const auto ringHole = [](const View& view) {
    int in = 0;
    for (int i = 0; i < view.frame.size(); ++i) {
      const Eigen::Vector3d p = view.scene.T_world_camera * view.frame.points[i].cast<double>();
      in += view.scene.seen[i] == 0 && std::hypot(p.x() - 0.15, p.y()) < 0.06 && view.points.mask.data[i];
    }
    return in;
  };
  const View view(surfaces);
  EXPECT_GT(view.masked(1), 0.9);
  EXPECT_GT(view.masked(2), 0.9);
  EXPECT_LT(ringHole(view), 20);

  ObjectPointsConfig config;
  config.hollow_floors = false;
  const View without(surfaces, config);
  EXPECT_LT(without.masked(2), 0.5);
}

TEST(ObjectPoints, SpecksAreNone) {
  const View view({kTable, box({-0.1, -0.1, 0}, {-0.09, -0.09, 0.01})});
  EXPECT_EQ(cv::countNonZero(view.points.mask), 0);
}

TEST(ObjectPoints, InvalidPointsAreNone) {
  View view({kTable, box({-0.1, -0.1, 0}, {0.1, 0, 0.12})});
  for (Eigen::Vector3f& p : view.frame.points) p.setConstant(kNan);
  const ObjectPoints none = findObjectPoints(view.frame, estimateNormals(view.frame, {}), view.table, {});
  EXPECT_EQ(cv::countNonZero(none.mask) + cv::countNonZero(none.on_table), 0);
}

TEST(ObjectPoints, SameTwice) {
  const std::vector<Surface> surfaces = {kTable, box({-0.1, -0.1, 0}, {0.1, 0, 0.12})};
  const View a(surfaces), b(surfaces);
  EXPECT_EQ(cv::norm(a.points.mask, b.points.mask, cv::NORM_INF), 0);
  EXPECT_EQ(cv::norm(a.points.on_table, b.points.on_table, cv::NORM_INF), 0);
}
