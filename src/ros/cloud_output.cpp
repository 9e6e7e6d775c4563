// SPDX-License-Identifier: BSD-3-Clause
#include "ros/cloud_output.hpp"

#include <cstring>

#include "common/color_palette.hpp"
#include "objectness_segmentation/ros/output_conversions.hpp"

namespace objectness_segmentation {
namespace {

constexpr std::size_t kColorOffset = 3 * sizeof(float);
constexpr std::size_t kLabelOffset = kColorOffset + sizeof(float);

void addField(sensor_msgs::PointCloud2& cloud, const char* name, std::uint8_t datatype) {
  sensor_msgs::PointField field;
  field.name = name;
  field.offset = cloud.point_step;
  field.datatype = datatype;
  field.count = 1;
  cloud.fields.push_back(field);
  cloud.point_step += 4;
}

}  // namespace

sensor_msgs::PointCloud2 makeCloud(const std_msgs::Header& header, std::size_t size, bool with_color, bool with_label) {
  sensor_msgs::PointCloud2 cloud;
  cloud.header = header;
  for (const char* name : {"x", "y", "z"}) addField(cloud, name, sensor_msgs::PointField::FLOAT32);
  if (with_color) addField(cloud, "rgb", sensor_msgs::PointField::FLOAT32);
  if (with_label) addField(cloud, "label", sensor_msgs::PointField::UINT32);
  cloud.height = 1;
  cloud.width = static_cast<std::uint32_t>(size);
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.is_dense = true;
  cloud.data.resize(cloud.row_step);
  return cloud;
}

void writePoint(std::uint8_t* destination, const Eigen::Vector3f& point, const cv::Vec3b* bgr) {
  std::memcpy(destination, point.data(), kColorOffset);
  if (!bgr) return;
  const std::uint8_t packed[4] = {(*bgr)[0], (*bgr)[1], (*bgr)[2], 255};
  std::memcpy(destination + kColorOffset, packed, sizeof(packed));
}

void writeLabel(std::uint8_t* destination, std::uint32_t label) {
  std::memcpy(destination + kLabelOffset, &label, sizeof(label));
}

sensor_msgs::PointCloud2 extractCloud(const objectness::Frame& frame, const std::vector<int>& pixels,
                                      const std_msgs::Header& header) {
  const bool colored = !frame.color.empty();
  sensor_msgs::PointCloud2 cloud = makeCloud(header, pixels.size(), colored, false);
  std::uint8_t* destination = cloud.data.data();
  for (const int pixel : pixels) {
    const cv::Vec3b* bgr = colored ? &frame.color(pixel / frame.width(), pixel % frame.width()) : nullptr;
    writePoint(destination, frame.points[pixel], bgr);
    destination += cloud.point_step;
  }
  return cloud;
}

sensor_msgs::PointCloud2 toSegmentsCloud(const SegmentedFrame& result, const std_msgs::Header& header) {
  const auto& segments = result.segmentation.segments;
  if (!result.segmentation.status.ok()) return makeCloud(header, 0, true, true);
  std::size_t size = 0;
  for (const objectness::Segment& segment : segments) size += segment.pixels.size();
  sensor_msgs::PointCloud2 cloud = makeCloud(header, size, true, true);
  std::uint8_t* destination = cloud.data.data();
  for (std::size_t rank = 0; rank < segments.size(); ++rank) {
    const int label = identityOf(result, rank).label;
    const objectness::Rgb color =
        objectness::objectColor(static_cast<std::size_t>(label - objectness::kFirstObjectLabel));
    const cv::Vec3b bgr(color.b, color.g, color.r);
    for (const int pixel : segments[rank].pixels) {
      writePoint(destination, result.frame.points[pixel], &bgr);
      writeLabel(destination, static_cast<std::uint32_t>(label));
      destination += cloud.point_step;
    }
  }
  return cloud;
}

}  // namespace objectness_segmentation
