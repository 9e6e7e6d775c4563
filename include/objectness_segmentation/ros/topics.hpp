// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace objectness_segmentation {

/// Names as they are before remapping. Inputs are relative to the public namespace, so that
/// `ns:=/camera/depth_registered` is all a driver needs; outputs lie in the private one.
namespace topics {
constexpr char kPoints[] = "points";
constexpr char kCameraInfo[] = "camera_info";
constexpr char kDepth[] = "depth";
constexpr char kColor[] = "rgb";
constexpr char kObjects[] = "objects";
constexpr char kSegments[] = "segments";
constexpr char kMarkers[] = "markers";
constexpr char kPoses[] = "poses";
constexpr char kTable[] = "table";
constexpr char kLabelImage[] = "label_image";
constexpr char kProfile[] = "profile";
constexpr char kEdges[] = "debug/edges";
constexpr char kHidden[] = "debug/occlusion";
constexpr char kSuperpixels[] = "debug/superpixels";
constexpr char kDetections[] = "detections";
constexpr char kPlanningScene[] = "planning_scene";
constexpr char kSegmentOnce[] = "segment";
}  // namespace topics

/// Of a simulated camera in a bag: those of a driver, and the truth.
namespace bag_topics {
constexpr char kPoints[] = "/camera/depth_registered/points";
constexpr char kCameraInfo[] = "/camera/depth_registered/camera_info";
constexpr char kColor[] = "/camera/rgb/image_rect_color";
constexpr char kTransforms[] = "/tf";
constexpr char kStaticTransforms[] = "/tf_static";
constexpr char kTrueLabels[] = "/truth/labels";
constexpr char kTrueObjects[] = "/truth/objects";
}  // namespace bag_topics

/// Frames of a simulated camera.
namespace frames {
constexpr char kWorld[] = "world";
constexpr char kCameraBody[] = "camera_link";
constexpr char kCameraOptical[] = "camera_optical_frame";
}  // namespace frames

/// The node's name where nobody gave another one.
constexpr char kNodeName[] = "segment_objects";

/// Only the newest result matters to a subscriber.
constexpr int kPublisherQueueSize = 1;
/// Default of ~queue_size: clouds and camera_infos that wait for their partner.
constexpr int kSynchronizerQueueSize = 5;

}  // namespace objectness_segmentation
