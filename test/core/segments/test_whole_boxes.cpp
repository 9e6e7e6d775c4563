// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fixtures/seen_surfaces.hpp"
#include "objectness_segmentation/pipeline.hpp"
#include "segments/seen_space.hpp"
#include "segments/whole_boxes.hpp"
#include "sim/scene_generator.hpp"
#include "sim/simulated_frame.hpp"

using namespace objectness;
using namespace objectness_test;
using Eigen::Vector3d;

namespace {

/// TableClusters on a table whose boxes are completed.
struct Completed : SeenSurfaces {
  explicit Completed(const std::vector<Surface>& things) : SeenSurfaces(onATable(things)) {
    const cv::Mat_<uchar> on_table(frame.height(), frame.width(), uchar(0));
    completeBoxes(frame, normals, table, above, labelImage(on_table, {}, segments), segments);
  }

  Eigen::Isometry3d inWorld(std::size_t k) const { return scene.T_world_camera * segments[k].box.T_camera_box; }
};

}  // namespace

TEST(SeenSpace, IsFreeBeforeWhatIsSeenAndHiddenBehind) {
  Scene scene;
  scene.surfaces = {slab(-0.6, -0.5, 0.6, 0.5, 0), box({-0.1, -0.1, 0}, {0.1, 0.1, 0.2}),
                    box({0.15, -0.1, 0}, {0.3, 0.1, 0.2})};
  const Frame frame = scene.render();
  Table table;
  table.T_table_camera = scene.T_world_camera;
  cv::Mat_<ushort> labels(frame.height(), frame.width(), ushort(0));
  for (int i = 0; i < frame.size(); ++i) labels(i) = static_cast<ushort>(scene.seen[i] > 0 ? scene.seen[i] + 1 : 0);
  const SeenSpace space(frame, table, labels, 2);
  EXPECT_EQ(space.at({0, -0.2, 0.1}), Seen::kFree);
  EXPECT_EQ(space.at({0, -0.1, 0.1}), Seen::kOwn);
  EXPECT_EQ(space.at({0, 0, 0.1}), Seen::kOwn);
  EXPECT_EQ(space.at({0.2, 0, 0.05}), Seen::kBehindOther);
  EXPECT_EQ(space.at({0.2, -0.1, 0.1}), Seen::kOther);
  EXPECT_EQ(space.at({0, -0.3, 0}), Seen::kOther);
  EXPECT_EQ(space.at({5, 0, 0}), Seen::kUnknown);
  EXPECT_EQ(space.at({0, -2, 0.7}), Seen::kUnknown);
}

TEST(WholeBoxes, OfACanHoldItsHiddenHalf) {
  const double x = 0.1, y = 0.05, radius = 0.05, height = 0.15;
  const Surface wall = tube(x, y, 0, height, radius);
  const Surface top = [=](const Vector3d& o, const Vector3d& d) {
    const double t = (height - o.z()) / d.z();
    const Vector3d p = o + t * d;
    return t > 0 && std::hypot(p.x() - x, p.y() - y) < radius ? t : kMiss;
  };
  const Completed done({[=](const Vector3d& o, const Vector3d& d) { return std::min(wall(o, d), top(o, d)); }});
  const Segment& can = done.segments[0];
  EXPECT_TRUE(can.round);
  EXPECT_NEAR(can.box.size_m.x(), 2 * radius, 0.004);
  EXPECT_EQ(can.box.size_m.x(), can.box.size_m.y());
  EXPECT_NEAR(can.box.size_m.z(), height, 0.002);
  EXPECT_LT((done.inWorld(0).translation() - Vector3d(x, y, 0.5 * height)).norm(), 0.004);
  // Turned to the view: x leads away from the camera.
  const Vector3d away = (Vector3d(x, y, 0) - done.scene.T_world_camera.translation()).cwiseProduct(Vector3d(1, 1, 0));
  EXPECT_GT(done.inWorld(0).linear().col(0).dot(away.normalized()), 0.999);
  EXPECT_GT(done.inWorld(0).linear()(2, 2), 0.9999);
  // The tight box of what is seen is kept.
  EXPECT_LT(can.visible_box.size_m.z(), height);
}

TEST(WholeBoxes, OfABoxEndWhereItEnds) {
  const Completed done({box({-0.15, -0.1, 0}, {0.05, 0.02, 0.09})});
  const Segment& found = done.segments[0];
  EXPECT_FALSE(found.round);
  EXPECT_LT((found.box.size_m - Vector3d(0.2, 0.12, 0.09)).cwiseAbs().maxCoeff(), 0.005);
  EXPECT_LT((done.inWorld(0).translation() - Vector3d(-0.05, -0.04, 0.045)).norm(), 0.004);
  EXPECT_GT(done.inWorld(0).linear()(0, 0), 0.999);
  EXPECT_GT(done.inWorld(0).linear()(2, 2), 0.9999);
}

TEST(WholeBoxes, GoOnBehindOthersAndNotIntoFreeSpace) {
  // The second is seen beside the first only; its hidden end may be anywhere behind it, up to where one looks past.
  const Completed done({box({-0.02, -0.2, 0}, {0.14, -0.15, 0.2}), box({-0.1, 0, 0}, {0.05, 0.1, 0.1})});
  const OrientedBox& hidden = done.segments[1].box;
  const double end = (done.inWorld(1) * Vector3d(0.5 * hidden.size_m.x(), 0, 0)).x();
  EXPECT_GT(hidden.size_m.maxCoeff(), done.segments[1].visible_box.size_m.head<2>().minCoeff());
  EXPECT_LT(end, 0.2);
  EXPECT_NEAR(hidden.size_m.z(), 0.1, 0.003);
}

TEST(WholeBoxes, KeepThePixelsAndDoNotDependOnTheNumberOfThreads) {
  sim::SceneRequest request;
  request.level = "clutter";
  request.seed = 3;
  request.camera = sim::DepthSensor().camera;
  const auto scene = sim::generateScene(request);
  ASSERT_TRUE(scene.ok());
  const auto truth = sim::simulateFrame(scene.value, scene.value.T_world_camera, sim::DepthSensor(), 0);
  const Frame frame = makeFrame(truth.images.depth_mm, cv::Mat(), truth.images.camera, InputConfig()).value;
  Config config;
  config.runtime.threads = 1;
  const Segmentation one = segment(frame, config);
  config.runtime.threads = 3;
  const Segmentation three = segment(frame, config);
  ASSERT_EQ(one.segments.size(), three.segments.size());
  ASSERT_GT(one.segments.size(), 5u);
  for (std::size_t k = 0; k < one.segments.size(); ++k) {
    EXPECT_EQ(one.segments[k].pixels, three.segments[k].pixels);
    EXPECT_EQ(one.segments[k].box.T_camera_box.matrix(), three.segments[k].box.T_camera_box.matrix());
    EXPECT_EQ(one.segments[k].box.size_m, three.segments[k].box.size_m);
    EXPECT_EQ(one.segments[k].round, three.segments[k].round);
    EXPECT_GT(one.segments[k].box.size_m.minCoeff(), 0);
    EXPECT_NEAR(one.segments[k].box.T_camera_box.linear().determinant(), 1, 1e-9);
    EXPECT_GT((one.table.T_table_camera * one.segments[k].box.T_camera_box).linear()(2, 2), 0.7);
  }
}
