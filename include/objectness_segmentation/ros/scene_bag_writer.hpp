// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "objectness_segmentation/io/scene_folder.hpp"
#include "objectness_segmentation/ros/bag_output.hpp"

namespace objectness_segmentation {

/// An object as it is: the box around it, and its pixels by their label.
struct TrueObject {
  ushort label = 0;               ///< in SceneImages::true_labels, of its first part; the nine above it are its, too
  Eigen::Isometry3d T_world_box;  ///< centre of the box, z up
  Eigen::Vector3d size_m;
};

/// What a camera with known surroundings takes at one time.
struct SceneView {
  ros::Time stamp;
  objectness::SceneImages images;
  Eigen::Isometry3d T_world_camera;  ///< optical frame
  std::vector<TrueObject> objects;
};

/// Writes views as the bag that a driver's topics would give, with the truth beside them; topics and frames are in
/// topics.hpp. /tf holds the camera's way, /tf_static its optical frame. /truth/labels are the label images,
/// /truth/objects the boxes and pixels in the camera's optical frame, label being that of the image.
class SceneBagWriter {
 public:
  explicit SceneBagWriter(const std::string& path) : bag_(path) {}

  /// Stamps must not be 0. An error stays.
  objectness::Status write(const SceneView& view);
  objectness::Status close() { return bag_.close(); }

 private:
  BagOutput bag_;
  bool has_static_transform_ = false;
};

}  // namespace objectness_segmentation
