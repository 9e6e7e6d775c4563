// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <set>

#include "fixtures/report_figures.hpp"
#include "fixtures/small_scene.hpp"
#include "objectness_segmentation/pipeline.hpp"
#include "sim/scene_generator.hpp"
#include "sim/simulated_frame.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

/// A simulated picture of boxes on a table, with the truth.
struct Picture {
  Frame frame;
  cv::Mat_<ushort> truth;
};

Eigen::Isometry3d at(double x, double y, double z, double yaw_deg = 0) {
  return Eigen::Translation3d(x, y, z) *
         Eigen::Isometry3d(Eigen::AngleAxisd(yaw_deg * M_PI / 180, Eigen::Vector3d::UnitZ()));
}

struct PlacedBox {
  Eigen::Vector3d size;
  Eigen::Isometry3d pose;  ///< of the middle of its base
};

Picture pictureOf(const std::vector<PlacedBox>& boxes) {
  sim::Scene scene = smallScene();
  scene.bodies.resize(1);  // the table
  scene.objects.clear();
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    scene.bodies.push_back({sim::Box{boxes[k].size}, boxes[k].pose, {50, 100, 200}, static_cast<ushort>(20 + 10 * k)});
  }
  const SceneImages images =
      sim::takePicture(scene.bodies, sim::lookAt({0, -0.65, 0.55}, {0, 0, 0.05}), sim::DepthSensor(), 1);
  return {makeFrame(images.depth_mm, images.color, images.camera, {}).value, images.true_labels};
}

/// A slab of 0.2 x 0.02 x 0.24 m that stands on its lower front edge and leans back at the front of a box.
std::vector<PlacedBox> leaning() {
  Eigen::Isometry3d pose = at(0, -0.102, 0);
  pose.linear() = Eigen::AngleAxisd(-25 * M_PI / 180, Eigen::Vector3d::UnitX()).toRotationMatrix();
  // Its lower back edge, which is on the table, is 1 cm behind the middle of its base.
  pose.translation().z() = 0.01 * std::sin(25 * M_PI / 180);
  return {{{0.2, 0.02, 0.24}, pose}, {{0.3, 0.12, 0.15}, at(0, 0.04, 0)}};
}

void expectSameSegments(const Segmentation& a, const Segmentation& b) {
  ASSERT_EQ(a.segments.size(), b.segments.size());
  EXPECT_EQ(0, cv::norm(a.labels, b.labels, cv::NORM_L1));
  EXPECT_EQ(figuresOf(a.report), figuresOf(b.report));
  for (std::size_t i = 0; i < a.segments.size(); ++i) {
    EXPECT_EQ(a.segments[i].pixels, b.segments[i].pixels);
    EXPECT_EQ(a.segments[i].objectness, b.segments[i].objectness);
    EXPECT_TRUE(a.segments[i].box.T_camera_box.matrix() == b.segments[i].box.T_camera_box.matrix());
  }
  ASSERT_EQ(a.proposals.size(), b.proposals.size());
  for (std::size_t i = 0; i < a.proposals.size(); ++i) EXPECT_EQ(a.proposals[i].objectness, b.proposals[i].objectness);
}

/// Intersection over union of a true object with the segment that fits it best.
double bestOverlap(const cv::Mat_<ushort>& truth, int label, const Segmentation& result) {
  const int size = cv::countNonZero(truth == label);
  double best = 0;
  for (const Segment& segment : result.segments) {
    int shared = 0;
    for (const int pixel : segment.pixels) shared += truth(pixel) == label;
    best = std::max(best, shared / static_cast<double>(segment.pixels.size() + size - shared));
  }
  return best;
}

/// Every object has a segment of its own with nearly the same pixels, and there are no others.
void expectOneSegmentEach(const Picture& picture, const Segmentation& result, std::size_t objects) {
  ASSERT_TRUE(result.status.ok()) << result.status.message;
  EXPECT_EQ(result.segments.size(), objects);
  for (std::size_t k = 0; k < objects; ++k) {
    EXPECT_GT(bestOverlap(picture.truth, static_cast<int>(20 + 10 * k), result), 0.85) << "object " << k;
  }
}

const std::vector<PlacedBox> kStack = {{{0.24, 0.18, 0.08}, at(0, 0, 0, 20)},
                                       {{0.12, 0.1, 0.11}, at(0, 0.01, 0.08, -15)}};

}  // namespace

TEST(BottomUp, IsTheDefault) {
  EXPECT_EQ(Config().pipeline.method, SegmentationMethod::kObjectness);
  std::vector<std::string> stages;
  const Segmentation result = segment(pictureOf(kStack).frame, Config());
  for (const auto& entry : result.report.timings_ms) stages.push_back(entry.first);
  EXPECT_EQ(stages, (std::vector<std::string>{"normals", "table", "refined_normals", "object_points", "surface_cues",
                                              "pieces", "groups", "selection", "segments", "background", "whole_boxes",
                                              "unmeasured", "total"}));
  Config paper;
  paper.pipeline.method = SegmentationMethod::kPaper;
  paper.search.angle_step_deg = 45;
  std::set<std::string> of_the_paper;
  for (const auto& entry : segment(pictureOf(kStack).frame, paper).report.timings_ms) of_the_paper.insert(entry.first);
  EXPECT_EQ(of_the_paper.count("search"), 1u);
  EXPECT_EQ(of_the_paper.count("groups"), 0u);
}

TEST(BottomUp, BoxesApartAreOneObjectEach) {
  const Picture picture =
      pictureOf({{{0.12, 0.1, 0.14}, at(-0.15, 0, 0, 10)}, {{0.14, 0.1, 0.1}, at(0.15, 0, 0, -30)}});
  expectOneSegmentEach(picture, segment(picture.frame, Config()), 2);
}

TEST(BottomUp, AStackIsTwoObjects) {
  const Picture picture = pictureOf(kStack);
  const Segmentation result = segment(picture.frame, Config());
  expectOneSegmentEach(picture, result, 2);
  // The paper's boxes all stand on the table; these stand where the things do.
  std::vector<double> bases;
  for (const Segment& segment : result.segments) {
    const Eigen::Isometry3d T = result.table.T_table_camera * segment.box.T_camera_box;
    bases.push_back(T.translation().z() - segment.box.size_m.z() / 2);
  }
  std::sort(bases.begin(), bases.end());
  ASSERT_EQ(bases.size(), 2u);
  EXPECT_NEAR(bases[0], 0, 0.015);
  EXPECT_NEAR(bases[1], 0.08, 0.015);
}

TEST(BottomUp, AThingThatLeansIsAnObjectOfItsOwn) {
  const Picture picture = pictureOf(leaning());
  expectOneSegmentEach(picture, segment(picture.frame, Config()), 2);
}

TEST(BottomUp, MostThingsThatLeanAreObjectsOfTheirOwn) {
  int objects = 0, found = 0;
  for (std::uint32_t index = 0; index < 6; ++index) {
    sim::SceneRequest request;
    request.camera = sim::DepthSensor().camera;
    request.level = "leaning";
    request.seed = 11;
    request.index = index;
    const auto scene = sim::generateScene(request);
    ASSERT_TRUE(scene.ok()) << scene.status.message;
    const sim::SimulatedFrame view =
        sim::simulateFrame(scene.value, scene.value.T_world_camera, sim::DepthSensor(), index);
    const Frame frame = makeFrame(view.images.depth_mm, view.images.color, view.images.camera, {}).value;
    const Segmentation result = segment(frame, Config());
    for (const sim::TrueObject& object : view.objects) {
      if (object.hidden) continue;
      ++objects;
      found += bestOverlap(view.images.true_labels, object.label, result) > 0.6;  // a Dice of 0.75
    }
  }
  EXPECT_GT(objects, 15);
  EXPECT_GE(found, 0.8 * objects) << found << " of " << objects;
  RecordProperty("found", found);
}

TEST(BottomUp, TheSameForAnyNumberOfThreads) {
  const Picture picture = pictureOf(leaning());
  Config config;
  config.runtime.threads = 1;
  const Segmentation one = segment(picture.frame, config);
  for (const int threads : {2, 5}) {
    config.runtime.threads = threads;
    expectSameSegments(segment(picture.frame, config), one);
  }
}

TEST(BottomUp, AModelOfOnesOwnJudges) {
  const Picture picture = pictureOf(kStack);
  LearnedObjectness model = defaultModel();
  model.group.trees = {{{-1, 0, 0, 0, 0.9f}}};
  for (Forest* pairs : {&model.contact, &model.gap}) pairs->trees = {{{-1, 0, 0, 0, 0.98f}}};
  EXPECT_EQ(segment(picture.frame, Config(), model).segments.size(), 1u) << "all is one";
  model.group.trees = {{{-1, 0, 0, 0, 0.1f}}};
  for (Forest* pairs : {&model.contact, &model.gap}) pairs->trees = {{{-1, 0, 0, 0, 0.02f}}};
  EXPECT_TRUE(segment(picture.frame, Config(), model).segments.empty()) << "nothing is an object";
}

TEST(BottomUp, AnEmptyTableIsAValidResult) {
  const Segmentation result = segment(pictureOf({}).frame, Config());
  EXPECT_TRUE(result.status.ok()) << result.status.message;
  EXPECT_TRUE(result.segments.empty());
  EXPECT_TRUE(result.proposals.empty());
}

TEST(BottomUp, CanBeCancelled) {
  const std::atomic<bool> cancel{true};
  EXPECT_EQ(segment(pictureOf(kStack).frame, Config(), &cancel).status.code, StatusCode::kCancelled);
}
