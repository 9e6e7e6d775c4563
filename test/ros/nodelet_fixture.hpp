// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <nodelet/NodeletLoad.h>
#include <nodelet/NodeletUnload.h>
#include <objectness_segmentation/SegmentedObjectArray.h>
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "fixtures/ray_cast.hpp"
#include "fixtures/ros_messages.hpp"
#include "ros/scene_messages.hpp"
#include "wait_until.hpp"

namespace objectness_test {

using objectness_segmentation::SegmentedObjectArray;
using objectness_segmentation::SegmentedObjectArrayConstPtr;
using sensor_msgs::PointCloud2;

constexpr char kNode[] = "/segment_objects";

/// The newest message of a topic.
template <class Message>
class Listener {
 public:
  explicit Listener(const std::string& topic) { subscriber_ = nh_.subscribe(topic, 10, &Listener::receive, this); }

  /// The message with this stamp.
  boost::shared_ptr<const Message> wait(const ros::Time& stamp, double seconds = kTimeout) {
    waitUntil([&] { return newest_ && stampOf(*newest_) == stamp; }, seconds);
    return newest_ && stampOf(*newest_) == stamp ? newest_ : nullptr;
  }
  bool connected() const { return subscriber_.getNumPublishers() > 0; }

 private:
  static ros::Time stampOf(const visualization_msgs::MarkerArray& array) {
    return array.markers.empty() ? ros::Time() : array.markers[0].header.stamp;
  }
  template <class Other>
  static ros::Time stampOf(const Other& message) {
    return message.header.stamp;
  }
  void receive(const boost::shared_ptr<const Message>& message) { newest_ = message; }

  ros::NodeHandle nh_;
  ros::Subscriber subscriber_;
  boost::shared_ptr<const Message> newest_;
};

/// A second nodelet of the kind in the manager; its topics lie below /second.
class SecondNodelet {
 public:
  using Names = std::vector<std::pair<std::string, std::string>>;

  /// Parameters that tests set before: below /second.
  explicit SecondNodelet(const Names& remappings) {
    nodelet::NodeletLoad load;
    load.request.name = "/second";
    load.request.type = "objectness_segmentation/SegmentObjects";
    for (const auto& [from, to] : remappings) {
      load.request.remap_source_args.push_back(from);
      load.request.remap_target_args.push_back(to);
    }
    loaded_ = ros::service::call("/manager/load_nodelet", load) && load.response.success;
  }
  SecondNodelet(const std::string& points, const std::string& camera_info, const std::string& model = "")
      : SecondNodelet(withModel(points, camera_info, model)) {}
  ~SecondNodelet() {
    if (loaded_) {
      EXPECT_TRUE(unload());
    }
    ros::param::del("/second");
  }
  SecondNodelet(const SecondNodelet&) = delete;
  SecondNodelet& operator=(const SecondNodelet&) = delete;

  bool loaded() const { return loaded_; }
  bool unload() {
    nodelet::NodeletUnload unload;
    unload.request.name = "/second";
    loaded_ = !(ros::service::call("/manager/unload_nodelet", unload) && unload.response.success);
    return !loaded_;
  }

 private:
  static Names withModel(const std::string& points, const std::string& camera_info, const std::string& model) {
    ros::param::set("/second/model", model);
    return {{"points", points}, {"camera_info", camera_info}};
  }

  bool loaded_ = false;
};

struct TrueBox {
  Eigen::Vector3d low, high;

  Eigen::Vector3d centre() const { return 0.5 * (low + high); }
};

/// Two boxes on a table, seen from 45 degrees above.
class SegmentObjects : public ::testing::Test {
 protected:
  SegmentObjects() {
    scene_.camera = {262.5, 262.5, 159.5, 119.5, 320, 240};
    scene_.T_world_camera = lookAt({0, -0.65, 0.65}, {0, 0, 0.03});
    scene_.surfaces = {slab(-0.5, -0.35, 0.5, 0.35, 0)};
    for (const TrueBox& truth : boxes_) scene_.surfaces.push_back(box(truth.low, truth.high));
    frame_ = scene_.render();
    const std::string camera = ros::NodeHandle("~").param<std::string>("camera", "");
    cloud_publisher_ = nh_.advertise<PointCloud2>(camera + "/points", 5);
    camera_publisher_ = nh_.advertise<sensor_msgs::CameraInfo>(camera + "/camera_info", 5);
  }

  void SetUp() override {
    ASSERT_TRUE(ros::service::waitForService(std::string(kNode) + "/set_parameters", kTimeout * 1000));
    // What the test before subscribed to is forgotten.
    ASSERT_TRUE(waitUntil([&] { return inputsGone(); }));
  }

  bool inputsConnected() const {
    return cloud_publisher_.getNumSubscribers() > 0 && camera_publisher_.getNumSubscribers() > 0;
  }

  bool inputsGone() const { return cloud_publisher_.getNumSubscribers() + camera_publisher_.getNumSubscribers() == 0; }

  static std_msgs::Header nextHeader() {
    static int count = 0;
    return makeHeader(1000 + 0.1 * ++count, "some_camera/optical_frame");
  }

  void send(const PointCloud2& cloud, sensor_msgs::CameraInfo camera_info) {
    camera_info.header = cloud.header;
    camera_publisher_.publish(camera_info);
    cloud_publisher_.publish(cloud);
  }
  PointCloud2 goodCloud() const { return makeCloudMessage(frame_, {}, nextHeader()); }
  sensor_msgs::CameraInfo goodCamera() const { return objectness_segmentation::toCameraInfo(scene_.camera, {}); }

  SegmentedObjectArrayConstPtr segment(Listener<SegmentedObjectArray>& objects, const PointCloud2& cloud,
                                       const sensor_msgs::CameraInfo& camera_info) {
    if (!waitUntil([&] { return inputsConnected() && objects.connected(); })) return nullptr;
    send(cloud, camera_info);
    return objects.wait(cloud.header.stamp);
  }

  Eigen::Vector3d toWorld(const geometry_msgs::Point& p) const {
    return scene_.T_world_camera * Eigen::Vector3d(p.x, p.y, p.z);
  }

  const std::array<TrueBox, 2> boxes_{
      {{{-0.21, -0.04, 0}, {-0.09, 0.06, 0.14}}, {{0.08, -0.02, 0}, {0.22, 0.08, 0.10}}}};
  Scene scene_;
  objectness::Frame frame_;
  ros::NodeHandle nh_;
  ros::Publisher cloud_publisher_, camera_publisher_;
};

}  // namespace objectness_test
