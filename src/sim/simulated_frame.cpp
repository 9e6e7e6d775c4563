// SPDX-License-Identifier: BSD-3-Clause
#include "sim/simulated_frame.hpp"

#include <opencv2/imgproc.hpp>

#include "sim/random.hpp"

namespace objectness::sim {
namespace {

/// Looks for the object in the label image, and takes its label out again when it is hidden.
TrueObject observe(const SceneObject& object, const SurfaceView& view, const Eigen::Isometry3d& T_camera_world,
                   cv::Mat_<ushort>& labels) {
  TrueObject truth;
  truth.label = object.label;
  truth.kind = object.kind;
  truth.box = {T_camera_world * object.T_world_box, object.size_m};
  const int alone = view.pixels_alone.at(object.label);
  if (alone > 0) truth.visible = static_cast<double>(view.pixels_seen.at(object.label)) / alone;
  const cv::Mat mask = labels == object.label;
  truth.hidden = truth.visible < kMinVisible || cv::countNonZero(mask) < kMinVisiblePixels;
  if (truth.hidden) {
    labels.setTo(0, mask);
    return truth;
  }
  truth.extent = cv::boundingRect(mask);
  cv::Mat framed, depth_within;  // the image's border counts as the object's
  cv::copyMakeBorder(mask, framed, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  cv::distanceTransform(framed, depth_within, cv::DIST_L1, 3);
  cv::minMaxLoc(depth_within, nullptr, nullptr, nullptr, &truth.seed);
  truth.seed -= cv::Point(1, 1);
  return truth;
}

}  // namespace

SimulatedFrame simulateFrame(const Scene& scene, const Eigen::Isometry3d& T_world_camera, const DepthSensor& sensor,
                             std::uint32_t seed) {
  const SurfaceView view = viewSurfaces(scene.bodies, T_world_camera, sensor);
  const Eigen::Isometry3d T_camera_world = T_world_camera.inverse();
  SimulatedFrame frame;
  frame.level = scene.level;
  frame.background = scene.background;
  frame.images = takePicture(view, sensor, seed);
  frame.T_world_camera = T_world_camera;
  frame.table_normal = T_camera_world.linear().col(2);
  frame.table_distance_m = T_world_camera.translation().z();
  for (const SceneObject& object : scene.objects) {
    frame.objects.push_back(observe(object, view, T_camera_world, frame.images.true_labels));
  }
  return frame;
}

std::uint32_t noiseSeed(std::uint32_t seed, std::uint32_t index, int frame) {
  return Random({seed, index, static_cast<std::uint32_t>(frame)}).bits();
}

}  // namespace objectness::sim
