// SPDX-License-Identifier: BSD-3-Clause
#include "ros/bag_input.hpp"

#include <exception>
#include <filesystem>
#include <fstream>

#include "ros/recorded_cameras.hpp"
#include "ros/recorded_colors.hpp"
#include "ros/recorded_image.hpp"

namespace objectness_segmentation {
namespace {

using objectness::Status;
using objectness::StatusCode;

Status bad(const std::string& message) { return Status::error(StatusCode::kBadInput, message); }

/// What rosbag cannot tell apart: no file, another kind of file, a bag of another version.
Status checkFile(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return bad("there is no such file");
  if (std::filesystem::is_directory(path, ignored)) return bad("is a folder, not a bag");
  std::ifstream file(path, std::ios::binary);
  if (!file) return bad("cannot be read: permission denied");
  constexpr char kMagic[] = "#ROSBAG V";
  std::string head(sizeof(kMagic) - 1, '\0');
  if (!file.read(head.data(), static_cast<std::streamsize>(head.size())) || head != kMagic) {
    return bad("is no bag of ROS 1 (it does not begin with " + std::string(kMagic) + ")");
  }
  return {};
}

}  // namespace

BagInput::BagInput() : cameras_(std::make_unique<RecordedCameras>()) {}
BagInput::~BagInput() = default;

objectness::Result<std::unique_ptr<BagInput>> BagInput::open(const std::string& path, const InputTopics& wanted) {
  objectness::Result<std::unique_ptr<BagInput>> input;
  input.status = checkFile(path);
  if (!input.ok()) return input;
  try {
    input.value = std::make_unique<BagInput>();
    input.value->load(path, wanted, input.status);
  } catch (const rosbag::BagUnindexedException&) {
    input.status = bad("has no index: its recording was broken off; rosbag reindex can repair it");
  } catch (const std::exception& e) {
    input.status = bad(std::string("is damaged or cut off: ") + e.what());
  }
  return input;
}

void BagInput::load(const std::string& path, const InputTopics& wanted, Status& status) {
  bag_.open(path, rosbag::bagmode::Read);
  const auto topics = chooseTopics(bag_, wanted);
  status = topics.status;
  if (!status.ok()) return;
  topics_ = topics.value;
  frame_count_ = rosbag::View(bag_, rosbag::TopicQuery(topics_.first())).size();
  if (topics_.camera_info.empty()) return;
  try {
    rosbag::View cameras(bag_, rosbag::TopicQuery(topics_.camera_info));
    for (const rosbag::MessageInstance& entry : cameras) {
      cameras_->add(readMessage<sensor_msgs::CameraInfo>(entry), entry.getTime());
    }
  } catch (const std::exception& e) {
    camera_damage_ = e.what();  // the frames before it can be used
  }
}

sensor_msgs::CameraInfoConstPtr BagInput::findCamera(const std_msgs::Header& header, const ros::Time& recorded,
                                                     bool approximate) const {
  if (!camera_damage_.empty() && !cameras_->holds(header.stamp) && !cameras_->reachBeyond(header.stamp, recorded)) {
    throw rosbag::BagFormatException(camera_damage_);
  }
  return cameras_->find(header, recorded, approximate);
}

Status BagInput::forEachFrame(bool approximate, const Visit& visit) const {
  std::size_t done = 0;
  try {
    RecordedColors colors(bag_, topics_.color);
    rosbag::View frames(bag_, rosbag::TopicQuery(topics_.first()));
    for (const rosbag::MessageInstance& entry : frames) {
      InputMessages messages;
      if (topics_.ofDepth()) {
        messages.depth = readImage(entry);
        messages.color = colors.find(messages.depth->header.stamp, entry.getTime());
      } else {
        messages.cloud = readMessage<sensor_msgs::PointCloud2>(entry);
      }
      messages.camera_info = findCamera(messages.header(), entry.getTime(), approximate);
      if (!visit(messages, entry.getTime())) break;
      ++done;
    }
  } catch (const std::exception& e) {
    return bad("is damaged after " + std::to_string(done) + " of " + std::to_string(frame_count_) + " " + frameName() +
               "s: " + e.what());
  }
  return {};
}

}  // namespace objectness_segmentation
