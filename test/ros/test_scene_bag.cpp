// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <objectness_segmentation/SegmentedObjectArray.h>
#include <sensor_msgs/Image.h>
#include <tf2_msgs/TFMessage.h>

#include <cstring>

#include "fixtures/bag_files.hpp"
#include "fixtures/small_scene.hpp"
#include "fixtures/temporary_folder.hpp"
#include "objectness_segmentation/ros/input_conversions.hpp"
#include "objectness_segmentation/ros/topics.hpp"
#include "ros/scene_bag_writer.hpp"

namespace {

using namespace objectness_segmentation;
using namespace objectness_test;
namespace sim = objectness::sim;

Eigen::Isometry3d toIsometry(const geometry_msgs::Vector3& t, const geometry_msgs::Quaternion& q) {
  Eigen::Isometry3d pose(Eigen::Quaterniond(q.w, q.x, q.y, q.z));
  pose.translation() = Eigen::Vector3d(t.x, t.y, t.z);
  return pose;
}

template <class Pixel>
cv::Mat_<Pixel> toImage(const sensor_msgs::Image& message) {
  EXPECT_EQ(message.step, message.width * sizeof(Pixel));
  EXPECT_EQ(message.data.size(), message.step * message.height);
  cv::Mat_<Pixel> image(static_cast<int>(message.height), static_cast<int>(message.width));
  std::memcpy(image.data, message.data.data(), message.data.size());
  return image;
}

class SceneBag : public testing::Test {
 protected:
  SceneBag() {
    settings_.sensor = smallSensor();
    settings_.frames = 3;
    settings_.rate_hz = 4;
    settings_.noise_seed = [](int frame) { return 7u + frame; };
    status_ = writeSceneBag(path_, scene_, settings_);
    for (int i = 0; i < settings_.frames; ++i) {
      frames_.push_back(simulateFrame(scene_, sim::orbitPose(scene_, i, settings_.frames), settings_.sensor,
                                      settings_.noise_seed(i)));
    }
  }

  TemporaryFolder folder_;
  std::string path_ = folder_ / "scene.bag";
  sim::Scene scene_ = smallScene();
  SceneBagSettings settings_;
  objectness::Status status_;
  std::vector<sim::SimulatedFrame> frames_;
};

TEST_F(SceneBag, HoldsTheFramesThatWereSimulated) {
  ASSERT_TRUE(status_.ok()) << status_.message;
  const auto clouds = readAll<sensor_msgs::PointCloud2>(path_, bag_topics::kPoints);
  const auto cameras = readAll<sensor_msgs::CameraInfo>(path_, bag_topics::kCameraInfo);
  const auto colors = readAll<sensor_msgs::Image>(path_, bag_topics::kColor);
  const auto labels = readAll<sensor_msgs::Image>(path_, bag_topics::kTrueLabels);
  ASSERT_EQ(clouds.size(), frames_.size());
  ASSERT_EQ(cameras.size(), frames_.size());
  ASSERT_EQ(colors.size(), frames_.size());
  ASSERT_EQ(labels.size(), frames_.size());
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    const auto& images = frames_[i].images;
    const std_msgs::Header& header = clouds[i]->header;
    EXPECT_EQ(header.stamp, ros::Time(1000, static_cast<std::uint32_t>(i) * 250000000));
    EXPECT_EQ(header.frame_id, frames::kCameraOptical);
    EXPECT_EQ(cameras[i]->header, header);
    EXPECT_EQ(colors[i]->header, header);
    EXPECT_EQ(labels[i]->header, header);

    const auto camera = toPinholeCamera(*cameras[i]);
    ASSERT_TRUE(camera.ok());
    const auto raw = toRawCloud(*clouds[i]);
    ASSERT_TRUE(raw.ok());
    const auto frame = objectness::makeFrame(raw.value, camera.value, {});
    ASSERT_TRUE(frame.ok()) << frame.status.message;
    const auto expected = objectness::makeFrame(images.depth_mm, images.color, images.camera, {});
    ASSERT_EQ(frame.value.points.size(), expected.value.points.size());
    // NaN as NaN, too.
    EXPECT_EQ(std::memcmp(frame.value.points.data(), expected.value.points.data(),
                          frame.value.points.size() * sizeof(Eigen::Vector3f)),
              0);
    EXPECT_EQ(cv::norm(frame.value.color, images.color, cv::NORM_INF), 0);
    EXPECT_EQ(colors[i]->encoding, "bgr8");
    EXPECT_EQ(cv::norm(toImage<cv::Vec3b>(*colors[i]), images.color, cv::NORM_INF), 0);
    EXPECT_EQ(labels[i]->encoding, "16UC1");
    EXPECT_EQ(cv::norm(toImage<ushort>(*labels[i]), images.true_labels, cv::NORM_INF), 0);
  }
}

TEST_F(SceneBag, HoldsTheTruthAboutTheObjects) {
  const auto truths = readAll<SegmentedObjectArray>(path_, bag_topics::kTrueObjects);
  ASSERT_EQ(truths.size(), frames_.size());
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    const SegmentedObjectArray& truth = *truths[i];
    ASSERT_EQ(truth.objects.size(), scene_.objects.size());
    ASSERT_EQ(truth.table.values.size(), 4u);
    const Eigen::Vector3d on_table = frames_[i].T_world_camera.inverse() * Eigen::Vector3d(0.1, -0.2, 0);
    const auto& plane = truth.table.values;
    EXPECT_NEAR(plane[0] * on_table.x() + plane[1] * on_table.y() + plane[2] * on_table.z() + plane[3], 0, 1e-6);
    for (std::size_t k = 0; k < truth.objects.size(); ++k) {
      const SegmentedObject& object = truth.objects[k];
      EXPECT_EQ(object.header, truth.header);
      EXPECT_EQ(static_cast<int>(object.label), scene_.objects[k].label);
      const auto& p = object.pose.position;
      const Eigen::Vector3d centre = frames_[i].T_world_camera * Eigen::Vector3d(p.x, p.y, p.z);
      EXPECT_LT((centre - scene_.objects[k].T_world_box.translation()).norm(), 1e-9);
      EXPECT_EQ(object.dimensions.z, scene_.objects[k].size_m.z());
      const auto& labels = frames_[i].images.true_labels;
      ASSERT_EQ(static_cast<int>(object.indices.indices.size()), cv::countNonZero(labels == scene_.objects[k].label));
      for (const int pixel : object.indices.indices) {
        ASSERT_EQ(labels(pixel / labels.cols, pixel % labels.cols), scene_.objects[k].label);
      }
      EXPECT_EQ(object.cloud.width * object.cloud.height, object.indices.indices.size());
    }
  }
}

TEST_F(SceneBag, TransformsLeadFromTheCameraToTheWorld) {
  const auto moving = readAll<tf2_msgs::TFMessage>(path_, bag_topics::kTransforms);
  const auto fixed = readAll<tf2_msgs::TFMessage>(path_, bag_topics::kStaticTransforms);
  ASSERT_EQ(moving.size(), frames_.size());
  ASSERT_EQ(fixed.size(), 1u);
  const auto& optical = fixed[0]->transforms.at(0);
  EXPECT_EQ(optical.child_frame_id, frames::kCameraOptical);
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    const auto& body = moving[i]->transforms.at(0);
    EXPECT_EQ(body.header.frame_id, frames::kWorld);
    EXPECT_EQ(body.child_frame_id, optical.header.frame_id);
    const Eigen::Isometry3d chain = toIsometry(body.transform.translation, body.transform.rotation) *
                                    toIsometry(optical.transform.translation, optical.transform.rotation);
    EXPECT_TRUE(chain.isApprox(frames_[i].T_world_camera, 1e-9));
  }
  const rosbag::Bag bag(path_);
  rosbag::View view(bag, rosbag::TopicQuery(bag_topics::kStaticTransforms));
  EXPECT_EQ((*view.getConnections().at(0)->header)["latching"], "1");
}

TEST_F(SceneBag, IsTheSameFileEachTime) {
  const std::string again = folder_ / "again.bag";
  ASSERT_TRUE(writeSceneBag(again, scene_, settings_).ok());
  EXPECT_EQ(readBytes(again), readBytes(path_));
  settings_.noise_seed = [](int frame) { return 8u + frame; };
  ASSERT_TRUE(writeSceneBag(again, scene_, settings_).ok());
  EXPECT_NE(readBytes(again), readBytes(path_));
}

TEST_F(SceneBag, SaysWhyItCannotBeWritten) {
  for (const std::string& path : {folder_ / "none/scene.bag", folder_.path(), std::string("/dev/full")}) {
    const objectness::Status status = writeSceneBag(path, scene_, settings_);
    EXPECT_EQ(status.code, objectness::StatusCode::kBadInput) << path;
    EXPECT_NE(status.message.find("cannot be written: "), std::string::npos) << status.message;
  }
  SceneBagWriter writer(folder_ / "stampless.bag");
  EXPECT_FALSE(writer.write(frames_[0], ros::Time()).ok());
  EXPECT_FALSE(writer.write(frames_[0], ros::Time(1)).ok()) << "an error stays";
  EXPECT_FALSE(writer.close().ok());
}

}  // namespace
