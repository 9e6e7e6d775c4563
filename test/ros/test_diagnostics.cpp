// SPDX-License-Identifier: BSD-3-Clause
#include <diagnostic_msgs/DiagnosticStatus.h>
#include <gtest/gtest.h>

#include <string>

#include "objectness_segmentation/ros/diagnostics.hpp"

namespace {

using namespace objectness_segmentation;
using diagnostic_msgs::DiagnosticStatus;
using objectness::Status;
using objectness::StatusCode;

TEST(FrameStatistics, GathersBetweenSnapshots) {
  FrameStatistics statistics;
  for (int i = 0; i < 3; ++i) statistics.countInput();
  statistics.countOutput({}, 4, 100);
  statistics.countOutput(Status::error(StatusCode::kNoTable, "no plane"), 0, 300);
  FrameStatistics::Snapshot snapshot = statistics.take();
  EXPECT_GT(snapshot.seconds, 0);
  EXPECT_NEAR(snapshot.input_hz * snapshot.seconds, 3, 1e-9);
  EXPECT_NEAR(snapshot.output_hz * snapshot.seconds, 2, 1e-9);
  EXPECT_DOUBLE_EQ(snapshot.mean_latency_ms, 200);
  EXPECT_DOUBLE_EQ(snapshot.max_latency_ms, 300);
  EXPECT_EQ(snapshot.last_status.code, StatusCode::kNoTable);
  snapshot = statistics.take();
  EXPECT_EQ(snapshot.input_hz, 0);
  EXPECT_EQ(snapshot.mean_latency_ms, 0);
  EXPECT_EQ(snapshot.last_status.code, StatusCode::kNoTable);  // still the last one known
}

TEST(FrameStatistics, AnExceptionIsForgottenWithTheNextGoodFrame) {
  FrameStatistics statistics;
  statistics.noteException("out of memory");
  statistics.countOutput(Status::error(StatusCode::kInternalError, "out of memory"), 0, 1);
  EXPECT_EQ(statistics.take().exception, "out of memory");
  statistics.countOutput({}, 1, 1);
  EXPECT_TRUE(statistics.take().exception.empty());
}

DiagnosticStatus describeWith(const FrameStatistics::Snapshot& snapshot, const InputState& inputs) {
  diagnostic_updater::DiagnosticStatusWrapper status;
  describe(snapshot, inputs, status);
  return status;
}

TEST(Diagnostics, NameWhatIsMissing) {
  FrameStatistics::Snapshot snapshot;
  InputState inputs;
  DiagnosticStatus status = describeWith(snapshot, inputs);
  EXPECT_EQ(status.level, DiagnosticStatus::OK);
  EXPECT_NE(status.message.find("idle"), std::string::npos);

  inputs.subscribed = true;
  EXPECT_EQ(describeWith(snapshot, inputs).level, DiagnosticStatus::OK);
  snapshot.seconds_since_input = 60;
  EXPECT_EQ(describeWith(snapshot, inputs).level, DiagnosticStatus::WARN);
  inputs.clouds_seen = 5;
  EXPECT_NE(describeWith(snapshot, inputs).message.find("camera_info"), std::string::npos);
  inputs.camera_infos_seen = 5;
  EXPECT_NE(describeWith(snapshot, inputs).message.find("approximate_sync"), std::string::npos);
}

TEST(Diagnostics, TellAFailedFrameFromAnException) {
  FrameStatistics::Snapshot snapshot;
  InputState inputs;
  inputs.subscribed = true;
  snapshot.last_status = Status::error(StatusCode::kNoTable, "no plane");
  DiagnosticStatus status = describeWith(snapshot, inputs);
  EXPECT_EQ(status.level, DiagnosticStatus::WARN);
  EXPECT_EQ(status.message, "no plane");
  snapshot.exception = "out of memory";
  status = describeWith(snapshot, inputs);
  EXPECT_EQ(status.level, DiagnosticStatus::ERROR);
  EXPECT_EQ(status.message, "out of memory");
}

}  // namespace
