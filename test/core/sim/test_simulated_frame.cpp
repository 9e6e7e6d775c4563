// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <opencv2/imgcodecs.hpp>
#include <set>

#include "fixtures/temporary_folder.hpp"
#include "sim/scene_generator.hpp"
#include "sim/simulated_frame.hpp"
#include "sim/truth_file.hpp"

using namespace objectness;
using namespace objectness::sim;
using namespace objectness_test;
using Eigen::Vector3d;

namespace {

/// Boards on a table, seen from 1 m away along +y: a large one, a smaller one behind it that shows `shown_m` of its
/// width of 0.1 m beside it, both of 0.1 m height.
Scene twoBoards(double shown_m) {
  Scene scene;
  scene.level = "test";
  const auto add = [&](const Shape& shape, const Vector3d& position, int label, const char* kind) {
    Body body{shape, Eigen::Isometry3d::Identity(), {100, 100, 100}, static_cast<ushort>(label)};
    body.T_world_body.translation() = position;
    scene.bodies.push_back(body);
    if (label < 20) return;
    const Eigen::AlignedBox3d box = bounds(shape);
    scene.objects.push_back({kind, label, body.T_world_body * Eigen::Translation3d(box.center()), box.sizes()});
  };
  add(sim::Box{{2, 2, 0.02}}, {0, 0, -0.02}, 1, "table");
  // Seen from the eye, the plane of the second is 1.25 times as far as the first's.
  add(sim::Box{{0.2, 0.001, 0.1}}, {0, 0, 0}, 20, "front");
  add(sim::Box{{0.1, 0.001, 0.1}}, {0.1 * 1.25 + shown_m - 0.05, 0.25, 0}, 30, "back");
  scene.target = {0, 0, 0.05};
  scene.T_world_camera = lookAt({0, -1, 0.05}, scene.target);
  return scene;
}

SimulatedFrame ideal(const Scene& scene) {
  DepthSensor sensor;
  sensor.ideal = true;
  return simulateFrame(scene, scene.T_world_camera, sensor, 1);
}

}  // namespace

TEST(SimulatedFrame, MeasuresWhatCanBeSeenOfAnObject) {
  const SimulatedFrame frame = ideal(twoBoards(0.04));
  ASSERT_EQ(frame.objects.size(), 2u);
  EXPECT_EQ(frame.objects[0].visible, 1);
  EXPECT_NEAR(frame.objects[1].visible, 0.4, 0.03);
  EXPECT_FALSE(frame.objects[1].hidden);
  EXPECT_NEAR(frame.table_distance_m, 0.05, 1e-12);
  EXPECT_TRUE(frame.table_normal.isApprox(Vector3d(0, -1, 0), 1e-9));
  for (const TrueObject& object : frame.objects) {
    cv::Rect extent;
    const cv::Mat mask = frame.images.true_labels == object.label;
    std::vector<cv::Point> pixels;
    cv::findNonZero(mask, pixels);
    for (const cv::Point& pixel : pixels) extent |= cv::Rect(pixel, cv::Size(1, 1));
    EXPECT_EQ(object.extent, extent);
    EXPECT_EQ(frame.images.true_labels(object.seed), object.label);
  }
  const cv::Rect front = frame.objects[0].extent;
  EXPECT_NEAR(front.x, 319.5 - 0.1 * 525, 1.1);
  EXPECT_NEAR(front.width, 0.2 * 525, 2);
  EXPECT_TRUE(frame.objects[0].box.T_camera_box.translation().isApprox(Vector3d(0, 0, 1), 1e-9));
  EXPECT_TRUE(frame.objects[0].box.size_m.isApprox(Vector3d(0.2, 0.001, 0.1)));
}

TEST(SimulatedFrame, TheTableFillsTheShareThatIsAskedFor) {
  SceneRequest request;
  request.level = "shapes";
  request.camera = {131.25, 131.25, 79.5, 59.5, 160, 120};
  double least = 1;
  for (const double share : {SceneRequest{}.min_table_share, 0.5}) {
    request.min_table_share = share;
    for (request.index = 0; request.index < 20; ++request.index) {
      const Result<Scene> scene = generateScene(request);
      ASSERT_TRUE(scene.ok()) << scene.status.message;
      const SurfaceView view = viewSurfaces(scene.value.bodies, scene.value.T_world_camera, request.camera, {});
      int pixels = 0;
      for (const auto& [label, count] : view.pixels_seen) pixels += label > 0 ? count : 0;
      const double filled = static_cast<double>(pixels) / (request.camera.width * request.camera.height);
      EXPECT_GT(filled, share - 0.02) << request.index;  // found on a coarser picture
      least = std::min(least, filled);
    }
  }
  EXPECT_LT(least, 0.4) << "the default leaves room for more floor";
}

TEST(SimulatedFrame, HiddenObjectsHaveNoLabel) {
  const SimulatedFrame frame = ideal(twoBoards(0.003));
  EXPECT_TRUE(frame.objects[1].hidden);
  EXPECT_LT(frame.objects[1].visible, kMinVisible);
  EXPECT_GT(frame.objects[1].visible, 0);
  EXPECT_EQ(frame.objects[1].seed, cv::Point(-1, -1));
  EXPECT_EQ(cv::countNonZero(frame.images.true_labels == 30), 0);
  EXPECT_GT(cv::countNonZero((frame.images.true_labels == 0) & (frame.images.depth_mm >= 1249) &
                             (frame.images.depth_mm <= 1250)),
            20)
      << "its pixels are void: nobody is asked what they are";
  EXPECT_FALSE(frame.objects[0].hidden);
}

TEST(SimulatedFrame, TheOrbitLooksAtTheTargetFromTheSameDistance) {
  const Scene scene = twoBoards(0.04);
  EXPECT_TRUE(orbitPose(scene, 0, 8).isApprox(scene.T_world_camera, 1e-12));
  double widest_deg = 0;
  for (int frame = 0; frame < 8; ++frame) {
    const Eigen::Isometry3d pose = orbitPose(scene, frame, 8);
    const Vector3d away = pose.translation() - scene.target, start = scene.T_world_camera.translation() - scene.target;
    EXPECT_NEAR(away.norm(), start.norm(), 1e-12);
    EXPECT_NEAR(pose.translation().z(), 0.05, 1e-12);
    EXPECT_NEAR(pose.linear().col(2).dot(-away.normalized()), 1, 1e-12);
    widest_deg = std::max(widest_deg, std::acos(away.normalized().dot(start.normalized())) * 180 / 3.14159265358979);
  }
  EXPECT_NEAR(widest_deg, kOrbitSwing_deg, 1e-6);
}

TEST(SimulatedFrame, SeedsOfTheNoiseDiffer) {
  std::set<std::uint32_t> seeds;
  for (const std::uint32_t seed : {1, 2}) {
    for (const std::uint32_t index : {0, 1, 2}) {
      for (int frame = 0; frame < 100; ++frame) seeds.insert(noiseSeed(seed, index, frame));
    }
  }
  EXPECT_EQ(seeds.size(), 600u);
}

TEST(SimulatedFrame, IsReadBackFromItsFolder) {
  const TemporaryFolder folder;
  SceneRequest request;
  request.level = "clutter";
  const DepthSensor sensor;
  request.camera = sensor.camera;
  const Result<Scene> scene = generateScene(request);
  ASSERT_TRUE(scene.ok()) << scene.status.message;
  const SimulatedFrame frame = simulateFrame(scene.value, scene.value.T_world_camera, sensor, 5);
  ASSERT_TRUE(saveSimulatedFrame(folder.path(), frame).ok());

  const Result<Frame> read = loadSceneFolder(folder.path(), {}, InputConfig());
  ASSERT_TRUE(read.ok()) << read.status.message;
  EXPECT_EQ(read.value.camera.fx, 525);
  const cv::Mat labels = cv::imread(folder / "labels.png", cv::IMREAD_UNCHANGED);
  EXPECT_EQ(cv::countNonZero(labels != frame.images.true_labels), 0);

  const YAML::Node truth = YAML::LoadFile(folder / "objects.yaml");
  EXPECT_EQ(truth["level"].as<std::string>(), "clutter");
  EXPECT_NEAR(truth["table"]["distance_m"].as<double>(), frame.table_distance_m, 1e-8);
  EXPECT_EQ(truth["table"]["normal"].as<std::vector<double>>().size(), 3u);
  EXPECT_EQ(truth["objects"].size() + truth["hidden"].size(), frame.objects.size());
  ASSERT_GE(truth["objects"].size(), 5u);
  std::size_t listed = 0;
  for (const TrueObject& object : frame.objects) {
    if (object.hidden) continue;
    const YAML::Node node = truth["objects"][listed++];
    EXPECT_EQ(node["label"].as<int>(), object.label);
    EXPECT_EQ(node["kind"].as<std::string>(), object.kind);
    const auto box = node["box"].as<std::vector<int>>(), seed = node["seed"].as<std::vector<int>>();
    EXPECT_EQ(cv::Rect(cv::Point(box[0], box[1]), cv::Point(box[2], box[3])), object.extent);
    EXPECT_EQ(cv::Point(seed[0], seed[1]), object.seed);
    EXPECT_NEAR(node["visible"].as<double>(), object.visible, 1e-8);
    const auto size = node["size_m"].as<std::vector<double>>();
    const auto position = node["T_camera_box"]["position"].as<std::vector<double>>();
    const auto q = node["T_camera_box"]["orientation_xyzw"].as<std::vector<double>>();
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(size[i], object.box.size_m[i], 1e-8);
      EXPECT_NEAR(position[i], object.box.T_camera_box.translation()[i], 1e-8);
    }
    const Eigen::Quaterniond rotation(q[3], q[0], q[1], q[2]);
    EXPECT_TRUE(rotation.toRotationMatrix().isApprox(object.box.T_camera_box.linear(), 1e-7));
  }
  const YAML::Node pose = YAML::LoadFile(folder / "pose.yaml")["T_world_camera"];
  EXPECT_NEAR(pose["position"][2].as<double>(), frame.T_world_camera.translation().z(), 1e-8);
}

TEST(SimulatedFrame, SaysWhyItCannotBeWritten) {
  const Status status = saveSimulatedFrame("/proc/nowhere", ideal(twoBoards(0.04)));
  EXPECT_EQ(status.code, StatusCode::kBadInput);
  EXPECT_NE(status.message.find("/proc/nowhere"), std::string::npos);
}
