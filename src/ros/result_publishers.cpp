// SPDX-License-Identifier: BSD-3-Clause
#include "ros/result_publishers.hpp"

#include <objectness_segmentation/StageTimes.h>

#include <boost/make_shared.hpp>

#include "objectness_segmentation/ros/output_conversions.hpp"
#include "objectness_segmentation/ros/topics.hpp"
#include "ros/debug_conversions.hpp"

namespace objectness_segmentation {
namespace {

/// Publishes what make() returns, when somebody subscribes. The message is handed on without a copy and not touched
/// any more.
template <class Make>
void publishTo(const ros::Publisher& publisher, const Make& make) {
  if (publisher.getNumSubscribers() == 0) return;
  publisher.publish(boost::make_shared<decltype(make())>(make()));
}

}  // namespace

void ResultPublishers::advertise(ros::NodeHandle& nh, bool latch, const ros::SubscriberStatusCallback& changed) {
  const auto open = [&](auto message, const char* topic) {
    return nh.advertise<decltype(message)>(topic, kPublisherQueueSize, changed, changed, {}, latch);
  };
  objects_ = open(SegmentedObjectArray(), topics::kObjects);
  segments_ = open(sensor_msgs::PointCloud2(), topics::kSegments);
  markers_ = open(visualization_msgs::MarkerArray(), topics::kMarkers);
  poses_ = open(geometry_msgs::PoseArray(), topics::kPoses);
  table_ = open(SegmentedTable(), topics::kTable);
  label_image_ = open(sensor_msgs::Image(), topics::kLabelImage);
  profile_ = open(StageTimes(), topics::kProfile);
  edges_ = open(sensor_msgs::PointCloud2(), topics::kEdges);
  hidden_ = open(visualization_msgs::MarkerArray(), topics::kHidden);
  superpixels_ = open(sensor_msgs::PointCloud2(), topics::kSuperpixels);
  optional_.advertise(nh, latch, changed);
}

bool ResultPublishers::haveSubscribers() const {
  for (const ros::Publisher* publisher : {&objects_, &segments_, &markers_, &poses_, &table_, &label_image_, &profile_,
                                          &edges_, &hidden_, &superpixels_}) {
    if (publisher->getNumSubscribers() > 0) return true;
  }
  return optional_.haveSubscribers();
}

SegmentedObjectArrayConstPtr ResultPublishers::publish(ProcessedFrame& frame, const std_msgs::Header& input,
                                                       const std::string& target_frame,
                                                       const objectness::Config& config, const FrameFacts& facts,
                                                       bool objects_wanted) {
  SegmentedFrame& result = frame.result;
  // What takes the camera's view comes before the move to another frame.
  std::vector<Eigen::Vector3d> hidden;
  if (hidden_.getNumSubscribers() > 0) hidden = hiddenVoxels(result, config);
  std_msgs::Header header = input;
  if (frame.T_target_camera) {
    moveToFrame(result, *frame.T_target_camera);
    header.frame_id = target_frame;
  }

  SegmentedObjectArrayConstPtr objects;
  const OutputMessages outputs(result, header, facts);
  if (objects_wanted || objects_.getNumSubscribers() > 0) objects = outputs.objects();
  if (objects_.getNumSubscribers() > 0) objects_.publish(objects);
  if (segments_.getNumSubscribers() > 0) segments_.publish(outputs.segments());
  if (markers_.getNumSubscribers() > 0) markers_.publish(outputs.markers());
  publishTo(poses_, [&] { return toPoses(result, header); });
  publishTo(table_, [&] { return toTableMessage(result, header); });
  publishTo(label_image_, [&] { return toLabelImage(result, input); });
  publishTo(edges_, [&] { return toEdgesCloud(result, header); });
  publishTo(hidden_, [&] { return toHiddenMarkers(result, hidden, config.volume.voxel_m, header); });
  publishTo(superpixels_, [&] { return toSuperpixelsCloud(result, header); });
  optional_.publish(result, header);
  publishProfile(frame, input, facts);
  return objects;
}

void ResultPublishers::publishProfile(const ProcessedFrame& frame, const std_msgs::Header& input,
                                      const FrameFacts& facts) const {
  publishTo(profile_, [&] {
    StageTimes message;
    message.header = input;
    const auto add = [&message](const std::string& stage, double milliseconds) {
      message.stages.push_back(stage);
      message.milliseconds.push_back(static_cast<float>(milliseconds));
    };
    add("transforms", frame.transforms_ms);
    add("conversion", frame.result.conversion_ms);
    add("fusion", frame.result.fusion_ms);
    for (const auto& [stage, milliseconds] : frame.result.segmentation.report.timings_ms) {
      if (stage != "total") add(stage, milliseconds);
    }
    add("tracking", frame.result.tracking_ms);
    add("total", 1e3 * facts.processing_time_s);
    message.age = static_cast<float>(ros::Time::now().toSec() - input.stamp.toSec());
    return message;
  });
}

}  // namespace objectness_segmentation
