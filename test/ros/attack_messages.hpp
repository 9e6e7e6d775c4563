// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <objectness_segmentation/SegmentedObjectArray.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/PointCloud2.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "fixtures/ray_cast.hpp"
#include "fixtures/ros_messages.hpp"
#include "ros/scene_messages.hpp"

namespace objectness_test {

/// An input that no camera should send, and what has to be said about it.
struct Attack {
  std::string name;
  sensor_msgs::PointCloud2 cloud;
  sensor_msgs::CameraInfo camera_info;
  int status = 0;
  std::string word;  ///< of the reason
};

/// Two boxes on a table; without: the table alone.
inline Scene attackedScene(int width, int height, bool with_boxes = true) {
  Scene scene;
  const double focal = 262.5 * width / 320;
  scene.camera = {focal, focal, 0.5 * (width - 1), 0.5 * (height - 1), width, height};
  scene.T_world_camera = lookAt({0, -0.65, 0.65}, {0, 0, 0.03});
  scene.surfaces = {slab(-0.5, -0.35, 0.5, 0.35, 0)};
  if (with_boxes) {
    scene.surfaces.push_back(box({-0.21, -0.04, 0}, {-0.09, 0.06, 0.14}));
    scene.surfaces.push_back(box({0.08, -0.02, 0}, {0.22, 0.08, 0.10}));
  }
  return scene;
}

/// A frame whose depth is depth(u, v).
inline objectness::Frame frameOfDepth(const objectness::PinholeCamera& camera,
                                      const std::function<double(int, int)>& depth) {
  objectness::Frame frame;
  frame.camera = camera;
  for (int i = 0; i < frame.size(); ++i) {
    const int u = i % camera.width, v = i / camera.width;
    frame.points.push_back((camera.ray(u, v) * depth(u, v)).cast<float>());
  }
  return frame;
}

/// Each in the given header. Those after which time goes on as before: stamps are the caller's.
inline std::vector<Attack> makeAttacks(const std_msgs::Header& header) {
  using objectness_segmentation::SegmentedObjectArray;
  using objectness_segmentation::toCameraInfo;
  using objectness_segmentation::toCloudMessage;
  Scene scene = attackedScene(320, 240);
  const Attack good{"good", toCloudMessage(scene.render(), header), toCameraInfo(scene.camera, header),
                    SegmentedObjectArray::OK, ""};
  std::vector<Attack> attacks;
  const auto add = [&](const std::string& name, int status, const std::string& word) -> Attack& {
    attacks.push_back(good);
    attacks.back().name = name;
    attacks.back().status = status;
    attacks.back().word = word;
    return attacks.back();
  };
  const auto addFrame = [&](const std::string& name, const objectness::Frame& frame, int status,
                            const std::string& word) {
    Attack& attack = add(name, status, word);
    attack.cloud = toCloudMessage(frame, header);
    attack.camera_info = toCameraInfo(frame.camera, header);
  };

  auto& nothing = add("all NaN", SegmentedObjectArray::NO_VALID_POINTS, "has a depth").cloud.data;
  std::fill(nothing.begin(), nothing.end(), 0xFF);
  addFrame("all infinite", frameOfDepth(scene.camera, [](int, int) { return kMiss; }),
           SegmentedObjectArray::NO_VALID_POINTS, "has a depth");
  addFrame("millimetres as metres", frameOfDepth(scene.camera, [](int, int) { return 850.0; }),
           SegmentedObjectArray::NO_VALID_POINTS, "unit");
  addFrame("all-equal depth", frameOfDepth(scene.camera, [](int, int) { return 1.0; }), SegmentedObjectArray::OK, "");
  std::mt19937 random(1);
  addFrame("no plane", frameOfDepth(scene.camera, [&](int, int) { return 0.5 + random() / 4294967296.0; }),
           SegmentedObjectArray::NO_TABLE, "table");
  addFrame("plane only", attackedScene(320, 240, false).render(), SegmentedObjectArray::OK, "");
  addFrame("1 x 1", frameOfDepth({500, 500, 0, 0, 1, 1}, [](int, int) { return 1.0; }), SegmentedObjectArray::NO_TABLE,
           "table");
  addFrame("one column", frameOfDepth({500, 500, 0, 100, 1, 200}, [](int, int) { return 1.0; }),
           SegmentedObjectArray::NO_TABLE, "table");
  addFrame("4096 x 3072", attackedScene(4096, 3072).render(), SegmentedObjectArray::OK, "");

  Attack& list = add("height 1", SegmentedObjectArray::NOT_ORGANIZED, "not organized");
  list.cloud.width *= list.cloud.height;
  list.cloud.height = 1;
  for (std::uint32_t u = 0; u < list.cloud.width; ++u) {
    const float x = 0.001F * static_cast<float>(u % 977);
    std::memcpy(pointAt(list.cloud, static_cast<int>(u), 0), &x, sizeof(x));
  }
  --add("row_step too small", SegmentedObjectArray::BAD_INPUT, "row_step").cloud.row_step;
  add("row_step too large", SegmentedObjectArray::BAD_INPUT, "carries").cloud.row_step += 100;
  add("point_step too small", SegmentedObjectArray::BAD_INPUT, "point_step").cloud.point_step = 3;
  add("data cut off", SegmentedObjectArray::BAD_INPUT, "carries").cloud.data.resize(1000);
  add("empty", SegmentedObjectArray::BAD_INPUT, "empty").cloud.width = 0;
  add("no fields", SegmentedObjectArray::BAD_INPUT, "no field").cloud.fields.clear();
  add("endian flag set", SegmentedObjectArray::BAD_INPUT, "big-endian").cloud.is_bigendian = true;
  add("empty frame_id", SegmentedObjectArray::OK, "").cloud.header.frame_id.clear();

  Attack& vast = add("a list and a vast camera", SegmentedObjectArray::BAD_CAMERA, "pixels in all");
  vast.cloud.width *= vast.cloud.height;
  vast.cloud.height = 1;
  vast.camera_info.width = vast.camera_info.height = 10000;

  Attack& zeros = add("K of zeros", SegmentedObjectArray::BAD_CAMERA, "not calibrated");
  zeros.camera_info.K.fill(0);
  zeros.camera_info.P.fill(0);
  Attack& nan = add("NaN in K", SegmentedObjectArray::BAD_CAMERA, "camera_info");
  nan.camera_info.P.fill(0);
  nan.camera_info.K[0] = std::numeric_limits<double>::quiet_NaN();
  add("NaN in P", SegmentedObjectArray::BAD_CAMERA, "camera_info").camera_info.P[6] =
      std::numeric_limits<double>::quiet_NaN();
  Attack& other = add("another camera", SegmentedObjectArray::BAD_CAMERA, "not the one");
  other.camera_info.P[0] = other.camera_info.K[0] = 600;
  Attack& size = add("another size", SegmentedObjectArray::SIZE_MISMATCH, "640");
  size.camera_info.width = 640;
  size.camera_info.height = 480;
  return attacks;
}

}  // namespace objectness_test
