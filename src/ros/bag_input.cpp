// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/ros/bag_input.hpp"

#include <rosbag/view.h>

#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>

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

/// Messages whose definition differs from the one this program was built with cannot be read.
template <class Message>
boost::shared_ptr<const Message> read(const rosbag::MessageInstance& entry) {
  boost::shared_ptr<const Message> message = entry.instantiate<Message>();
  if (!message) {
    throw rosbag::BagFormatException(entry.getTopic() + " holds another version of " +
                                     ros::message_traits::datatype<Message>());
  }
  return message;
}

}  // namespace

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
  cloud_count_ = rosbag::View(bag_, rosbag::TopicQuery(topics_.points)).size();
  try {
    rosbag::View cameras(bag_, rosbag::TopicQuery(topics_.camera_info));
    for (const rosbag::MessageInstance& entry : cameras) {
      const auto camera = read<sensor_msgs::CameraInfo>(entry);
      cameras_.emplace(camera->header.stamp, camera);
    }
  } catch (const std::exception& e) {
    camera_damage_ = e.what();  // the clouds before it can be used
  }
}

sensor_msgs::CameraInfoConstPtr BagInput::findCamera(const ros::Time& stamp, bool approximate) const {
  const auto later = cameras_.lower_bound(stamp);
  if (later == cameras_.end() && !camera_damage_.empty()) throw rosbag::BagFormatException(camera_damage_);
  if (later != cameras_.end() && later->first == stamp) return later->second;
  if (!approximate || cameras_.empty()) return nullptr;
  if (later == cameras_.begin()) return later->second;
  const auto earlier = std::prev(later);
  return later == cameras_.end() || stamp - earlier->first <= later->first - stamp ? earlier->second : later->second;
}

Status BagInput::forEachCloud(bool approximate, const Visit& visit) const {
  std::size_t done = 0;
  try {
    rosbag::View clouds(bag_, rosbag::TopicQuery(topics_.points));
    for (const rosbag::MessageInstance& entry : clouds) {
      const auto cloud = read<sensor_msgs::PointCloud2>(entry);
      if (!visit({cloud, findCamera(cloud->header.stamp, approximate)}, entry.getTime())) break;
      ++done;
    }
  } catch (const std::exception& e) {
    return bad("is damaged after " + std::to_string(done) + " of " + std::to_string(cloud_count_) +
               " clouds: " + e.what());
  }
  return {};
}

}  // namespace objectness_segmentation
