// SPDX-License-Identifier: BSD-3-Clause
#include "ros/scene_bag_writer.hpp"

#include <objectness_segmentation/SegmentedObjectArray.h>
#include <tf2_msgs/TFMessage.h>

#include "objectness_segmentation/ros/topics.hpp"
#include "ros/cloud_output.hpp"
#include "ros/geometry_output.hpp"
#include "ros/scene_messages.hpp"

namespace objectness_segmentation {
namespace {

using objectness::sim::SimulatedFrame;
using objectness::sim::TrueObject;

tf2_msgs::TFMessage toTf(const Eigen::Isometry3d& T_parent_child, const ros::Time& stamp, const char* parent,
                         const char* child) {
  std_msgs::Header header;
  header.stamp = stamp;
  header.frame_id = parent;
  tf2_msgs::TFMessage message;
  message.transforms.push_back(toTransformMessage(T_parent_child, header, child));
  return message;
}

std::vector<int> pixelsOf(const cv::Mat_<ushort>& labels, int label) {
  std::vector<int> pixels;
  for (int i = 0; i < static_cast<int>(labels.total()); ++i) {
    if (labels(i / labels.cols, i % labels.cols) == label) pixels.push_back(i);
  }
  return pixels;
}

SegmentedObject toObject(const TrueObject& truth, const std::vector<int>& pixels, const objectness::Frame& frame,
                         const std_msgs::Header& header) {
  SegmentedObject object;
  object.header = object.indices.header = header;
  object.label = static_cast<std::uint32_t>(truth.label);
  object.pose = toPose(truth.box.T_camera_box);
  object.dimensions = toVector3(truth.box.size_m);
  object.indices.indices.assign(pixels.begin(), pixels.end());
  object.cloud = extractCloud(frame, pixels, header);
  return object;
}

SegmentedObjectArray toTruth(const SimulatedFrame& view, const objectness::Frame& frame,
                             const std_msgs::Header& header) {
  SegmentedObjectArray truth;
  truth.header = truth.table.header = header;
  const Eigen::Vector3f normal = view.table_normal.cast<float>();
  truth.table.values = {normal.x(), normal.y(), normal.z(), static_cast<float>(view.table_distance_m)};
  for (const TrueObject& object : view.objects) {
    if (object.hidden) continue;
    truth.objects.push_back(toObject(object, pixelsOf(view.images.true_labels, object.label), frame, header));
  }
  return truth;
}

}  // namespace

objectness::Status SceneBagWriter::write(const SimulatedFrame& view, const ros::Time& stamp) {
  const objectness::SceneImages& images = view.images;
  const auto frame = objectness::makeFrame(images.depth_mm, images.color, images.camera, {});
  if (!frame.ok()) return frame.status;
  std_msgs::Header header;
  header.stamp = stamp;
  header.frame_id = frames::kCameraOptical;

  if (!has_static_transform_) {
    bag_.writeLatched(bag_topics::kStaticTransforms, stamp,
                      toTf(opticalToBody(), stamp, frames::kCameraBody, frames::kCameraOptical));
    has_static_transform_ = true;
  }
  const Eigen::Isometry3d T_world_body = view.T_world_camera * opticalToBody().inverse();
  bag_.write(bag_topics::kTransforms, stamp, toTf(T_world_body, stamp, frames::kWorld, frames::kCameraBody));
  bag_.write(bag_topics::kCameraInfo, stamp, toCameraInfo(images.camera, header));
  bag_.write(bag_topics::kColor, stamp, toImageMessage(images.color, header));
  bag_.write(bag_topics::kPoints, stamp, toCloudMessage(frame.value, header));
  bag_.write(bag_topics::kTrueLabels, stamp, toImageMessage(images.true_labels, header));
  bag_.write(bag_topics::kTrueObjects, stamp, toTruth(view, frame.value, header));
  return bag_.status();
}

objectness::Status writeSceneBag(const std::string& path, const objectness::sim::Scene& scene,
                                 const SceneBagSettings& settings) {
  SceneBagWriter writer(path);
  objectness::Status status;
  for (int i = 0; i < settings.frames && status.ok(); ++i) {
    const ros::Time stamp = ros::Time(kFirstStamp_s, 0) + ros::Duration(i / settings.rate_hz);
    const Eigen::Isometry3d T_world_camera =
        settings.still ? scene.T_world_camera : objectness::sim::orbitPose(scene, i, settings.frames);
    status = writer.write(simulateFrame(scene, T_world_camera, settings.sensor, settings.noise_seed(i)), stamp);
  }
  const objectness::Status closed = writer.close();
  return status.ok() ? closed : status;
}

}  // namespace objectness_segmentation
