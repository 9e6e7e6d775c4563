// SPDX-License-Identifier: BSD-3-Clause
#include <cstring>
#include <limits>
#include <optional>
#include <string>

#include "objectness_segmentation/ros/input_conversions.hpp"

namespace objectness_segmentation {
namespace {

using objectness::RawCloud;
using objectness::Result;
using objectness::Status;
using objectness::StatusCode;
using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;

/// Every field that is read is four bytes wide.
constexpr std::uint64_t kFieldSize = 4;

Status bad(const std::string& message) { return Status::error(StatusCode::kBadInput, message); }

const PointField* findField(const PointCloud2& message, const std::string& name) {
  for (const PointField& field : message.fields) {
    if (field.name == name) return &field;
  }
  return nullptr;
}

/// Offset of a coordinate within a point.
Result<std::uint32_t> coordinateOffset(const PointCloud2& message, const std::string& name) {
  const PointField* field = findField(message, name);
  if (!field) return Result<std::uint32_t>::error(bad("cloud has no field '" + name + "': x, y and z are needed"));
  if (field->datatype != PointField::FLOAT32) {
    return Result<std::uint32_t>::error(bad("field '" + name + "' of the cloud has datatype " +
                                            std::to_string(field->datatype) + ", FLOAT32 (7) is needed"));
  }
  if (field->offset + kFieldSize > message.point_step) {
    return Result<std::uint32_t>::error(bad("field '" + name + "' of the cloud ends behind its point_step of " +
                                            std::to_string(message.point_step) + " bytes"));
  }
  return {Status{}, field->offset};
}

/// Colour is optional: a field that is no packed colour is not used.
std::optional<std::uint32_t> colorOffset(const PointCloud2& message) {
  for (const char* name : {"rgb", "rgba"}) {
    const PointField* field = findField(message, name);
    const bool packed = field && (field->datatype == PointField::FLOAT32 || field->datatype == PointField::UINT32);
    if (packed && field->offset + kFieldSize <= message.point_step) return field->offset;
  }
  return std::nullopt;
}

/// The bytes from one row to the next; some drivers leave them out where rows follow one another.
std::uint64_t rowStep(const PointCloud2& message) {
  return message.row_step != 0 ? message.row_step : std::uint64_t{message.width} * message.point_step;
}

/// 64-bit sums: a hostile message must not pass by overflow.
Status checkLayout(const PointCloud2& message) {
  const std::uint64_t width = message.width, height = message.height, step = message.point_step;
  if (width == 0 || height == 0) {
    return bad("cloud is empty (" + std::to_string(width) + " x " + std::to_string(height) + ")");
  }
  if (message.is_bigendian) return bad("cloud is big-endian, which is not supported");
  const std::uint64_t row = width * step;
  if (height > 1 && rowStep(message) < row) {
    return bad("row_step of the cloud is " + std::to_string(message.row_step) + " bytes, but a row of " +
               std::to_string(width) + " points of " + std::to_string(step) + " bytes takes " + std::to_string(row));
  }
  // A row that fits bounds the step.
  const std::uint64_t needed = row > message.data.size() ? row : (height - 1) * rowStep(message) + row;
  if (message.data.size() < needed) {
    return bad("cloud says " + std::to_string(width) + " x " + std::to_string(height) + " points, which takes " +
               std::to_string(needed) + " bytes, but carries " + std::to_string(message.data.size()));
  }
  if (width * height > static_cast<std::uint64_t>(std::numeric_limits<int>::max())) {
    return bad("cloud has " + std::to_string(width * height) + " points, which is too many");
  }
  return {};
}

}  // namespace

Result<RawCloud> toRawCloud(const PointCloud2& message, int step) {
  const Result<std::uint32_t> x = coordinateOffset(message, "x");
  const Result<std::uint32_t> y = coordinateOffset(message, "y");
  const Result<std::uint32_t> z = coordinateOffset(message, "z");
  for (const auto* offset : {&x, &y, &z}) {
    if (!offset->ok()) return Result<RawCloud>::error(offset->status);
  }
  const Status layout = checkLayout(message);
  if (!layout.ok()) return Result<RawCloud>::error(layout);
  const std::optional<std::uint32_t> color = colorOffset(message);

  Result<RawCloud> result;
  RawCloud& cloud = result.value;
  cloud.frame_id = message.header.frame_id;
  const auto stride = static_cast<std::size_t>(step);
  cloud.width = static_cast<int>((message.width + stride - 1) / stride);
  cloud.height = static_cast<int>((message.height + stride - 1) / stride);
  const std::size_t count = static_cast<std::size_t>(cloud.width) * static_cast<std::size_t>(cloud.height);
  cloud.points.resize(count);
  if (color) cloud.colors.resize(count);
  std::size_t i = 0;
  for (std::size_t v = 0; v < message.height; v += stride) {
    const std::uint8_t* point = message.data.data() + v * rowStep(message);
    for (std::size_t u = 0; u < message.width; u += stride, ++i, point += stride * message.point_step) {
      Eigen::Vector3f& p = cloud.points[i];
      std::memcpy(&p.x(), point + x.value, kFieldSize);
      std::memcpy(&p.y(), point + y.value, kFieldSize);
      std::memcpy(&p.z(), point + z.value, kFieldSize);
      if (color) std::memcpy(cloud.colors[i].val, point + *color, 3);  // a packed colour is B, G, R, A in memory
    }
  }
  return result;
}

}  // namespace objectness_segmentation
