// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "objectness_segmentation/io/scene_folder.hpp"
#include "objectness_segmentation/objectness/box.hpp"
#include "sim/depth_sensor.hpp"
#include "sim/scene.hpp"

namespace objectness::sim {

// An object of which less is to be seen is hidden: nobody can be asked to find it.
constexpr double kMinVisible = 0.05;
constexpr int kMinVisiblePixels = 100;

/// The truth about one object in one picture.
struct TrueObject {
  int label = 0;
  std::string kind;
  double visible = 0;      ///< share of the surface's pixels that nothing covers, of those it would have alone
  bool hidden = true;      ///< under kMinVisible, or fewer than kMinVisiblePixels with depth: has no label in the image
  cv::Rect extent;         ///< of its label in the image; empty when hidden
  cv::Point seed{-1, -1};  ///< the pixel deepest within its label; (-1, -1) when hidden
  OrientedBox box;         ///< tight, axes of the object's own frame; camera's optical frame
};

/// One picture of a scene and the truth about it. In images.true_labels the pixels of hidden objects are void (0);
/// every other pixel with depth has the label of the surface that its depth is from.
struct SimulatedFrame {
  std::string level;
  SceneImages images;
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();  ///< optical frame
  std::vector<TrueObject> objects;                                   ///< by label, hidden ones included
  std::vector<SceneBackground> background;                           ///< of the scene
  Eigen::Vector3d table_normal = Eigen::Vector3d::Zero();  ///< of what they stand on; camera's optical frame, upwards
  double table_distance_m = 0;                             ///< of the camera from the plane that they stand on
};

/// The same for the same arguments, with any number of threads.
SimulatedFrame simulateFrame(const Scene& scene, const Eigen::Isometry3d& T_world_camera, const DepthSensor& sensor,
                             std::uint32_t seed);

/// A seed of its own for the noise of every frame of every scene.
std::uint32_t noiseSeed(std::uint32_t seed, std::uint32_t index, int frame);

}  // namespace objectness::sim
