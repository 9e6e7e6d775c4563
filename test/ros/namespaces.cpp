// SPDX-License-Identifier: BSD-3-Clause
// Run by namespaces.test beside nodelet managers in several namespaces: starts the launch files, themselves in several
// namespaces, plays the driver, and looks whether the results come.
#include <algorithm>

#include "features_fixture.hpp"
#include "fixtures/temporary_folder.hpp"
#include "launch_process.hpp"
#include "ros/scene_bag_writer.hpp"
#include "sim/demo_scene.hpp"

namespace {

using namespace objectness_segmentation;
using namespace objectness_test;

struct Line {
  const char* name_space;  ///< of the launch file
  const char* arguments;
  const char* node;
  const char* input;  ///< clouds, or depth images of a camera_info beside them
  const char* camera_info;
};

class Namespaces : public Features {
 protected:
  void SetUp() override {}

  /// Sends clouds or depth images until one is answered.
  SegmentedObjectArrayConstPtr play(const Line& line) {
    const bool depth = std::string(line.input).find("image") != std::string::npos;
    const ros::Publisher inputs =
        depth ? nh_.advertise<Image>(line.input, 5) : nh_.advertise<PointCloud2>(line.input, 5);
    const ros::Publisher cameras = nh_.advertise<sensor_msgs::CameraInfo>(line.camera_info, 5);
    Listener<SegmentedObjectArray> objects(std::string(line.node) + "/objects");
    if (!waitUntil(
            [&] { return objects.connected() && inputs.getNumSubscribers() > 0 && cameras.getNumSubscribers() > 0; })) {
      return nullptr;
    }
    sensor_msgs::CameraInfo camera = goodCamera();
    camera.header = nextHeader();
    cameras.publish(camera);
    if (depth) {
      Image image = depthImage("16UC1");
      image.header = camera.header;
      inputs.publish(image);
    } else {
      inputs.publish(makeCloudMessage(frame_, {}, camera.header));
    }
    return objects.wait(camera.header.stamp);
  }
  void expectResults(const Line& line) {
    const auto result = play(line);
    ASSERT_TRUE(result) << "no answer";
    EXPECT_EQ(result->status, SegmentedObjectArray::OK) << result->message;
    EXPECT_EQ(result->objects.size(), 2u);
  }
};

TEST_F(Namespaces, OfManagersAndLaunchFilesDoNotMatter) {
  const Line lines[] = {
      {"", "segment.launch camera:=/camera/depth_registered manager:=/camera/camera_nodelet_manager",
       "/segment_objects", "/camera/depth_registered/points", "/camera/depth_registered/camera_info"},
      {"", "segment.launch camera:=/camera/depth_registered manager:=/manager", "/segment_objects",
       "/camera/depth_registered/points", "/camera/depth_registered/camera_info"},
      {"", "segment.launch camera:=camera/depth_registered manager:=robot/arm/manager name:=finder", "/finder",
       "/camera/depth_registered/points", "/camera/depth_registered/camera_info"},
      {"", "segment.launch manager:=/robot/arm/manager", "/segment_objects", "/points", "/camera_info"},
      {"/camera/depth_registered", "segment.launch manager:=/manager", "/camera/depth_registered/segment_objects",
       "/camera/depth_registered/points", "/camera/depth_registered/camera_info"},
      {"/robot", "segment.launch camera:=arm/eye manager:=arm/manager", "/robot/segment_objects",
       "/robot/arm/eye/points", "/robot/arm/eye/camera_info"},
      {"/robot/arm", "segment.launch manager:=/camera/camera_nodelet_manager points:=eye/points",
       "/robot/arm/segment_objects", "/robot/arm/eye/points", "/robot/arm/camera_info"},
      {"/robot/arm", "segment.launch camera:=eye", "/robot/arm/segment_objects", "/robot/arm/eye/points",
       "/robot/arm/eye/camera_info"},
      {"", "kinect.launch manager:=/camera/camera_nodelet_manager", "/segment_objects",
       "/camera/depth_registered/points", "/camera/depth_registered/camera_info"},
      {"/robot", "kinect.launch manager:=/robot/arm/manager", "/robot/segment_objects",
       "/camera/depth_registered/points", "/camera/depth_registered/camera_info"},
      {"", "realsense.launch manager:=/camera/camera_nodelet_manager", "/segment_objects",
       "/camera/aligned_depth_to_color/image_raw", "/camera/aligned_depth_to_color/camera_info"},
      {"/robot", "realsense.launch camera:=arm/eye manager:=arm/manager", "/robot/segment_objects",
       "/robot/arm/eye/aligned_depth_to_color/image_raw", "/robot/arm/eye/aligned_depth_to_color/camera_info"},
      {"/robot", "realsense.launch", "/robot/segment_objects", "/camera/aligned_depth_to_color/image_raw",
       "/camera/aligned_depth_to_color/camera_info"},
      {"", "segment.launch input:=depth manager:=/robot/arm/manager", "/segment_objects", "/image_rect",
       "/camera_info"}};
  for (const Line& line : lines) {
    SCOPED_TRACE(std::string(line.arguments) + " in " + line.name_space + "/");
    const LaunchProcess launch(line.name_space, line.arguments);
    expectResults(line);
  }
}

TEST_F(Namespaces, OfRemappingsAreThoseOfTheNodelet) {
  for (const char* manager : {"/manager", "/camera/camera_nodelet_manager", "/robot/arm/manager"}) {
    for (const std::string name_space : {"", "/robot"}) {
      SCOPED_TRACE(manager + (" with " + name_space) + "/finder");
      nodelet::NodeletLoad load;
      load.request.name = name_space + "/finder";
      load.request.type = "objectness_segmentation/SegmentObjects";
      load.request.remap_source_args = {"points", name_space + "/camera_info"};
      const std::string points = name_space + "/eye/points", camera_info = name_space + "/eye/camera_info";
      load.request.remap_target_args = {points, camera_info};
      ASSERT_TRUE(ros::service::waitForService(std::string(manager) + "/load_nodelet", kTimeout * 1000));
      ASSERT_TRUE(ros::service::call(std::string(manager) + "/load_nodelet", load) && load.response.success);
      expectResults({"", "", load.request.name.c_str(), points.c_str(), camera_info.c_str()});
      nodelet::NodeletUnload unload;
      unload.request.name = load.request.name;
      EXPECT_TRUE(ros::service::call(std::string(manager) + "/unload_nodelet", unload));
    }
  }
}

TEST_F(Namespaces, OfLaunchFilesThatPlayRecordingsDoNotMatter) {
  const TemporaryFolder folder;
  SceneBagSettings settings;
  settings.sensor.camera = {262.5, 262.5, 159.5, 119.5, 320, 240};
  settings.frames = 20;
  ASSERT_TRUE(writeSceneBag(folder / "in.bag", objectness::sim::makeDemoScene(1), settings).ok());
  for (const char* file : {"bag.launch", "demo.launch"}) {
    for (const std::string name_space : {"", "/robot/arm"}) {
      SCOPED_TRACE(file + (" in " + name_space) + "/");
      std::size_t answers = 0;
      const ros::Subscriber objects = nh_.subscribe<SegmentedObjectArray>(
          name_space + "/segment_objects/objects", 10, [&](const SegmentedObjectArrayConstPtr& answer) {
            EXPECT_EQ(answer->status, SegmentedObjectArray::OK) << answer->message;
            ++answers;
          });
      const LaunchProcess launch(name_space,
                                 std::string(file) + " rviz:=false play_args:=--loop bag:=" + (folder / "in.bag"));
      EXPECT_TRUE(waitUntil([&] { return answers > 1; }));
      bool simulated = false;
      EXPECT_TRUE(ros::param::get("/use_sim_time", simulated) && simulated);
      ros::master::V_TopicInfo topics;
      ros::master::getTopics(topics);
      EXPECT_TRUE(std::any_of(topics.begin(), topics.end(), [](const auto& topic) { return topic.name == "/clock"; }));
    }
    ros::param::del("/use_sim_time");
  }
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "namespaces_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
