// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <string>

#include "objectness_segmentation/ros/output_conversions.hpp"
#include "ros/geometry_output.hpp"
#include "ros/marker_parts.hpp"
#include "ros/unmeasured_output.hpp"

namespace objectness_segmentation {
namespace {

using visualization_msgs::Marker;

constexpr double kTextHeight = 0.025;  // metres
constexpr double kArrowLength = 0.1;   // metres

const objectness::Rgb kWhite{255, 255, 255};

void addObject(const objectness::Segment& segment, const objectness::Identity& identity, const std_msgs::Header& header,
               std::vector<Marker>& markers) {
  const int number = identity.label - objectness::kFirstObjectLabel;
  Marker box = makeMarker(header, "boxes", number, Marker::LINE_LIST);
  box.pose = toPose(segment.box.T_camera_box);
  box.scale.x = kLineWidth;
  box.color = toColor(objectness::objectColor(static_cast<std::size_t>(number)));
  addBoxEdges(segment.box.size_m, box.points);

  Marker label = makeMarker(header, "labels", number, Marker::TEXT_VIEW_FACING);
  const Eigen::Vector3d above(0, 0, 0.5 * segment.box.size_m.z() + kTextHeight);
  label.pose.position = toPoint(segment.box.T_camera_box * above);
  label.scale.z = kTextHeight;
  label.color = toColor(kWhite);
  char text[64];
  std::snprintf(text, sizeof(text), "%d: %.2f", identity.label, segment.objectness);
  label.text = text;
  if (identity.id > 0) label.text += " (#" + std::to_string(identity.id) + ")";

  markers.push_back(std::move(box));
  markers.push_back(std::move(label));
}

void addTable(const objectness::Table& table, const std_msgs::Header& header, std::vector<Marker>& markers) {
  if (table.hull.empty()) return;
  const std_msgs::ColorRGBA white = toColor(kWhite);
  const geometry_msgs::Pose pose = toPose(table.T_table_camera.inverse());

  Marker outline = makeMarker(header, "table", 0, Marker::LINE_STRIP);
  outline.pose = pose;
  outline.scale.x = kLineWidth;
  outline.color = white;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& p : table.hull) {
    outline.points.push_back(toPoint({p.x(), p.y(), 0}));
    centre += p / static_cast<double>(table.hull.size());
  }
  outline.points.push_back(outline.points.front());

  Marker normal = makeMarker(header, "table", 1, Marker::ARROW);
  normal.pose = pose;
  normal.scale.x = kLineWidth;
  normal.scale.y = 3 * kLineWidth;
  normal.color = white;
  normal.points = {toPoint({centre.x(), centre.y(), 0}), toPoint({centre.x(), centre.y(), kArrowLength})};

  markers.push_back(std::move(outline));
  markers.push_back(std::move(normal));
}

}  // namespace

visualization_msgs::MarkerArray toMarkers(const SegmentedFrame& result, const std_msgs::Header& header) {
  const objectness::Segmentation& segmentation = result.segmentation;
  visualization_msgs::MarkerArray array = emptyMarkers(header);
  if (!segmentation.status.ok()) return array;
  for (std::size_t rank = 0; rank < segmentation.segments.size(); ++rank) {
    addObject(segmentation.segments[rank], identityOf(result, rank), header, array.markers);
  }
  addUnmeasured(segmentation.unmeasured, header, array.markers);
  addTable(segmentation.table, header, array.markers);
  return array;
}

}  // namespace objectness_segmentation
