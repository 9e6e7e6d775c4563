// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fuzz_input.hpp"
#include "objectness_segmentation/scene/frame.hpp"

namespace objectness_fuzz {

/// Of every Status: a reason if and only if something is wrong.
inline void requireReason(const objectness::Status& status) {
  require(status.ok() == status.message.empty(), "a status has a reason when it is not OK");
}

/// Of every frame that was made: sizes agree, points lie within the range of depth or are NaN.
inline void requireFrame(const objectness::Result<objectness::Frame>& result, const objectness::InputConfig& config) {
  requireReason(result.status);
  if (!result.ok()) return;
  const objectness::Frame& frame = result.value;
  require(objectness::validate(frame.camera).ok(), "a frame has a camera");
  require(frame.points.size() == static_cast<std::size_t>(frame.size()), "a frame has a point per pixel");
  require(frame.color.empty() || (frame.color.cols == frame.width() && frame.color.rows == frame.height()),
          "colours have the frame's size");
  for (const Eigen::Vector3f& p : frame.points) {
    const bool valid = p.allFinite() && p.z() >= config.min_depth_m && p.z() <= config.max_depth_m;
    require(valid || (p.x() != p.x() && p.y() != p.y() && p.z() != p.z()), "points are within range or NaN");
  }
}

}  // namespace objectness_fuzz
