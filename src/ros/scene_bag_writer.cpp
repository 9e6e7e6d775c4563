// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/ros/scene_bag_writer.hpp"

#include <objectness_segmentation/SegmentedObjectArray.h>
#include <tf2_msgs/TFMessage.h>

#include "cloud_output.hpp"
#include "geometry_output.hpp"
#include "objectness_segmentation/ros/scene_messages.hpp"
#include "objectness_segmentation/ros/topics.hpp"

namespace objectness_segmentation {
namespace {

constexpr int kLabelsPerObject = 10;

tf2_msgs::TFMessage toTf(const Eigen::Isometry3d& T_parent_child, const ros::Time& stamp, const char* parent,
                         const char* child) {
  std_msgs::Header header;
  header.stamp = stamp;
  header.frame_id = parent;
  tf2_msgs::TFMessage message;
  message.transforms.push_back(toTransformMessage(T_parent_child, header, child));
  return message;
}

std::vector<int> pixelsOf(const cv::Mat_<ushort>& labels, ushort first_label) {
  std::vector<int> pixels;
  for (int i = 0; i < static_cast<int>(labels.total()); ++i) {
    const int label = labels(i / labels.cols, i % labels.cols);
    if (label >= first_label && label < first_label + kLabelsPerObject) pixels.push_back(i);
  }
  return pixels;
}

SegmentedObjectArray toTruth(const SceneView& view, const objectness::Frame& frame, const std_msgs::Header& header) {
  SegmentedObjectArray truth;
  truth.header = truth.table.header = header;
  for (const TrueObject& object : view.objects) {
    SegmentedObject message;
    message.header = message.indices.header = header;
    message.label = object.label;
    message.pose = toPose(view.T_world_camera.inverse() * object.T_world_box);
    message.dimensions.x = object.size_m.x();
    message.dimensions.y = object.size_m.y();
    message.dimensions.z = object.size_m.z();
    const std::vector<int> pixels = pixelsOf(view.images.true_labels, object.label);
    message.indices.indices.assign(pixels.begin(), pixels.end());
    message.cloud = extractCloud(frame, pixels, header);
    truth.objects.push_back(std::move(message));
  }
  return truth;
}

}  // namespace

objectness::Status SceneBagWriter::write(const SceneView& view) {
  const auto& images = view.images;
  const auto frame = objectness::makeFrame(images.depth_mm, images.color, images.camera, {});
  if (!frame.ok()) return frame.status;
  std_msgs::Header header;
  header.stamp = view.stamp;
  header.frame_id = frames::kCameraOptical;

  if (!has_static_transform_) {
    bag_.writeLatched(bag_topics::kStaticTransforms, view.stamp,
                      toTf(opticalToBody(), view.stamp, frames::kCameraBody, frames::kCameraOptical));
    has_static_transform_ = true;
  }
  const Eigen::Isometry3d T_world_body = view.T_world_camera * opticalToBody().inverse();
  bag_.write(bag_topics::kTransforms, view.stamp, toTf(T_world_body, view.stamp, frames::kWorld, frames::kCameraBody));
  bag_.write(bag_topics::kCameraInfo, view.stamp, toCameraInfo(images.camera, header));
  if (!images.color.empty()) bag_.write(bag_topics::kColor, view.stamp, toImageMessage(images.color, header));
  bag_.write(bag_topics::kPoints, view.stamp, toCloudMessage(frame.value, header));
  if (!images.true_labels.empty()) {
    bag_.write(bag_topics::kTrueLabels, view.stamp, toImageMessage(images.true_labels, header));
    bag_.write(bag_topics::kTrueObjects, view.stamp, toTruth(view, frame.value, header));
  }
  return bag_.status();
}

}  // namespace objectness_segmentation
