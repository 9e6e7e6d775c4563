// SPDX-License-Identifier: BSD-3-Clause
#include "ros/unmeasured_output.hpp"

#include "ros/geometry_output.hpp"
#include "ros/marker_parts.hpp"

namespace objectness_segmentation {
namespace {

using visualization_msgs::Marker;

const objectness::Rgb kColor{255, 0, 255};  // of no object

Marker lines(const std_msgs::Header& header, std::size_t id, int type) {
  Marker marker = makeMarker(header, "unmeasured", static_cast<int>(id), type);
  marker.scale.x = kLineWidth;
  marker.color = toColor(kColor);
  return marker;
}

}  // namespace

std::vector<Unmeasured> toUnmeasuredMessages(const std::vector<objectness::Unmeasured>& things) {
  std::vector<Unmeasured> messages;
  for (const objectness::Unmeasured& thing : things) {
    Unmeasured message;
    for (const Eigen::Vector3d& corner : thing.outline) message.outline.points.push_back(toPoint32(corner));
    message.pixels = static_cast<std::uint32_t>(thing.pixels);
    message.area = static_cast<float>(thing.area_m2);
    message.table_share = static_cast<float>(thing.table_share);
    message.noise_ratio = static_cast<float>(thing.noise_ratio);
    message.pose.orientation.w = 1;
    message.has_box = thing.box.has_value();
    if (thing.box) {
      message.pose = toPose(thing.box->T_camera_box);
      message.dimensions = toVector3(thing.box->size_m);
    }
    messages.push_back(std::move(message));
  }
  return messages;
}

void addUnmeasured(const std::vector<objectness::Unmeasured>& things, const std_msgs::Header& header,
                   std::vector<Marker>& markers) {
  for (std::size_t k = 0; k < things.size(); ++k) {
    Marker outline = lines(header, 2 * k, Marker::LINE_STRIP);
    for (const Eigen::Vector3d& corner : things[k].outline) outline.points.push_back(toPoint(corner));
    if (!outline.points.empty()) outline.points.push_back(outline.points.front());
    markers.push_back(std::move(outline));
    if (!things[k].box) continue;
    Marker box = lines(header, 2 * k + 1, Marker::LINE_LIST);
    box.pose = toPose(things[k].box->T_camera_box);
    addBoxEdges(things[k].box->size_m, box.points);
    markers.push_back(std::move(box));
  }
}

}  // namespace objectness_segmentation
