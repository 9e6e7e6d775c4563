// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "common/angles.hpp"
#include "evaluation/box_overlap.hpp"
#include "objectness_segmentation/pipeline.hpp"
#include "sim/scene_generator.hpp"
#include "sim/simulated_frame.hpp"

using namespace objectness;

namespace {

struct Metrics {
  int objects = 0, over_half = 0, over_more = 0;  ///< intersection over union over .5 and .7
  double sum = 0, visible_sum = 0;

  double mean() const { return sum / objects; }
  double visibleMean() const { return visible_sum / objects; }
};

/// Of round things the best over turns of the true box: their yaw is nobody's.
double overlap(const sim::TrueObject& object, const OrientedBox& found) {
  const bool turns = object.kind != "box" && object.kind != "mug";
  double best = 0;
  for (int i = 0; i < (turns ? 18 : 1); ++i) {
    OrientedBox truth = object.box;
    truth.T_camera_box.rotate(Eigen::AngleAxisd(i * 5 * kDegree, Eigen::Vector3d::UnitZ()));
    best = std::max(best, evaluation::boxOverlap(truth, found));
  }
  return best;
}

/// Of the objects that were segmented well.
Metrics figuresOf(const std::string& level, sim::DepthSensor sensor, bool grouping = true) {
  Metrics figures;
  Config config;
  config.pipeline.method = grouping ? SegmentationMethod::kObjectness : SegmentationMethod::kPaper;
  for (std::uint32_t index = 0; index < 12; ++index) {
    sim::SceneRequest request;
    request.level = level;
    request.seed = 21;
    request.index = index;
    request.camera = sensor.camera;
    const auto scene = sim::generateScene(request);
    EXPECT_TRUE(scene.ok()) << scene.status.message;
    if (!scene.ok()) continue;
    const auto truth = sim::simulateFrame(scene.value, scene.value.T_world_camera, sensor, index);
    const Frame frame = makeFrame(truth.images.depth_mm, cv::Mat(), truth.images.camera, InputConfig()).value;
    const Segmentation result = segment(frame, config);
    for (const sim::TrueObject& object : truth.objects) {
      const int own = cv::countNonZero(truth.images.true_labels == object.label);
      for (const Segment& found : result.segments) {
        int shared = 0;
        for (const int pixel : found.pixels) shared += truth.images.true_labels(pixel) == object.label;
        if (object.hidden || shared < 0.75 * (own + static_cast<int>(found.pixels.size()) - shared)) continue;
        const double whole = overlap(object, found.box);
        ++figures.objects;
        figures.sum += whole;
        figures.over_half += whole > 0.5;
        figures.over_more += whole > 0.7;
        figures.visible_sum += overlap(object, found.visible_box);
      }
    }
  }
  return figures;
}

}  // namespace

TEST(WholeBoxFigures, OfStructuredLight) {
  const Metrics shapes = figuresOf("shapes", sim::DepthSensor());
  ASSERT_GT(shapes.objects, 30);
  EXPECT_GT(shapes.mean(), 0.82) << shapes.objects;
  EXPECT_GT(shapes.over_half, 0.95 * shapes.objects);
  EXPECT_GT(shapes.over_more, 0.8 * shapes.objects);
  EXPECT_GT(shapes.mean(), shapes.visibleMean() + 0.15);
  const Metrics stacked = figuresOf("stacked", sim::DepthSensor());
  ASSERT_GT(stacked.objects, 20);
  EXPECT_GT(stacked.mean(), 0.7);
}

TEST(WholeBoxFigures, OfStereo) {
  sim::DepthSensor stereo;
  stereo.kind = sim::SensorKind::kStereo;
  const Metrics shapes = figuresOf("shapes", stereo);
  ASSERT_GT(shapes.objects, 30);
  EXPECT_GT(shapes.mean(), 0.73);
  EXPECT_GT(shapes.over_half, 0.9 * shapes.objects);
  EXPECT_GT(shapes.mean(), shapes.visibleMean() + 0.1);
}
