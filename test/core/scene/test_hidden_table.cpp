// SPDX-License-Identifier: BSD-3-Clause
// A gripper, a hand or a hole in the depth hides a part of a table over a floor that shows more of itself.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fixtures/temporary_folder.hpp"
#include "objectness_segmentation/io/scene_folder.hpp"
#include "objectness_segmentation/scene/table.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

constexpr double kGripperM = 0.35;
constexpr int kColumns = 5, kRows = 4;

/// The frame with a square of it without depth, or with a surface near to the camera in its place: at one of 20 places.
Frame masked(Frame frame, int place, int side_px, bool gripper) {
  const double u0 = (place % kColumns + 0.5) * frame.width() / kColumns - 0.5 * side_px;
  const double v0 = (place / kColumns + 0.5) * frame.height() / kRows - 0.5 * side_px;
  for (int v = 0; v < frame.height(); ++v) {
    for (int u = 0; u < frame.width(); ++u) {
      if (u < u0 || v < v0 || u >= u0 + side_px || v >= v0 + side_px) continue;
      Eigen::Vector3f& p = frame.points[v * frame.width() + u];
      if (gripper) {
        p = (kGripperM * frame.camera.ray(u, v)).cast<float>();
      } else {
        p.setConstant(std::numeric_limits<float>::quiet_NaN());
      }
    }
  }
  return frame;
}

Result<Table> tableOf(const Frame& frame) { return findTable(frame, estimateNormals(frame, {}), {}); }

/// A place on the table that is seen.
Eigen::Vector3d placeOn(const Table& table) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const auto& p : table.hull) mean += p / static_cast<double>(table.hull.size());
  return table.T_table_camera.inverse() * Eigen::Vector3d(mean.x(), mean.y(), 0);
}

/// Of all places how often the table is another one.
int countChanges(const Frame& frame, int side_px, bool gripper, double max_distance_m) {
  const Result<Table> whole = tableOf(frame);
  EXPECT_TRUE(whole.ok()) << whole.status.message;
  const Eigen::Vector3d place = placeOn(whole.value);
  int changes = 0;
  for (int k = 0; k < kColumns * kRows; ++k) {
    const Result<Table> table = tableOf(masked(frame, k, side_px, gripper));
    const bool same = table.ok() && table.value.normal.dot(whole.value.normal) > std::cos(4 * M_PI / 180) &&
                      std::abs(table.value.normal.dot(place) + table.value.d) < max_distance_m;
    if (same) continue;
    ++changes;
    ADD_FAILURE() << (gripper ? "gripper" : "hole") << " of " << side_px << " pixels at place " << k << ": d "
                  << table.value.d << " in place of " << whole.value.d << " " << table.status.message;
  }
  return changes;
}

}  // namespace

TEST(HiddenTable, OfRecordedScenesStaysTheTable) {
  const std::string data = sharedData();
  if (data.empty()) GTEST_SKIP() << "no shared data: set OBJECTNESS_DATA";
  for (const std::string name : {"ycbvideo/4", "uoc/5"}) {
    SCOPED_TRACE(name);
    const auto read = loadSceneFolder(data + "/" + name, std::nullopt, InputConfig());
    ASSERT_TRUE(read.ok()) << read.status.message;
    for (const int side_px : {160, 200}) {
      for (const bool gripper : {false, true}) EXPECT_EQ(countChanges(read.value, side_px, gripper, 0.015), 0);
    }
  }
}
