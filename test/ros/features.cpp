// SPDX-License-Identifier: BSD-3-Clause
// Run by features.test beside the nodelet: inputs, outputs, the service and tf. Limits are in wall time.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/PoseArray.h>
#include <objectness_segmentation/SegmentOnce.h>
#include <objectness_segmentation/SegmentedTable.h>
#include <objectness_segmentation/StageTimes.h>
#include <sensor_msgs/Image.h>
#include <tf2_ros/transform_broadcaster.h>

#include <future>
#include <map>
#include <set>

#include "nodelet_fixture.hpp"

namespace {

using namespace objectness_segmentation;
using namespace objectness_test;
using sensor_msgs::Image;

class Features : public SegmentObjects {
 protected:
  /// The service of a nodelet, called from another thread.
  static std::future<SegmentOnce::Response> request(const std::string& node, double timeout_s) {
    return std::async(std::launch::async, [=] {
      SegmentOnce call;
      call.request.timeout = static_cast<float>(timeout_s);
      if (!ros::service::call(node + "/segment", call)) call.response.result.message = "the call failed";
      return call.response;
    });
  }
  template <class T>
  static bool isReady(const std::future<T>& future) {
    return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  }

  std::string points() const { return cloud_publisher_.getTopic(); }
  std::string cameraInfo() const { return camera_publisher_.getTopic(); }

  /// What a stamp-and-frame header becomes when the clock is this process's.
  static std_msgs::Header headerNow(double ahead_s = 0) {
    std_msgs::Header header;
    header.stamp = ros::Time(ros::Time::now().toSec() + ahead_s);
    header.frame_id = "some_camera/optical_frame";
    return header;
  }

  Image depthImage(const char* encoding) const {
    Image image;
    image.header = nextHeader();
    image.width = static_cast<std::uint32_t>(frame_.width());
    image.height = static_cast<std::uint32_t>(frame_.height());
    image.encoding = encoding;
    const bool metres = image.encoding == "32FC1";
    image.step = image.width * (metres ? 4 : 2);
    image.data.resize(std::size_t{image.step} * image.height);
    for (int i = 0; i < frame_.size(); ++i) {
      const float z = frame_.points[i].z();
      const auto mm = static_cast<std::uint16_t>(std::isnan(z) ? 0 : std::lround(1000 * z));
      std::memcpy(image.data.data() + std::size_t(i) * (metres ? 4 : 2), metres ? static_cast<const void*>(&z) : &mm,
                  metres ? 4 : 2);
    }
    return image;
  }
};

TEST_F(Features, EveryOutputIsAboutTheSameFrame) {
  const std::string node = kNode;
  Listener<SegmentedObjectArray> objects(node + "/objects");
  Listener<geometry_msgs::PoseArray> poses(node + "/poses");
  Listener<SegmentedTable> table(node + "/table");
  Listener<Image> labels(node + "/label_image");
  Listener<StageTimes> profile(node + "/profile");
  Listener<PointCloud2> edges(node + "/debug/edges"), superpixels(node + "/debug/superpixels");
  Listener<visualization_msgs::MarkerArray> hidden(node + "/debug/occlusion");
  ASSERT_TRUE(waitUntil([&] {
    return poses.connected() && table.connected() && labels.connected() && profile.connected() && edges.connected() &&
           superpixels.connected() && hidden.connected();
  }));
  const PointCloud2 cloud = goodCloud();
  const auto result = segment(objects, cloud, goodCamera());
  ASSERT_TRUE(result);
  ASSERT_EQ(result->objects.size(), 2u);

  const auto image = labels.wait(cloud.header.stamp);
  ASSERT_TRUE(image);
  EXPECT_EQ(image->header.frame_id, cloud.header.frame_id);
  for (const auto& object : result->objects) {
    EXPECT_GT(object.id, 0u);
    for (const int pixel : object.indices.indices) {
      EXPECT_EQ(image->data[2 * pixel] | image->data[2 * pixel + 1] << 8, static_cast<int>(object.label));
    }
  }
  const auto pose_array = poses.wait(cloud.header.stamp);
  ASSERT_TRUE(pose_array);
  ASSERT_EQ(pose_array->poses.size(), 2u);
  EXPECT_EQ(pose_array->poses[1], result->objects[1].pose);
  const auto plane = table.wait(cloud.header.stamp);
  ASSERT_TRUE(plane);
  EXPECT_TRUE(plane->found);
  EXPECT_EQ(plane->plane.values, result->table.values);
  ASSERT_GE(plane->polygon.points.size(), 4u);
  for (const auto& p : plane->polygon.points) {
    geometry_msgs::Point corner;
    corner.x = p.x, corner.y = p.y, corner.z = p.z;
    EXPECT_NEAR(toWorld(corner).z(), 0, 0.005);
  }
  const auto times = profile.wait(cloud.header.stamp);
  ASSERT_TRUE(times);
  ASSERT_EQ(times->stages.size(), times->milliseconds.size());
  const std::set<std::string> stages(times->stages.begin(), times->stages.end());
  for (const char* stage : {"conversion", "normals", "table", "superpixels", "selection", "tracking", "total"}) {
    EXPECT_EQ(stages.count(stage), 1u) << stage;
  }
  const auto edge_cloud = edges.wait(cloud.header.stamp), superpixel_cloud = superpixels.wait(cloud.header.stamp);
  ASSERT_TRUE(edge_cloud && superpixel_cloud);
  EXPECT_GT(edge_cloud->width, 100u);
  EXPECT_GT(superpixel_cloud->width, 1000u);
  const auto voxels = hidden.wait(cloud.header.stamp);
  ASSERT_TRUE(voxels);
  ASSERT_EQ(voxels->markers.size(), 2u);
  EXPECT_GT(voxels->markers[1].points.size(), 100u);
}

TEST_F(Features, AnyOutputAloneKeepsTheInputs) {
  const auto expectInputs = [&](auto message, const char* topic) {
    {
      const Listener<decltype(message)> only(std::string(kNode) + topic);
      EXPECT_TRUE(waitUntil([&] { return inputsConnected(); })) << topic;
    }
    EXPECT_TRUE(waitUntil([&] { return inputsGone(); })) << topic;
  };
  expectInputs(geometry_msgs::PoseArray(), "/poses");
  expectInputs(SegmentedTable(), "/table");
  expectInputs(Image(), "/label_image");
  expectInputs(StageTimes(), "/profile");
  expectInputs(PointCloud2(), "/debug/edges");
  expectInputs(visualization_msgs::MarkerArray(), "/debug/occlusion");
}

TEST_F(Features, TheServiceAnswersWhenNobodySubscribes) {
  auto answer = request(kNode, 30);
  ASSERT_TRUE(waitUntil([&] { return inputsConnected(); })) << "subscribed for the request";
  send(goodCloud(), goodCamera());
  ASSERT_TRUE(waitUntil([&] { return isReady(answer); }));
  const SegmentedObjectArray result = answer.get().result;
  EXPECT_EQ(result.status, SegmentedObjectArray::OK) << result.message;
  EXPECT_EQ(result.objects.size(), 2u);
  EXPECT_TRUE(waitUntil([&] { return inputsGone(); })) << "and not any longer";
}

TEST_F(Features, TheServiceTakesNoFrameFromBeforeTheRequest) {
  auto answer = request(kNode, 30);
  ASSERT_TRUE(waitUntil([&] { return inputsConnected(); }));
  send(makeCloudMessage(frame_, {}, headerNow(-1.0)), goodCamera());
  EXPECT_FALSE(waitUntil([&] { return isReady(answer); }, 1.5));
  const PointCloud2 fresh = makeCloudMessage(frame_, {}, headerNow());
  send(fresh, goodCamera());
  ASSERT_TRUE(waitUntil([&] { return isReady(answer); }));
  EXPECT_EQ(answer.get().result.header.stamp, fresh.header.stamp);
}

TEST_F(Features, TheServiceSaysWhatIsMissing) {
  auto answer = request(kNode, 0.5);
  ASSERT_TRUE(waitUntil([&] { return isReady(answer); }, 10));
  const SegmentedObjectArray result = answer.get().result;
  EXPECT_EQ(result.status, SegmentedObjectArray::NO_INPUT);
  EXPECT_NE(result.message.find("no messages on " + points()), std::string::npos) << result.message;
}

TEST_F(Features, AFrameThatCannotBeSegmentedAnswersTheService) {
  auto answer = request(kNode, 30);
  ASSERT_TRUE(waitUntil([&] { return inputsConnected(); }));
  PointCloud2 cloud = goodCloud();
  cloud.data.resize(10);
  send(cloud, goodCamera());
  ASSERT_TRUE(waitUntil([&] { return isReady(answer); }));
  EXPECT_EQ(answer.get().result.status, SegmentedObjectArray::BAD_INPUT);
}

TEST_F(Features, UnloadsWhileTheServiceWaits) {
  SecondNodelet second(SecondNodelet::Names{{"points", "/nowhere"}, {"camera_info", "/nowhere_info"}});
  ASSERT_TRUE(second.loaded());
  ASSERT_TRUE(ros::service::waitForService("/second/segment", kTimeout * 1000));
  auto answer = request("/second", 60);
  ros::WallDuration(0.5).sleep();
  EXPECT_FALSE(isReady(answer));
  const ros::WallTime start = ros::WallTime::now();
  EXPECT_TRUE(second.unload());
  EXPECT_LT((ros::WallTime::now() - start).toSec(), 1.0);
  EXPECT_TRUE(waitUntil([&] { return isReady(answer); }, 5));
}

TEST_F(Features, TakesDepthImages) {
  ros::param::set("/second/input", "depth");
  const SecondNodelet second(
      SecondNodelet::Names{{"depth", "/d435/depth"}, {"camera_info", "/d435/camera_info"}, {"rgb", "/d435/rgb"}});
  ASSERT_TRUE(second.loaded());
  const ros::Publisher depths = nh_.advertise<Image>("/d435/depth", 5), colors = nh_.advertise<Image>("/d435/rgb", 5);
  const ros::Publisher cameras = nh_.advertise<sensor_msgs::CameraInfo>("/d435/camera_info", 5);
  EXPECT_FALSE(waitUntil([&] { return depths.getNumSubscribers() + colors.getNumSubscribers() > 0; }, 0.5));
  Listener<SegmentedObjectArray> objects("/second/objects");
  ASSERT_TRUE(waitUntil([&] {
    return objects.connected() && depths.getNumSubscribers() > 0 && cameras.getNumSubscribers() > 0 &&
           colors.getNumSubscribers() > 0;
  }));
  struct Case {
    const char* encoding;
    int color_width;  ///< 0: none
    int status;
    std::size_t fields;  ///< of an object's cloud
  };
  const Case cases[] = {{"16UC1", 0, SegmentedObjectArray::OK, 3},
                        {"32FC1", 0, SegmentedObjectArray::OK, 3},
                        {"32FC1", 320, SegmentedObjectArray::OK, 4},
                        {"16UC1", 100, SegmentedObjectArray::OK, 3},
                        {"8UC1", 0, SegmentedObjectArray::BAD_INPUT, 0}};
  for (const Case& expected : cases) {
    const Image depth = depthImage(expected.encoding);
    sensor_msgs::CameraInfo camera = goodCamera();
    camera.header = depth.header;
    if (expected.color_width > 0) {
      Image color;
      color.header = depth.header;
      color.encoding = "rgb8";
      color.width = static_cast<std::uint32_t>(expected.color_width);
      color.height = 240;
      color.step = 3 * color.width;
      color.data.assign(std::size_t{color.step} * color.height, 77);
      colors.publish(color);
      ros::WallDuration(0.3).sleep();  // it may come on the heels of the depth image, and need not be waited for
    }
    cameras.publish(camera);
    depths.publish(depth);
    const auto result = objects.wait(depth.header.stamp);
    ASSERT_TRUE(result) << expected.encoding;
    EXPECT_EQ(result->status, expected.status) << result->message;
    ASSERT_EQ(result->objects.size(), expected.status == SegmentedObjectArray::OK ? 2u : 0u);
    for (const auto& object : result->objects) EXPECT_EQ(object.cloud.fields.size(), expected.fields);
    ros::WallDuration(0.2).sleep();
  }
}

TEST_F(Features, TakesCloudsAloneWhenThereIsNoCameraInfo) {
  const SecondNodelet second(SecondNodelet::Names{{"points", points()}, {"camera_info", "/nobody/camera_info"}});
  ASSERT_TRUE(second.loaded());
  Listener<SegmentedObjectArray> objects("/second/objects");
  ASSERT_TRUE(waitUntil([&] { return objects.connected() && cloud_publisher_.getNumSubscribers() > 0; }));
  SegmentedObjectArrayConstPtr result;
  for (int i = 0; i < 20 && !result; ++i) {
    const PointCloud2 cloud = goodCloud();
    cloud_publisher_.publish(cloud);
    result = objects.wait(cloud.header.stamp, 0.5);
  }
  ASSERT_TRUE(result);
  EXPECT_EQ(result->status, SegmentedObjectArray::OK) << result->message;
  EXPECT_EQ(result->objects.size(), 2u);
}

TEST_F(Features, SaysHowFarUnsynchronizedInputsAreApart) {
  std::string message;
  const ros::Subscriber diagnostics = nh_.subscribe<diagnostic_msgs::DiagnosticArray>(
      "/diagnostics", 10, [&message](const diagnostic_msgs::DiagnosticArrayConstPtr& array) {
        for (const auto& entry : array->status) {
          if (entry.name.find("segment_objects: segmentation") != std::string::npos &&
              entry.level == diagnostic_msgs::DiagnosticStatus::WARN) {
            message = entry.message;
          }
        }
      });
  Listener<SegmentedObjectArray> objects(std::string(kNode) + "/objects");
  ASSERT_TRUE(waitUntil([&] { return inputsConnected(); }));
  EXPECT_TRUE(waitUntil(
      [&] {
        const PointCloud2 cloud = goodCloud();
        sensor_msgs::CameraInfo camera = goodCamera();
        camera.header = cloud.header;
        camera.header.stamp -= ros::Duration(0.03);
        camera_publisher_.publish(camera);
        cloud_publisher_.publish(cloud);
        ros::WallDuration(0.1).sleep();
        return message.find("0.030 s apart") != std::string::npos;
      },
      20))
      << message;
}

/// Nodelets that ask for tf.
class Frames : public Features {
 protected:
  void SetUp() override {
    Features::SetUp();
    ros::param::set("/second/target_frame", "base");
    ros::param::set("/second/up_frame", "base");
    ros::param::set("/second/fixed_frame", "base");
  }
  void sendPose(const std_msgs::Header& header, const Eigen::Isometry3d& T_base_camera) {
    std_msgs::Header base = header;
    base.frame_id = "base";
    broadcaster_.sendTransform(toTransformMessage(T_base_camera, base, header.frame_id));
  }
  /// Sends until the nodelet listens to tf.
  SegmentedObjectArrayConstPtr segmentIn(Listener<SegmentedObjectArray>& objects, const Eigen::Isometry3d& pose) {
    SegmentedObjectArrayConstPtr result;
    for (int i = 0; i < 20 && (!result || result->status == SegmentedObjectArray::NO_TRANSFORM); ++i) {
      const PointCloud2 cloud = goodCloud();
      sendPose(cloud.header, pose);
      result = segment(objects, cloud, goodCamera());
    }
    return result;
  }

  tf2_ros::TransformBroadcaster broadcaster_;
};

TEST_F(Frames, MissingTransformsAreSaidInTime) {
  const SecondNodelet second(points(), cameraInfo());
  ASSERT_TRUE(second.loaded());
  Listener<SegmentedObjectArray> objects("/second/objects");
  ASSERT_TRUE(waitUntil([&] { return inputsConnected() && objects.connected(); }));
  const PointCloud2 cloud = goodCloud();
  const ros::WallTime start = ros::WallTime::now();
  const auto result = segment(objects, cloud, goodCamera());
  ASSERT_TRUE(result);
  EXPECT_LT((ros::WallTime::now() - start).toSec(), 2.0);
  EXPECT_EQ(result->status, SegmentedObjectArray::NO_TRANSFORM);
  EXPECT_NE(result->message.find("base"), std::string::npos) << result->message;
  EXPECT_TRUE(result->objects.empty());
}

TEST_F(Frames, ResultsAreMovedToTheTargetFrame) {
  const SecondNodelet second(points(), cameraInfo());
  ASSERT_TRUE(second.loaded());
  Listener<SegmentedObjectArray> objects("/second/objects");
  const auto result = segmentIn(objects, scene_.T_world_camera);
  ASSERT_TRUE(result);
  ASSERT_EQ(result->status, SegmentedObjectArray::OK) << result->message;
  EXPECT_EQ(result->header.frame_id, "base");
  ASSERT_EQ(result->objects.size(), 2u);
  for (const auto& object : result->objects) {
    EXPECT_EQ(object.header.frame_id, "base");
    const Eigen::Vector3d centre(object.pose.position.x, object.pose.position.y, object.pose.position.z);
    EXPECT_LT((centre - boxes_[centre.x() < 0 ? 0 : 1].centre()).norm(), 0.02) << centre.transpose();
  }
  ASSERT_EQ(result->table.values.size(), 4u);
  EXPECT_NEAR(result->table.values[2], 1, 1e-3);
  EXPECT_NEAR(result->table.values[3], 0, 5e-3);
}

TEST_F(Frames, OnlyLevelPlanesAreTables) {
  const SecondNodelet second(points(), cameraInfo());
  ASSERT_TRUE(second.loaded());
  Listener<SegmentedObjectArray> objects("/second/objects");
  auto result = segmentIn(objects, scene_.T_world_camera);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->status, SegmentedObjectArray::OK) << result->message;
  const Eigen::Isometry3d lying(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitX()));
  result = segmentIn(objects, lying * scene_.T_world_camera);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->status, SegmentedObjectArray::NO_TABLE) << "the table would be a wall: " << result->message;
}

TEST_F(Frames, IdentitiesAreKeptWhileTheCameraMoves) {
  const SecondNodelet second(points(), cameraInfo());
  ASSERT_TRUE(second.loaded());
  Listener<SegmentedObjectArray> objects("/second/objects");
  std::map<bool, std::set<std::uint64_t>> ids, labels;  // of the left and the right box
  for (int i = 0; i < 6; ++i) {
    const double angle = 0.25 * i;  // 16 cm a frame
    scene_.T_world_camera = lookAt({-0.65 * std::sin(angle), -0.65 * std::cos(angle), 0.65}, {0, 0, 0.03});
    frame_ = scene_.render();
    const auto result = segmentIn(objects, scene_.T_world_camera);
    ASSERT_TRUE(result);
    ASSERT_EQ(result->objects.size(), 2u) << result->message;
    for (const auto& object : result->objects) {
      ids[object.pose.position.x < 0].insert(object.id);
      labels[object.pose.position.x < 0].insert(object.label);
    }
  }
  for (const bool left : {false, true}) {
    EXPECT_EQ(ids[left].size(), 1u);
    EXPECT_EQ(labels[left].size(), 1u);
  }
  EXPECT_NE(ids[false], ids[true]);
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "features_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
