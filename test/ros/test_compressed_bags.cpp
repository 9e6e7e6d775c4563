// SPDX-License-Identifier: BSD-3-Clause
#include "fixtures/compressed_messages.hpp"
#include "ros/compressed_images.hpp"
#include "segment_bag_fixture.hpp"

namespace {

using namespace objectness_segmentation;
using namespace objectness_test;
using objectness::StatusCode;

TEST_F(SegmentBag, AnswersCompressedDepthImagesLikeRawOnes) {
  writeScenes(2);
  const auto clouds = readAll<sensor_msgs::PointCloud2>(in_, bag_topics::kPoints);
  const auto cameras = readAll<sensor_msgs::CameraInfo>(in_, bag_topics::kCameraInfo);
  std::vector<InputMessages> messages;
  {
    rosbag::Bag bag(in_, rosbag::bagmode::Write);
    for (std::size_t i = 0; i < clouds.size(); ++i) {
      const ros::Time recorded = clouds[i]->header.stamp;
      const sensor_msgs::CompressedImage depth = compressedDepth(depthOf(*clouds[i]));
      sensor_msgs::CompressedImage color;
      color.header = depth.header;
      color.format = "bgr8; jpeg compressed bgr8";
      cv::imencode(".jpg", cv::Mat(clouds[i]->height, clouds[i]->width, CV_8UC3, cv::Scalar(50, 60, 70)), color.data);
      bag.write("camera/depth/compressedDepth", recorded, depth);
      bag.write("camera/rgb/compressed", recorded, color);
      bag.write("camera/depth/camera_info", recorded, *cameras[i]);
      messages.push_back({nullptr, cameras[i], decodeDepth(depth).value, decodeColor(color).value});
    }
  }
  const SegmentBagReport report = segment(out_);
  EXPECT_TRUE(report.status.ok()) << report.status.message;
  EXPECT_EQ(report.answered, 2u);
  const auto objects = readAll<SegmentedObjectArray>(out_, "/segment_objects/objects");
  ASSERT_EQ(objects.size(), 2u);
  objectness::FrameSequence sequence(settings_.fuse_frames);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const SegmentedFrame expected = segmentNext(messages[i], settings_.config, {}, nullptr, {}, sequence);
    EXPECT_EQ(expected.segmentation.segments.size(), 2u);
    EXPECT_EQ(serialized(*objects[i]), serialized(toObjectsMessage(expected, messages[i].header())));
  }
  // As with image_transport, the name of the raw topic is enough.
  const auto named = BagInput::open(in_, {"", "", "camera/depth", "camera/rgb"});
  ASSERT_TRUE(named.ok()) << named.status.message;
  EXPECT_EQ(named.value->topics().depth, "camera/depth/compressedDepth");
  EXPECT_EQ(named.value->topics().color, "camera/rgb/compressed");
}

TEST_F(SegmentBag, NamesACompressionItCannotRead) {
  {
    rosbag::Bag bag(in_, rosbag::bagmode::Write);
    sensor_msgs::CompressedImage depth;
    depth.format = "16UC1; compressedDepth rvl";
    bag.write("depth/compressedDepth", recorded_, depth);
    writeCamera(bag, recorded_, makeHeader(1), 0);
  }
  for (const char* wanted : {"depth", ""}) {
    const auto input = BagInput::open(in_, {"", "", wanted, ""});
    EXPECT_EQ(input.status.code, StatusCode::kBadInput);
    EXPECT_NE(input.status.message.find("record it as png or raw"), std::string::npos) << input.status.message;
  }
}

}  // namespace
