// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace objectness_segmentation {

/// Names as they are before remapping. Inputs are relative to the public namespace, so that
/// `ns:=/camera/depth_registered` is all a driver needs; outputs lie in the private one.
namespace topics {
constexpr char kPoints[] = "points";
constexpr char kCameraInfo[] = "camera_info";
constexpr char kObjects[] = "objects";
constexpr char kSegments[] = "segments";
constexpr char kMarkers[] = "markers";
}  // namespace topics

/// Only the newest result matters to a subscriber.
constexpr int kPublisherQueueSize = 1;
/// Default of ~queue_size: clouds and camera_infos that wait for their partner.
constexpr int kSynchronizerQueueSize = 5;

}  // namespace objectness_segmentation
