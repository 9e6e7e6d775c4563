// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/ColorRGBA.h>
#include <visualization_msgs/MarkerArray.h>

#include <vector>

#include "common/color_palette.hpp"
#include "ros/geometry_output.hpp"

namespace objectness_segmentation {

constexpr double kLineWidth = 0.003;  // metres, thin beside the smallest box of 3 cm

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

/// The twelve edges of the box, as pairs of points in its own frame.
inline void addBoxEdges(const Eigen::Vector3d& size, std::vector<geometry_msgs::Point>& points) {
  const auto corner = [&size](int i) {
    return toPoint(Eigen::Vector3d((i & 1) - 0.5, ((i >> 1) & 1) - 0.5, ((i >> 2) & 1) - 0.5).cwiseProduct(size));
  };
  for (int from = 0; from < 8; ++from) {
    for (int axis = 0; axis < 3; ++axis) {
      if (from & (1 << axis)) continue;
      points.push_back(corner(from));
      points.push_back(corner(from | (1 << axis)));
    }
  }
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
