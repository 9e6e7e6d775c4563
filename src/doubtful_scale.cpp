// SPDX-License-Identifier: BSD-3-Clause
#include "doubtful_scale.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include "common/upper_median.hpp"

namespace objectness {
namespace {

// Depth of 1/5000 m read as millimetres puts a table at arm's length four metres off; depth of 1/256 m puts it under
// the camera's nose. Tables and things beyond these do occur, so that it is a remark.
constexpr double kMaxTableDepthM = 2.5, kMinTableDepthM = 0.25;
constexpr double kMaxDepthM = 4.0;
// A large thing on a table that is near is rather a wrong segment.
constexpr double kMaxObjectM = 0.8, kFarTableDepthM = 1.2;

/// NaN when none of them is wanted.
template <class Wanted>
double medianDepth(const Frame& frame, const Wanted& wanted) {
  std::vector<float> depths;
  for (int i = 0; i < frame.size(); ++i) {
    if (wanted(i) && std::isfinite(frame.points[i].z())) depths.push_back(frame.points[i].z());
  }
  if (depths.empty()) return std::nan("");
  return upperMedian(depths);
}

}  // namespace

std::string doubtfulScale(const Frame& frame, const Segmentation& result) {
  const char* const advice =
      ": is the depth in millimetres (16 bits) or metres? Another unit is set by --depth-scale, depth_scale in "
      "camera.yaml or input.depth_unit_m";
  std::ostringstream remark;
  remark.precision(2);
  const cv::Mat_<uchar>& on_table = result.object_points.on_table;
  if (on_table.empty()) {
    const double depth = medianDepth(frame, [](int) { return true; });
    if (!(depth > kMaxDepthM)) return "";
    remark << "half of what is seen is farther than " << depth << " m" << advice;
    return remark.str();
  }
  const double depth = medianDepth(frame, [&](int i) { return on_table(i) != 0; });
  if (depth > kMaxTableDepthM || depth < kMinTableDepthM) {
    remark << "the table is " << depth << " m away" << advice;
    return remark.str();
  }
  double largest = 0;
  for (const Segment& segment : result.segments) largest = std::max(largest, segment.box.size_m.maxCoeff());
  if (!(largest > kMaxObjectM && depth > kFarTableDepthM)) return "";
  remark << "an object is " << largest << " m large" << advice;
  return remark.str();
}

}  // namespace objectness
