// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/ColorRGBA.h>
#include <visualization_msgs/MarkerArray.h>

#include "common/color_palette.hpp"

namespace objectness_segmentation {

inline visualization_msgs::Marker makeMarker(const std_msgs::Header& header, const char* ns, int id, int type) {
  visualization_msgs::Marker marker;
  marker.header = header;
  marker.ns = ns;
  marker.id = id;
  marker.type = type;
  marker.action = visualization_msgs::Marker::ADD;
  marker.pose.orientation.w = 1;
  return marker;
}

/// Nothing but DELETEALL: in the same message as what follows, or the markers flicker.
inline visualization_msgs::MarkerArray emptyMarkers(const std_msgs::Header& header) {
  visualization_msgs::MarkerArray array;
  array.markers.push_back(makeMarker(header, "", 0, visualization_msgs::Marker::CUBE));
  array.markers.back().action = visualization_msgs::Marker::DELETEALL;
  return array;
}

inline std_msgs::ColorRGBA toColor(const objectness::Rgb& rgb, float alpha = 1) {
  std_msgs::ColorRGBA color;
  color.r = static_cast<float>(rgb.r) / 255;
  color.g = static_cast<float>(rgb.g) / 255;
  color.b = static_cast<float>(rgb.b) / 255;
  color.a = alpha;
  return color;
}

}  // namespace objectness_segmentation
