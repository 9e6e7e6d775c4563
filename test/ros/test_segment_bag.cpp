// SPDX-License-Identifier: BSD-3-Clause
#include "segment_bag_fixture.hpp"

namespace {

using namespace objectness_segmentation;
using namespace objectness_test;
using objectness::StatusCode;

TEST_F(SegmentBag, WritesWhatTheNodeletPublishes) {
  writeScenes(2);
  const SegmentBagReport report = segment(out_);
  EXPECT_TRUE(report.status.ok()) << report.status.message;
  EXPECT_EQ(report.answered, 2u);
  EXPECT_EQ(report.not_segmented + report.without_camera, 0u);
  const auto clouds = readAll<sensor_msgs::PointCloud2>(in_, bag_topics::kPoints);
  const auto cameras = readAll<sensor_msgs::CameraInfo>(in_, bag_topics::kCameraInfo);
  const auto objects = readAll<SegmentedObjectArray>(out_, "/segment_objects/objects");
  const auto segments = readAll<sensor_msgs::PointCloud2>(out_, "/segment_objects/segments");
  const auto markers = readAll<visualization_msgs::MarkerArray>(out_, "/segment_objects/markers");
  ASSERT_EQ(clouds.size(), 2u);
  ASSERT_EQ(objects.size(), 2u);
  ASSERT_EQ(segments.size(), 2u);
  ASSERT_EQ(markers.size(), 2u);
  objectness::FrameSequence sequence(settings_.fuse_frames);
  for (std::size_t i = 0; i < clouds.size(); ++i) {
    const SegmentedFrame result = segmentNext({clouds[i], cameras[i]}, settings_.config, {}, nullptr, {}, sequence);
    const std_msgs::Header& header = clouds[i]->header;
    EXPECT_EQ(result.segmentation.segments.size(), 2u);
    EXPECT_EQ(serialized(*objects[i]), serialized(toObjectsMessage(result, header)));
    EXPECT_EQ(serialized(*segments[i]), serialized(toSegmentsCloud(result, header)));
    EXPECT_EQ(serialized(*markers[i]), serialized(toMarkers(result, header)));
    EXPECT_EQ(frames_[i].number, i + 1);
    EXPECT_EQ(frames_[i].stamp, header.stamp);
    EXPECT_EQ(frames_[i].objects, 2u);
  }
  const rosbag::Bag bag(out_);
  rosbag::View view(bag);
  EXPECT_EQ(view.size(), 6u);
  for (const rosbag::MessageInstance& entry : view) {
    EXPECT_TRUE(entry.getTime() == clouds[0]->header.stamp || entry.getTime() == clouds[1]->header.stamp);
  }
}

TEST_F(SegmentBag, GivesTheSameBytesWithAnyNumberOfThreads) {
  writeScenes(2);
  settings_.config.runtime.threads = 1;
  segment(out_);
  settings_.config.runtime.threads = 3;
  segment(folder_ / "again.bag");
  EXPECT_EQ(readBytes(out_), readBytes(folder_ / "again.bag"));
}

TEST_F(SegmentBag, PairsEqualStamps) {
  writePlain({1.0, 1.2, 1.05}, {1.2, 1.05, 1.0});
  EXPECT_EQ(pairs(false), (std::vector<int>{2, 0, 1}));
  const SegmentBagReport report = segment(out_);
  EXPECT_EQ(report.answered, 3u);
  EXPECT_EQ(report.with_last_camera + report.without_camera, 0u);
}

/// As the nodelet does: a camera is a constant.
TEST_F(SegmentBag, TakesTheLastCameraOfTheFrameWhereStampsDoNotPair) {
  const auto at = [](double stamp, const std::string& frame) { return makeHeader(stamp, frame); };
  {
    rosbag::Bag bag(in_, rosbag::bagmode::Write);
    writeCloud(bag, ros::Time(1), at(101, "a"));
    writeCamera(bag, ros::Time(2), at(0, "a"), 0);
    writeCloud(bag, ros::Time(3), at(103, "a"));
    writeCamera(bag, ros::Time(4), at(500, "/b"), 1);
    writeCloud(bag, ros::Time(5), at(105, "a"));
    writeCloud(bag, ros::Time(6), at(106, "b"));
    writeCamera(bag, ros::Time(7), at(0, "a"), 2);
    writeCloud(bag, ros::Time(8), at(108, "a"));
    writeCloud(bag, ros::Time(9), at(500, "a"));
    writeCloud(bag, ros::Time(10), at(0, "c"));
    writeCloud(bag, ros::Time(11), at(111, "c"));
    writeCloud(bag, ros::Time(12), at(112, ""));
  }
  EXPECT_EQ(pairs(false), (std::vector<int>{0, 0, 0, 1, 2, 1, 2, -1, 2}));
  EXPECT_EQ(pairs(true), (std::vector<int>{0, 0, 0, 0, 2, 1, 2, 2, 2}));
  const SegmentBagReport report = segment(out_);
  EXPECT_EQ(report.answered, 9u);
  EXPECT_EQ(report.with_last_camera, 6u);
  EXPECT_EQ(report.without_camera, 1u);
}

TEST_F(SegmentBag, AnswersCloudsWithoutCamera) {
  writeScenes(2);
  const auto clouds = readAll<sensor_msgs::PointCloud2>(in_, bag_topics::kPoints);
  {
    rosbag::Bag bag(in_, rosbag::bagmode::Write);
    for (const auto& cloud : clouds) bag.write("points", cloud->header.stamp, *cloud);
  }
  const SegmentBagReport report = segment(out_);
  EXPECT_EQ(report.answered, 2u);
  EXPECT_EQ(report.without_camera, 2u);
  for (const BagFrame& frame : frames_) {
    EXPECT_TRUE(frame.status.ok()) << frame.status.message;
    EXPECT_EQ(frame.objects, 2u);
  }
}

TEST_F(SegmentBag, AnswersCloudsThatAreNotOrganized) {
  writeScenes(2);
  const auto clouds = readAll<sensor_msgs::PointCloud2>(in_, bag_topics::kPoints);
  const auto cameras = readAll<sensor_msgs::CameraInfo>(in_, bag_topics::kCameraInfo);
  {
    rosbag::Bag bag(in_, rosbag::bagmode::Write);
    for (std::size_t i = 0; i < clouds.size(); ++i) {
      sensor_msgs::PointCloud2 list = *clouds[i];
      list.width *= list.height;
      list.height = 1;
      list.row_step = list.width * list.point_step;
      bag.write("points", list.header.stamp, list);
      bag.write("camera_info", list.header.stamp, *cameras[i]);
    }
  }
  const SegmentBagReport report = segment(out_);
  EXPECT_EQ(report.answered, 2u);
  for (const BagFrame& frame : frames_) {
    EXPECT_TRUE(frame.status.ok()) << frame.status.message;
    EXPECT_EQ(frame.objects, 2u);
  }
}

TEST_F(SegmentBag, AnswersDepthImages) {
  writeScenes(3);
  const auto clouds = readAll<sensor_msgs::PointCloud2>(in_, bag_topics::kPoints);
  const auto cameras = readAll<sensor_msgs::CameraInfo>(in_, bag_topics::kCameraInfo);
  std::vector<InputMessages> messages;
  {
    rosbag::Bag bag(in_, rosbag::bagmode::Write);
    for (std::size_t i = 0; i < clouds.size(); ++i) {
      const auto depth = boost::make_shared<sensor_msgs::Image>(depthOf(*clouds[i]));
      const auto color = boost::make_shared<sensor_msgs::Image>(*depth);
      color->encoding = "bgr8";
      color->step = 3 * color->width;
      color->data.assign(std::size_t{color->step} * color->height, static_cast<std::uint8_t>(50 + i));
      color->header.stamp += ros::Duration(0.02);
      const ros::Time recorded = depth->header.stamp;
      bag.write("depth", recorded, *depth);
      bag.write("camera_info", recorded, *cameras[i]);
      const bool late = i == 1;  // too late for any depth image: the one before is the nearest
      if (late) color->header.stamp += ros::Duration(3);
      bag.write("rgb", recorded + ros::Duration(0.05), *color);
      messages.push_back({nullptr, cameras[i], depth, late ? messages[0].color : color});
    }
  }
  const SegmentBagReport report = segment(out_);
  EXPECT_EQ(report.answered, 3u);
  const auto objects = readAll<SegmentedObjectArray>(out_, "/segment_objects/objects");
  ASSERT_EQ(objects.size(), 3u);
  objectness::FrameSequence sequence(settings_.fuse_frames);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const SegmentedFrame result = segmentNext(messages[i], settings_.config, {}, nullptr, {}, sequence);
    EXPECT_EQ(result.segmentation.segments.size(), 2u);
    EXPECT_EQ(serialized(*objects[i]), serialized(toObjectsMessage(result, messages[i].header())));
  }
}

TEST_F(SegmentBag, PairsNearestStampsWhenAsked) {
  writePlain({0.2, 1.125, 1.3, 1.25, 9}, {1.0, 1.25, 1.5});
  EXPECT_EQ(pairs(true), (std::vector<int>{0, 0, 1, 1, 2}));
}

TEST_F(SegmentBag, AnswersCloudsThatCannotBeSegmented) {
  writePlain({1.0, 0.0}, {1.0, 0.0});
  const SegmentBagReport report = segment(out_);
  EXPECT_EQ(report.answered, 2u);
  EXPECT_EQ(report.not_segmented, 2u);
  const auto objects = readAll<SegmentedObjectArray>(out_, "/segment_objects/objects");
  ASSERT_EQ(objects.size(), 2u);
  for (const auto& message : objects) {
    EXPECT_NE(message->status, SegmentedObjectArray::OK);
    EXPECT_FALSE(message->message.empty());
  }
  // A bag has no place for the time 0: that of the recording stands for it.
  const rosbag::Bag bag(out_);
  rosbag::View view(bag);
  EXPECT_EQ(view.getEndTime(), recorded_);
}

TEST_F(SegmentBag, EndsWhenCancelled) {
  writeScenes(3);
  std::atomic<bool> cancel{false};
  settings_.cancel = &cancel;
  const auto input = BagInput::open(in_, {});
  BagOutput output(out_);
  const auto report = segmentBag(*input.value, settings_, output, [&](const BagFrame&) { cancel = true; });
  EXPECT_TRUE(output.close().ok());
  EXPECT_TRUE(report.status.ok());
  EXPECT_EQ(report.answered, 1u);
  EXPECT_EQ(readAll<SegmentedObjectArray>(out_, "/segment_objects/objects").size(), 1u);
}

TEST_F(SegmentBag, KeepsWhatWasDoneBeforeTheDamage) {
  writeScenes(3);
  std::string bytes = readBytes(in_);
  // The clouds are in chunks of their own; the last of them begins in the last third.
  std::fill(bytes.begin() + static_cast<long>(0.8 * bytes.size()),
            bytes.begin() + static_cast<long>(0.85 * bytes.size()), '\xFF');
  writeBytes(in_, bytes);
  const SegmentBagReport report = segment(out_);
  EXPECT_EQ(report.status.code, StatusCode::kBadInput);
  EXPECT_NE(report.status.message.find("is damaged after 2 of 3 clouds"), std::string::npos) << report.status.message;
  EXPECT_EQ(report.answered, 2u);
  EXPECT_EQ(readAll<SegmentedObjectArray>(out_, "/segment_objects/objects").size(), 2u);
}

}  // namespace
