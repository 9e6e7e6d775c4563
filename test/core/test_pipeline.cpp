// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstring>

#include "fixtures/ray_cast.hpp"
#include "fixtures/report_figures.hpp"
#include "fixtures/temporary_folder.hpp"
#include "objectness_segmentation/io/scene_folder.hpp"
#include "objectness_segmentation/pipeline.hpp"
#include "search/angle_search.hpp"
#include "search/search.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

/// A box, a cube beside it and a low box, on a table of 1.2 x 0.8 m over a floor.
Scene tableTop() {
  Scene scene;
  scene.surfaces = {slab(-5, -5, 5, 5, -0.7), slab(-0.6, -0.4, 0.6, 0.4, 0), box({-0.25, -0.05, 0}, {-0.11, 0.07, 0.2}),
                    box({0.02, -0.1, 0}, {0.1, -0.02, 0.08}), box({0.2, 0, 0}, {0.36, 0.12, 0.06})};
  scene.s0 = 0.0003, scene.s2 = 0.0008;
  return scene;
}

Surface moved(const Surface& surface, const Eigen::Isometry3d& T_world_surface) {
  const Eigen::Isometry3d T = T_world_surface.inverse();
  return [=](const Eigen::Vector3d& o, const Eigen::Vector3d& d) { return surface(T * o, T.linear() * d); };
}

/// The paper's method, quick.
Config quickConfig() {
  Config config;
  config.pipeline.method = SegmentationMethod::kPaper;
  config.search.angle_step_deg = 15;
  return config;
}

void expectSameResult(const Segmentation& a, const Segmentation& b) {
  ASSERT_EQ(a.segments.size(), b.segments.size());
  EXPECT_EQ(0, cv::norm(a.labels, b.labels, cv::NORM_L1));
  EXPECT_EQ(figuresOf(a.report), figuresOf(b.report));
  for (std::size_t i = 0; i < a.segments.size(); ++i) {
    EXPECT_EQ(a.segments[i].pixels, b.segments[i].pixels);
    EXPECT_EQ(a.segments[i].objectness, b.segments[i].objectness);
    EXPECT_TRUE(a.segments[i].box.T_camera_box.matrix() == b.segments[i].box.T_camera_box.matrix());
  }
}

}  // namespace

TEST(Pipeline, EachObjectIsOneSegment) {
  Scene scene = tableTop();
  const Frame frame = scene.render();
  const Segmentation result = segment(frame, quickConfig());
  ASSERT_TRUE(result.status.ok()) << result.status.message;
  ASSERT_EQ(result.segments.size(), 3u);
  for (int object = 2; object < 5; ++object) {
    // The segment that holds most of the object holds nearly all of it and nearly nothing else.
    int best_shared = 0, size = 0, best_size = 0;
    for (int i = 0; i < frame.size(); ++i) size += scene.seen[i] == object;
    for (const auto& segment : result.segments) {
      int shared = 0;
      for (const int pixel : segment.pixels) shared += scene.seen[pixel] == object;
      if (shared > best_shared) best_shared = shared, best_size = static_cast<int>(segment.pixels.size());
    }
    EXPECT_GT(best_shared, 0.95 * size) << "object " << object;
    EXPECT_GT(best_shared, 0.97 * best_size) << "object " << object;
  }
}

TEST(Pipeline, BoxesFitTheObjects) {
  Scene scene = tableTop();
  const Segmentation result = segment(scene.render(), quickConfig());
  ASSERT_EQ(result.segments.size(), 3u);
  const std::vector<Eigen::Vector3d> centres = {{-0.18, 0.01, 0.1}, {0.06, -0.06, 0.04}, {0.28, 0.06, 0.03}};
  for (const auto& centre : centres) {
    double nearest = 1;
    for (const auto& segment : result.segments) {
      nearest = std::min(nearest, (scene.T_world_camera * segment.box.T_camera_box.translation() - centre).norm());
    }
    // Faces are sampled every 2 cm.
    EXPECT_LT(nearest, 0.03) << centre.transpose();
  }
  for (const auto& segment : result.segments) {
    const Eigen::Vector3d up = scene.T_world_camera.linear() * segment.box.T_camera_box.linear().col(2);
    EXPECT_GT(up.z(), 0.999);
    EXPECT_NEAR(segment.objectness, objectness::objectness(segment.cues, ObjectnessConfig()), 1e-6);
  }
}

TEST(Pipeline, LabelsAgreeWithTheSegments) {
  Scene scene = tableTop();
  const Frame frame = scene.render();
  const Segmentation result = segment(frame, quickConfig());
  std::vector<int> owner(frame.size(), 0);
  for (std::size_t k = 0; k < result.segments.size(); ++k) {
    for (const int pixel : result.segments[k].pixels) {
      ASSERT_EQ(owner[pixel], 0) << "a pixel in two segments";
      owner[pixel] = static_cast<int>(k) + 2;
    }
    if (k > 0) {
      EXPECT_GE(result.segments[k - 1].objectness, result.segments[k].objectness);
    }
  }
  for (int i = 0; i < frame.size(); ++i) {
    const int label = result.labels(i / frame.width(), i % frame.width());
    ASSERT_EQ(label >= 2 ? label : 0, owner[i]);
  }
  EXPECT_EQ(result.labels(400, 320), 1) << "the table in front of the objects";
}

TEST(Pipeline, TheSameForAnyNumberOfThreads) {
  Scene scene = tableTop();
  const Frame frame = scene.render();
  Config config = quickConfig();
  config.runtime.threads = 1;
  const Segmentation one = segment(frame, config);
  for (const int threads : {2, 3, 8}) {
    config.runtime.threads = threads;
    expectSameResult(segment(frame, config), one);
  }
}

TEST(Pipeline, ReportsWhatWasDone) {
  Scene scene = tableTop();
  const Segmentation result = segment(scene.render(), quickConfig());
  std::vector<std::string> stages;
  for (const auto& [stage, ms] : result.report.timings_ms) {
    stages.push_back(stage);
    EXPECT_GE(ms, 0);
  }
  EXPECT_EQ(stages, (std::vector<std::string>{"normals", "table", "refined_normals", "object_points", "surface_cues",
                                              "cue_points", "search", "filter", "selection", "segments", "background",
                                              "whole_boxes", "unmeasured", "total"}));
  EXPECT_GT(result.report.boxes_sampled, result.report.boxes_scored);
  EXPECT_GT(result.report.boxes_scored, result.report.boxes_passed);
  EXPECT_GT(result.report.boxes_passed, result.report.hypotheses);
  EXPECT_GT(result.report.hypotheses, 0);
  EXPECT_EQ(result.report.segments, 3);
}

// What the messages and result.hpp say of each method.
TEST(Pipeline, WithThePapersMethodBoxesStandAndObjectnessIsEq6) {
  Scene scene = tableTop();
  const Config config = quickConfig();
  const Segmentation result = segment(scene.render(), config);
  ASSERT_FALSE(result.segments.empty());
  for (const Segment& segment : result.segments) {
    EXPECT_NEAR(segment.box.T_camera_box.linear().col(2).dot(result.table.normal), 1, 1e-9);
    EXPECT_GE(segment.objectness, config.filter.threshold);
    EXPECT_NEAR(segment.objectness, objectness::objectness(segment.cues, config.objectness), 1e-5);
  }
  EXPECT_GT(result.report.boxes_sampled, 0);
}

TEST(Pipeline, WithTheDefaultMethodBoxesMayLeanAndObjectnessIsAShare) {
  Scene scene = tableTop();
  // A board that leans by 40 degrees.
  Eigen::Isometry3d T_world_board(Eigen::Translation3d(0.45, -0.15, 0.083));
  T_world_board.rotate(Eigen::AngleAxisd(-40 * M_PI / 180, Eigen::Vector3d::UnitX()));
  scene.surfaces.push_back(moved(box({-0.08, -0.01, -0.1}, {0.08, 0.01, 0.1}), T_world_board));
  const Segmentation result = segment(scene.render(), Config{});
  ASSERT_TRUE(result.status.ok()) << result.status.message;
  ASSERT_FALSE(result.segments.empty());
  bool tilted = false;
  for (const Segment& segment : result.segments) {
    const Eigen::Vector3d cosines = segment.box.T_camera_box.linear().transpose() * result.table.normal;
    EXPECT_GE(cosines.z() + 1e-6, cosines.head<2>().cwiseAbs().maxCoeff()) << "z is the axis nearest to the normal";
    tilted = tilted || cosines.z() < std::cos(20 * M_PI / 180);
    for (const double share : {segment.objectness, double(segment.cues.free_space)}) {
      EXPECT_GE(share, 0);
      EXPECT_LE(share, 1);
    }
  }
  EXPECT_TRUE(tilted);
  for (const auto& figure : figuresOf(result.report)) EXPECT_NE(figure.first.substr(0, 6), "boxes_");
}

TEST(Pipeline, AnEmptyTableIsAValidResult) {
  Scene scene = tableTop();
  scene.surfaces.resize(2);
  const Segmentation result = segment(scene.render(), quickConfig());
  EXPECT_TRUE(result.status.ok()) << result.status.message;
  EXPECT_TRUE(result.segments.empty());
  EXPECT_EQ(result.labels(300, 320), 1);
}

TEST(Pipeline, NoTableIsSaid) {
  Scene scene = tableTop();
  scene.surfaces = {sphere({0, 0, 0.3}, 0.2)};
  const Segmentation result = segment(scene.render(), quickConfig());
  EXPECT_EQ(result.status.code, StatusCode::kNoTable);
  EXPECT_FALSE(result.status.message.empty());
  EXPECT_EQ(result.labels.rows, 480);
  EXPECT_EQ(cv::countNonZero(result.labels), 0);
}

TEST(Pipeline, AFrameWithoutAnyPointHasNoTable) {
  Frame frame;
  frame.camera = kinect();
  frame.points.assign(frame.size(), Eigen::Vector3f::Constant(std::nanf("")));
  EXPECT_FALSE(segment(frame, quickConfig()).status.ok());
}

TEST(Pipeline, ABadConfigurationIsNamed) {
  Scene scene = tableTop();
  Config config = quickConfig();
  config.search.angle_step_deg = -1;
  const Segmentation result = segment(scene.render(), config);
  EXPECT_EQ(result.status.code, StatusCode::kBadConfig);
  EXPECT_NE(result.status.message.find("search.angle_step_deg"), std::string::npos) << result.status.message;
}

TEST(Pipeline, CanBeCancelled) {
  Scene scene = tableTop();
  const std::atomic<bool> cancel{true};
  EXPECT_EQ(segment(scene.render(), quickConfig(), &cancel).status.code, StatusCode::kCancelled);
}

TEST(Pipeline, AVolumeTooLargeForMemoryIsRefused) {
  Scene scene = tableTop();
  Config config = quickConfig();
  config.volume.min_extent_m = 5;
  config.volume.voxel_m = 0.002;
  config.search.corner_step_m = config.search.size_step_xy_m = 0.02;
  const Segmentation result = segment(scene.render(), config);
  EXPECT_EQ(result.status.code, StatusCode::kVolumeTooLarge);
  EXPECT_NE(result.status.message.find("volume.voxel_m"), std::string::npos) << result.status.message;
}
