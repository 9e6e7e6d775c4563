// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <boost/make_shared.hpp>

#include "attack_messages.hpp"
#include "objectness_segmentation/ros/segment_messages.hpp"

namespace {

using namespace objectness_segmentation;
using namespace objectness_test;

TEST(Attacks, HaveANamedStatusEach) {
  for (const Attack& attack : makeAttacks(makeHeader())) {
    InputMessages messages;
    messages.cloud = boost::make_shared<sensor_msgs::PointCloud2>(attack.cloud);
    messages.camera_info = boost::make_shared<sensor_msgs::CameraInfo>(attack.camera_info);
    const SegmentedFrame result = segmentMessages(messages, {}, {}, nullptr);
    const objectness::Status& status = result.segmentation.status;
    EXPECT_EQ(static_cast<int>(status.code), attack.status)
        << attack.name << ": " << toString(status.code) << ": " << status.message;
    EXPECT_EQ(status.message.empty(), status.ok()) << attack.name;
    EXPECT_NE(status.message.find(attack.word), std::string::npos) << attack.name << ": " << status.message;
  }
}

}  // namespace
