// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "integral/cue_points.hpp"
#include "integral/cue_volumes.hpp"
#include "ros/cloud_output.hpp"
#include "ros/debug_conversions.hpp"
#include "ros/geometry_output.hpp"
#include "ros/marker_parts.hpp"

namespace objectness_segmentation {
namespace {

using objectness::EdgeKind;

constexpr int kMargin_vox = 2;
constexpr int kMinHeight_vox = 3;
const objectness::Rgb kHiddenColor{120, 120, 200};

cv::Vec3b edgeColor(int kinds) {
  if (kinds & EdgeKind::kOccluding) return {0, 255, 255};
  if (kinds & EdgeKind::kOccluded) return {255, 100, 0};
  if (kinds & EdgeKind::kBorder) return {0, 0, 255};
  return {255, 255, 255};
}

/// The points of an image's pixels that are not 0, coloured by color(value) and labelled with the value.
template <class Value, class Color>
sensor_msgs::PointCloud2 toLabelledCloud(const cv::Mat_<Value>& image, const objectness::Frame& frame,
                                         const std_msgs::Header& header, const Color& color) {
  if (image.total() != frame.points.size()) return makeCloud(header, 0, true, true);
  const Value* values = image.template ptr<Value>();
  const auto shown = [&](std::size_t i) { return values[i] != 0 && !std::isnan(frame.points[i].z()); };
  std::size_t size = 0;
  for (std::size_t i = 0; i < frame.points.size(); ++i) size += shown(i);
  sensor_msgs::PointCloud2 cloud = makeCloud(header, size, true, true);
  std::uint8_t* destination = cloud.data.data();
  for (std::size_t i = 0; i < frame.points.size(); ++i) {
    if (!shown(i)) continue;
    const cv::Vec3b bgr = color(static_cast<int>(values[i]));
    writePoint(destination, frame.points[i], &bgr);
    writeLabel(destination, static_cast<std::uint32_t>(values[i]));
    destination += cloud.point_step;
  }
  return cloud;
}

}  // namespace

sensor_msgs::PointCloud2 toEdgesCloud(const SegmentedFrame& result, const std_msgs::Header& header) {
  return toLabelledCloud(result.segmentation.edges.kinds, result.frame, header, edgeColor);
}

sensor_msgs::PointCloud2 toSuperpixelsCloud(const SegmentedFrame& result, const std_msgs::Header& header) {
  return toLabelledCloud(result.segmentation.superpixels.label, result.frame, header, [](int label) {
    const objectness::Rgb color = objectness::objectColor(static_cast<std::size_t>(label - 1));
    return cv::Vec3b(color.b, color.g, color.r);
  });
}

std::vector<Eigen::Vector3d> hiddenVoxels(const SegmentedFrame& result, const objectness::Config& config) {
  const objectness::Segmentation& found = result.segmentation;
  std::vector<Eigen::Vector3d> voxels;
  if (!found.status.ok()) return voxels;
  const objectness::CuePoints points =
      collectCuePoints(result.frame, found.table, found.object_points, found.edges, found.superpixels);
  if (points.points.empty()) return voxels;
  const int max_height = static_cast<int>(std::ceil(config.object_points.max_height_m / config.volume.voxel_m));
  const objectness::Grid grid =
      makeGrid(points, 0, config.volume, kMargin_vox, kMinHeight_vox, std::max(kMinHeight_vox, max_height));
  const Eigen::Isometry3d T_camera_table = found.table.T_table_camera.inverse();
  for (int z = 0; z < grid.nz; ++z) {
    for (int y = 0; y < grid.ny; ++y) {
      for (int x = 0; x < grid.nx; ++x) {
        const Eigen::Vector3d p = grid.toTable({x + 0.5, y + 0.5, z + 0.5});
        if (isOccluded(result.frame, T_camera_table * p, config.volume)) voxels.push_back(p);
      }
    }
  }
  return voxels;
}

visualization_msgs::MarkerArray toHiddenMarkers(const SegmentedFrame& result,
                                                const std::vector<Eigen::Vector3d>& voxels, double voxel_m,
                                                const std_msgs::Header& header) {
  visualization_msgs::MarkerArray array = emptyMarkers(header);
  if (voxels.empty()) return array;
  visualization_msgs::Marker cubes = makeMarker(header, "occlusion", 0, visualization_msgs::Marker::CUBE_LIST);
  cubes.pose = toPose(result.segmentation.table.T_table_camera.inverse());
  cubes.scale.x = cubes.scale.y = cubes.scale.z = voxel_m;
  cubes.color = toColor(kHiddenColor, 0.4F);
  for (const Eigen::Vector3d& p : voxels) cubes.points.push_back(toPoint(p));
  array.markers.push_back(std::move(cubes));
  return array;
}

}  // namespace objectness_segmentation
