// SPDX-License-Identifier: BSD-3-Clause
#include <diagnostic_msgs/DiagnosticStatus.h>
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "ros/diagnostics.hpp"

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
  inputs.first_seen = 5;
  EXPECT_NE(describeWith(snapshot, inputs).message.find("camera_info"), std::string::npos);
  inputs.camera_infos_seen = 5;
  inputs.first_stamp = ros::Time(12.5);
  inputs.camera_stamp = ros::Time(12.25);
  const std::string unpaired = describeWith(snapshot, inputs).message;
  EXPECT_NE(unpaired.find("approximate_sync"), std::string::npos) << unpaired;
  for (const char* number : {"12.500 s", "12.250 s", "0.250 s apart"}) {
    EXPECT_NE(unpaired.find(number), std::string::npos) << unpaired;
  }
  inputs.approximate = true;
  EXPECT_EQ(describeWith(snapshot, inputs).message.find("approximate_sync"), std::string::npos) << "it is on";
  inputs.frames = 1;
  EXPECT_NE(describeWith(snapshot, inputs).message.find("no more frames"), std::string::npos);
}

TEST(Diagnostics, NameFramesThatDiffer) {
  InputState inputs;
  inputs.first_seen = inputs.camera_infos_seen = 9;
  inputs.first_frame = "/left";
  inputs.camera_frame = "left";
  EXPECT_EQ(missingInput(inputs).find("frame_id"), std::string::npos);
  inputs.camera_frame = "right";
  EXPECT_NE(missingInput(inputs).find("(/left and right)"), std::string::npos) << missingInput(inputs);
  EXPECT_NE(missingInput(inputs).find("approximate_sync"), std::string::npos) << missingInput(inputs);
}

TEST(Diagnostics, SayWhyTheLastCameraIsUsed) {
  InputState inputs;
  inputs.first_topic = "/camera/points";
  inputs.camera_topic = "/camera/camera_info";
  inputs.first_stamp = ros::Time(12.5);
  const std::string sentence = lastCameraUsed(inputs);
  for (const char* part :
       {"/camera/points", "/camera/camera_info", "12.500 s apart", "the last one of their frame_id"}) {
    EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
  }
}

TEST(Diagnostics, AwaitInputForAWhile) {
  FrameStatistics::Snapshot snapshot;
  InputState inputs;
  snapshot.seconds_since_input = 60;
  EXPECT_FALSE(awaitedInput(snapshot, inputs)) << "nobody subscribes";
  inputs.subscribed = true;
  EXPECT_EQ(awaitedInput(snapshot, inputs).value_or(""), missingInput(inputs));
  snapshot.seconds_since_input = 1;
  EXPECT_FALSE(awaitedInput(snapshot, inputs));
}

TEST(Diagnostics, SayWhichTopicHasNoPublisher) {
  FrameStatistics::Snapshot snapshot;
  snapshot.seconds_since_input = 60;
  InputState inputs;
  inputs.subscribed = true;
  inputs.first_topic = "/camera/points";
  inputs.camera_topic = "/camera/camera_info";
  inputs.camera_publishers = 1;
  const std::string message = describeWith(snapshot, inputs).message;
  EXPECT_NE(message.find("/camera/points, which nobody publishes"), std::string::npos) << message;
  EXPECT_EQ(message.find("/camera/camera_info, which"), std::string::npos) << message;
}

TEST(Diagnostics, HoldRemarksStagesAndBoxes) {
  FrameStatistics statistics;
  statistics.noteStages({{"normals", 10}, {"table", 4}}, 20);
  statistics.noteRemark("the rgb image is too small");
  statistics.countOutput({}, 1, 14);
  statistics.noteStages({{"normals", 20}, {"table", 6}, {"selection", 1}}, 30);
  statistics.countOutput({}, 1, 27);
  InputState inputs;
  inputs.subscribed = true;
  const DiagnosticStatus status = describeWith(statistics.take(), inputs);
  EXPECT_EQ(status.level, DiagnosticStatus::WARN);
  EXPECT_EQ(status.message, "the rgb image is too small");
  std::map<std::string, std::string> values;
  for (const auto& value : status.values) values[value.key] = value.value;
  EXPECT_EQ(values["mean normals [ms]"], "15.0");
  EXPECT_EQ(values["mean table [ms]"], "5.0");
  EXPECT_EQ(values["mean selection [ms]"], "1.0");
  EXPECT_EQ(values["last boxes or groups scored"], "30");
  EXPECT_TRUE(statistics.take().mean_stages_ms.empty());
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
