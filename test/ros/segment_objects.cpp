// SPDX-License-Identifier: BSD-3-Clause
// Run by segment_objects.test beside the nodelet: plays the camera driver and looks at what comes back. Limits are in
// wall time.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <dynamic_reconfigure/Reconfigure.h>
#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "fixtures/leaf_model.hpp"
#include "fixtures/temporary_folder.hpp"
#include "nodelet_fixture.hpp"
#include "objectness_segmentation/config.hpp"

namespace {

using namespace objectness_segmentation;
using namespace objectness_test;

/// The sampling (corners every 2 cm, sizes every 2 cm and 1 cm) and the hidden sides allow for this much.
constexpr double kPositionTolerance = 0.02, kSizeTolerance = 0.035;

void expectBox(const SegmentedObject& object, const Eigen::Vector3d& centre, const TrueBox& truth) {
  EXPECT_LT((centre - truth.centre()).norm(), kPositionTolerance) << centre.transpose();
  const Eigen::Vector3d size = truth.high - truth.low;
  // Which of its sides is x is up to the box.
  EXPECT_NEAR(std::min(object.dimensions.x, object.dimensions.y), std::min(size.x(), size.y()), kSizeTolerance);
  EXPECT_NEAR(std::max(object.dimensions.x, object.dimensions.y), std::max(size.x(), size.y()), kSizeTolerance);
  EXPECT_NEAR(object.dimensions.z, size.z(), kSizeTolerance);
}

TEST_F(SegmentObjects, SubscribesOnlyWhileSomebodyListens) {
  EXPECT_FALSE(waitUntil([&] { return inputsConnected(); }, 1.0));
  {
    Listener<visualization_msgs::MarkerArray> markers(std::string(kNode) + "/markers");
    EXPECT_TRUE(waitUntil([&] { return inputsConnected(); }));
  }
  EXPECT_TRUE(waitUntil([&] { return inputsGone(); }));
}

TEST_F(SegmentObjects, FindsTwoBoxes) {
  Listener<SegmentedObjectArray> objects(std::string(kNode) + "/objects");
  Listener<PointCloud2> segments(std::string(kNode) + "/segments");
  Listener<visualization_msgs::MarkerArray> markers(std::string(kNode) + "/markers");
  ASSERT_TRUE(waitUntil([&] { return segments.connected() && markers.connected(); }));
  const PointCloud2 cloud = goodCloud();
  const SegmentedObjectArrayConstPtr result = segment(objects, cloud, goodCamera());
  ASSERT_TRUE(result);
  EXPECT_EQ(result->status, SegmentedObjectArray::OK) << result->message;
  EXPECT_GT(result->processing_time, 0);
  ASSERT_EQ(result->table.values.size(), 4u);
  EXPECT_NEAR(result->table.values[3], 0.65, 0.01);

  ASSERT_EQ(result->objects.size(), boxes_.size());
  std::size_t points = 0;
  for (std::size_t rank = 0; rank < boxes_.size(); ++rank) {
    const SegmentedObject& object = result->objects[rank];
    const Eigen::Vector3d centre = toWorld(object.pose.position);
    const TrueBox& truth = boxes_[centre.x() < 0 ? 0 : 1];
    expectBox(object, centre, truth);
    EXPECT_EQ(object.label, SegmentedObject::LABEL_FIRST_OBJECT + rank);
    EXPECT_EQ(object.header.stamp, cloud.header.stamp);
    EXPECT_EQ(object.header.frame_id, cloud.header.frame_id);
    EXPECT_EQ(object.cloud.header.frame_id, cloud.header.frame_id);

    ASSERT_EQ(object.cloud.width * object.cloud.height, object.indices.indices.size());
    const int surface = static_cast<int>(&truth - boxes_.data()) + 1;
    const std::size_t own = std::count_if(object.indices.indices.begin(), object.indices.indices.end(),
                                          [&](int pixel) { return scene_.seen[pixel] == surface; });
    const std::size_t seen = std::count(scene_.seen.begin(), scene_.seen.end(), surface);
    EXPECT_GT(own, 0.9 * seen);
    EXPECT_GT(own, 0.9 * object.indices.indices.size());
    points += object.indices.indices.size();
  }
  EXPECT_GE(result->objects[0].objectness, result->objects[1].objectness);
  EXPECT_GT((toWorld(result->objects[0].pose.position) - toWorld(result->objects[1].pose.position)).norm(), 0.2);

  const auto segment_cloud = segments.wait(cloud.header.stamp);
  ASSERT_TRUE(segment_cloud);
  EXPECT_EQ(segment_cloud->header.frame_id, cloud.header.frame_id);
  EXPECT_EQ(segment_cloud->width * segment_cloud->height, points);
  std::set<std::uint32_t> labels;
  for (sensor_msgs::PointCloud2ConstIterator<std::uint32_t> label(*segment_cloud, "label"); label != label.end();
       ++label) {
    labels.insert(*label);
  }
  EXPECT_EQ(labels, (std::set<std::uint32_t>{2, 3}));

  const auto marker_array = markers.wait(cloud.header.stamp);
  ASSERT_TRUE(marker_array);
  EXPECT_EQ(marker_array->markers[0].action, visualization_msgs::Marker::DELETEALL);
  for (const auto& marker : marker_array->markers) {
    EXPECT_EQ(marker.header.stamp, cloud.header.stamp);
    EXPECT_EQ(marker.header.frame_id, cloud.header.frame_id);
  }
}

TEST_F(SegmentObjects, SaysWhatIsWrongAndGoesOn) {
  Listener<SegmentedObjectArray> objects(std::string(kNode) + "/objects");
  const auto expectStatus = [&](const PointCloud2& cloud, const sensor_msgs::CameraInfo& camera, int status) {
    const auto result = segment(objects, cloud, camera);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->status, status) << result->message;
    EXPECT_EQ(result->header.frame_id, cloud.header.frame_id);
    EXPECT_EQ(result->message.empty(), status == SegmentedObjectArray::OK);
    EXPECT_EQ(result->objects.empty(), status != SegmentedObjectArray::OK);
  };

  // The same points in no order: no view of the camera.
  PointCloud2 cloud = goodCloud();
  cloud.width = cloud.width * cloud.height;
  cloud.height = 1;
  for (int u = 0; u < frame_.size(); ++u) {
    float x = 0.001F * (u % 977);
    std::memcpy(pointAt(cloud, u, 0), &x, sizeof(x));
  }
  expectStatus(cloud, goodCamera(), SegmentedObjectArray::NOT_ORGANIZED);
  expectStatus(goodCloud(), goodCamera(), SegmentedObjectArray::OK);

  cloud = goodCloud();
  cloud.data.resize(1000);
  expectStatus(cloud, goodCamera(), SegmentedObjectArray::BAD_INPUT);

  expectStatus(goodCloud(), sensor_msgs::CameraInfo(), SegmentedObjectArray::BAD_CAMERA);

  sensor_msgs::CameraInfo camera = goodCamera();
  camera.width = 640;
  camera.height = 480;
  expectStatus(goodCloud(), camera, SegmentedObjectArray::SIZE_MISMATCH);

  cloud = goodCloud();
  std::fill(cloud.data.begin(), cloud.data.end(), 0xFF);  // NaN
  expectStatus(cloud, goodCamera(), SegmentedObjectArray::NO_VALID_POINTS);

  cloud = goodCloud();
  cloud.header.frame_id.clear();
  expectStatus(cloud, goodCamera(), SegmentedObjectArray::OK);
}

class Reconfigure {
 public:
  /// Returns the value the node has afterwards.
  double set(const std::vector<std::pair<std::string, double>>& values) {
    dynamic_reconfigure::Reconfigure call;
    for (const auto& [name, value] : values) {
      call.request.config.doubles.emplace_back();
      call.request.config.doubles.back().name = name;
      call.request.config.doubles.back().value = value;
    }
    if (!ros::service::call(std::string(kNode) + "/set_parameters", call)) return NAN;
    for (const auto& entry : call.response.config.doubles) {
      if (entry.name == values[0].first) return entry.value;
    }
    return NAN;
  }
};

TEST_F(SegmentObjects, TakesOverChangedParameters) {
  Reconfigure reconfigure;
  Listener<SegmentedObjectArray> objects(std::string(kNode) + "/objects");
  const double max_height = objectness::Config{}.object_points.max_height_m;

  EXPECT_EQ(reconfigure.set({{"object_points_max_height_m", 0.03}}), 0.03);  // lower than all that is here
  auto result = segment(objects, goodCloud(), goodCamera());
  ASSERT_TRUE(result);
  EXPECT_EQ(result->status, SegmentedObjectArray::OK);
  EXPECT_EQ(result->objects.size(), 0u);

  EXPECT_EQ(reconfigure.set({{"object_points_max_height_m", max_height}}), max_height);
  result = segment(objects, goodCloud(), goodCamera());
  ASSERT_TRUE(result);
  EXPECT_EQ(result->objects.size(), 2u);
}

TEST_F(SegmentObjects, RejectsParametersThatContradictEachOther) {
  Reconfigure reconfigure;
  const objectness::SearchConfig search;
  EXPECT_EQ(reconfigure.set({{"search_min_size_m", 0.2}, {"search_max_size_m", 0.1}}), search.min_size_m);
  double on_server = 0;
  EXPECT_TRUE(ros::param::get(std::string(kNode) + "/search_max_size_m", on_server));
  EXPECT_EQ(on_server, search.max_size_m);

  Listener<SegmentedObjectArray> objects(std::string(kNode) + "/objects");
  const auto result = segment(objects, goodCloud(), goodCamera());
  ASSERT_TRUE(result);
  EXPECT_EQ(result->objects.size(), 2u);
}

TEST_F(SegmentObjects, SendsDiagnostics) {
  diagnostic_msgs::DiagnosticStatus status;
  ros::Subscriber subscriber = nh_.subscribe<diagnostic_msgs::DiagnosticArray>(
      "/diagnostics", 10, [&status](const diagnostic_msgs::DiagnosticArrayConstPtr& array) {
        for (const auto& entry : array->status) {
          if (entry.name.find("segment_objects: segmentation") != std::string::npos) status = entry;
        }
      });
  EXPECT_TRUE(waitUntil([&] { return !status.values.empty(); }));
  EXPECT_EQ(status.level, diagnostic_msgs::DiagnosticStatus::OK) << status.message;
}

TEST_F(SegmentObjects, UnloadsInMidFrameAndLeavesTheManagerAlive) {
  for (int round = 0; round < 3; ++round) {
    SecondNodelet nodelet(cloud_publisher_.getTopic(), camera_publisher_.getTopic());
    ASSERT_TRUE(nodelet.loaded());
    Listener<SegmentedObjectArray> second("/second/objects");
    ASSERT_TRUE(waitUntil([&] { return second.connected() && inputsConnected(); }));
    for (int i = 0; i < 5; ++i) send(goodCloud(), goodCamera());
    ros::WallDuration(0.05 * round).sleep();
    const ros::WallTime start = ros::WallTime::now();
    EXPECT_TRUE(nodelet.unload());
    EXPECT_LT((ros::WallTime::now() - start).toSec(), 2.0);
  }
  Listener<SegmentedObjectArray> objects(std::string(kNode) + "/objects");
  const auto result = segment(objects, goodCloud(), goodCamera());
  ASSERT_TRUE(result);
  EXPECT_EQ(result->objects.size(), 2u);
}

TEST_F(SegmentObjects, TakesAModelOfOnesOwn) {
  const TemporaryFolder folder;
  writeBytes(folder / "leaf.json", objectness::toJson(leafModel(0, 0, 0.75f)));
  const SecondNodelet nodelet(cloud_publisher_.getTopic(), camera_publisher_.getTopic(), folder / "leaf.json");
  ASSERT_TRUE(nodelet.loaded());
  Listener<SegmentedObjectArray> second("/second/objects");
  const auto result = segment(second, goodCloud(), goodCamera());
  ASSERT_TRUE(result);
  EXPECT_EQ(result->status, SegmentedObjectArray::OK) << result->message;
  ASSERT_GE(result->objects.size(), 2u);
  for (const auto& object : result->objects) EXPECT_EQ(object.objectness, 0.75f);
}

TEST_F(SegmentObjects, ABadModelIsSaidAndTheManagerLivesOn) {
  const TemporaryFolder folder;
  writeBytes(folder / "foreign.json", "{\"contact\": {\"cues\": [\"smell\"], \"trees\": []}}");
  const std::pair<std::string, std::string> cases[] = {{folder / "none.json", "there is no such file"},
                                                       {folder / "foreign.json", "is made for the cues smell"}};
  for (const auto& [path, reason] : cases) {
    const SecondNodelet nodelet(cloud_publisher_.getTopic(), camera_publisher_.getTopic(), path);
    ASSERT_TRUE(nodelet.loaded());
    Listener<SegmentedObjectArray> second("/second/objects");
    const auto result = segment(second, goodCloud(), goodCamera());
    ASSERT_TRUE(result);
    EXPECT_EQ(result->status, SegmentedObjectArray::BAD_CONFIG);
    EXPECT_NE(result->message.find(path), std::string::npos) << result->message;
    EXPECT_NE(result->message.find(reason), std::string::npos) << result->message;
    EXPECT_TRUE(result->objects.empty());
  }
  Listener<SegmentedObjectArray> objects(std::string(kNode) + "/objects");
  const auto result = segment(objects, goodCloud(), goodCamera());
  ASSERT_TRUE(result);
  EXPECT_EQ(result->objects.size(), 2u);
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "segment_objects_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
