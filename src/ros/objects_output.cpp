// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "objectness_segmentation/ros/output_conversions.hpp"
#include "ros/cloud_output.hpp"
#include "ros/geometry_output.hpp"
#include "ros/table_output.hpp"
#include "ros/unmeasured_output.hpp"

namespace objectness_segmentation {
namespace {

using objectness::StatusCode;

// The message's constants are a copy of the core's codes.
static_assert(static_cast<int>(StatusCode::kOk) == SegmentedObjectArray::OK);
static_assert(static_cast<int>(StatusCode::kNotOrganized) == SegmentedObjectArray::NOT_ORGANIZED);
static_assert(static_cast<int>(StatusCode::kSizeMismatch) == SegmentedObjectArray::SIZE_MISMATCH);
static_assert(static_cast<int>(StatusCode::kBadCamera) == SegmentedObjectArray::BAD_CAMERA);
static_assert(static_cast<int>(StatusCode::kNoValidPoints) == SegmentedObjectArray::NO_VALID_POINTS);
static_assert(static_cast<int>(StatusCode::kNoTable) == SegmentedObjectArray::NO_TABLE);
static_assert(static_cast<int>(StatusCode::kBadConfig) == SegmentedObjectArray::BAD_CONFIG);
static_assert(static_cast<int>(StatusCode::kVolumeTooLarge) == SegmentedObjectArray::VOLUME_TOO_LARGE);
static_assert(static_cast<int>(StatusCode::kBadInput) == SegmentedObjectArray::BAD_INPUT);
static_assert(static_cast<int>(StatusCode::kCancelled) == SegmentedObjectArray::CANCELLED);
static_assert(static_cast<int>(StatusCode::kInternalError) == SegmentedObjectArray::INTERNAL_ERROR);
static_assert(static_cast<int>(StatusCode::kNoTransform) == SegmentedObjectArray::NO_TRANSFORM);
static_assert(static_cast<int>(StatusCode::kNoInput) == SegmentedObjectArray::NO_INPUT);
static_assert(objectness::kFirstObjectLabel == SegmentedObject::LABEL_FIRST_OBJECT);
static_assert(objectness::kTableLabel == SegmentedObject::LABEL_TABLE);

std::uint64_t orZero(const std::optional<std::int64_t>& count) { return static_cast<std::uint64_t>(count.value_or(0)); }

/// Of a thinned frame: the pixels of the input that it has.
std::vector<int> inputPixels(const SegmentedFrame& result, const std::vector<int>& pixels) {
  if (result.step == 1) return pixels;
  std::vector<int> in_input;
  in_input.reserve(pixels.size());
  for (const int pixel : pixels) {
    const int u = pixel % result.frame.width(), v = pixel / result.frame.width();
    in_input.push_back(v * result.step * result.input_width + u * result.step);
  }
  return in_input;
}

std::uint32_t labelOf(const SegmentedFrame& result, int segment) {
  return static_cast<std::uint32_t>(identityOf(result, static_cast<std::size_t>(segment)).label);
}

std::uint32_t supportOf(const SegmentedFrame& result, const objectness::Support& support) {
  if (support.kind == objectness::SupportKind::kTable) return SegmentedObject::LABEL_TABLE;
  if (support.kind == objectness::SupportKind::kSegment) return labelOf(result, support.segment);
  return SegmentedObject::LABEL_NOTHING;
}

SegmentedObject toObject(const SegmentedFrame& result, std::size_t rank, const std_msgs::Header& header) {
  const objectness::Segment& segment = result.segmentation.segments[rank];
  const objectness::Identity identity = identityOf(result, rank);
  SegmentedObject object;
  object.header = header;
  object.label = static_cast<std::uint32_t>(identity.label);
  object.id = identity.id;
  object.age_frames = static_cast<std::uint32_t>(identity.age_frames);
  object.age = static_cast<float>(identity.age_s);
  object.confidence = static_cast<float>(identity.confidence);
  object.pose = toPose(segment.box.T_camera_box);
  object.dimensions = toVector3(segment.box.size_m);
  object.objectness = static_cast<float>(segment.objectness);
  object.edge_density = static_cast<float>(segment.cues.edge_density);
  object.outer_edges = static_cast<float>(segment.cues.outer_edges);
  object.straddling = static_cast<float>(segment.cues.straddling);
  object.free_space = static_cast<float>(segment.cues.free_space);
  object.indices.header = header;
  object.indices.indices = inputPixels(result, segment.pixels);
  object.cloud = extractCloud(result.frame, segment.pixels, header);
  object.visible_pose = toPose(segment.visible_box.T_camera_box);
  object.visible_dimensions = toVector3(segment.visible_box.size_m);
  object.round = segment.round;
  object.supported_by = supportOf(result, segment.support);
  object.base_height = static_cast<float>(segment.support.height_m);
  for (const int carried : segment.carried) object.supports.push_back(labelOf(result, carried));
  return object;
}

}  // namespace

objectness::Identity identityOf(const SegmentedFrame& result, std::size_t rank) {
  if (rank < result.identities.size()) return result.identities[rank];
  objectness::Identity by_rank;
  by_rank.label = objectness::kFirstObjectLabel + static_cast<int>(rank);
  return by_rank;
}

SegmentedObjectArray toObjectsMessage(const SegmentedFrame& result, const std_msgs::Header& header) {
  const objectness::Segmentation& segmentation = result.segmentation;
  SegmentedObjectArray message;
  message.header = header;
  message.status = static_cast<std::uint8_t>(segmentation.status.code);
  message.message = segmentation.status.message;
  message.table.header = header;
  message.table.values = planeCoefficients(segmentation.table);
  const std::size_t count = segmentation.status.ok() ? segmentation.segments.size() : 0;
  message.objects.reserve(count);
  for (std::size_t rank = 0; rank < count; ++rank) {
    message.objects.push_back(toObject(result, rank, header));
  }
  if (segmentation.status.ok()) message.unmeasured = toUnmeasuredMessages(segmentation.unmeasured);
  message.boxes_sampled = orZero(segmentation.report.boxes_sampled);
  message.boxes_scored = orZero(segmentation.report.boxes_scored);
  message.boxes_passed = orZero(segmentation.report.boxes_passed);
  return message;
}

}  // namespace objectness_segmentation
