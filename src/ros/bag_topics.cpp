// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/ros/bag_topics.hpp"

#include <rosbag/view.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/PointCloud2.h>

#include <algorithm>
#include <map>
#include <vector>

namespace objectness_segmentation {
namespace {

using objectness::Result;
using objectness::StatusCode;

struct Topic {
  std::string type;
  std::uint32_t messages = 0;
};
using Topics = std::map<std::string, Topic>;

Topics listTopics(const rosbag::Bag& bag) {
  Topics topics;
  rosbag::View all(bag);
  for (const rosbag::ConnectionInfo* connection : all.getConnections()) {
    rosbag::View messages(bag, rosbag::TopicQuery(connection->topic));
    topics[connection->topic] = {connection->datatype, messages.size()};
  }
  return topics;
}

std::string describe(const Topics& topics) {
  std::string text;
  for (const auto& [name, topic] : topics) {
    text += (text.empty() ? "" : ", ") + name + " (" + topic.type + ", " + std::to_string(topic.messages) + ")";
  }
  return text.empty() ? "no messages" : text;
}

/// Topics of the type that hold messages: all of them, or the wanted one.
template <class Message>
Result<std::vector<std::string>> findTopics(const Topics& topics, const std::string& wanted) {
  const std::string type = ros::message_traits::datatype<Message>();
  Result<std::vector<std::string>> found;
  for (const auto& [name, topic] : topics) {
    if (topic.type == type && topic.messages > 0 && (wanted.empty() || name == wanted)) found.value.push_back(name);
  }
  if (found.value.empty()) {
    found.status = {StatusCode::kBadInput, "holds no " + type + " on " + (wanted.empty() ? "any topic" : wanted) +
                                               ", but " + describe(topics)};
  }
  return found;
}

bool isOrganized(const rosbag::Bag& bag, const std::string& topic) {
  rosbag::View messages(bag, rosbag::TopicQuery(topic));
  const auto first = messages.begin()->instantiate<sensor_msgs::PointCloud2>();
  return first && first->height > 1;
}

std::size_t commonBeginning(const std::string& a, const std::string& b) {
  return static_cast<std::size_t>(std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin());
}

}  // namespace

Result<InputTopics> chooseTopics(const rosbag::Bag& bag, const InputTopics& wanted) {
  const Topics topics = listTopics(bag);
  auto clouds = findTopics<sensor_msgs::PointCloud2>(topics, wanted.points);
  if (!clouds.ok()) return Result<InputTopics>::error(clouds.status);
  const auto cameras = findTopics<sensor_msgs::CameraInfo>(topics, wanted.camera_info);
  if (!cameras.ok()) return Result<InputTopics>::error(cameras.status);

  auto& candidates = clouds.value;
  if (wanted.points.empty()) {
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                    [&](const std::string& topic) { return !isOrganized(bag, topic); }),
                     candidates.end());
    if (candidates.empty()) {
      return Result<InputTopics>::error(StatusCode::kBadInput,
                                        "its clouds are not organized (height 1): record the "
                                        "cloud of the camera driver as it is; the bag holds " +
                                            describe(topics));
    }
  }
  const auto fewer = [&](const std::string& a, const std::string& b) {
    return topics.at(a).messages < topics.at(b).messages;
  };
  InputTopics chosen;
  chosen.points = *std::max_element(candidates.begin(), candidates.end(), fewer);
  const auto farther = [&](const std::string& a, const std::string& b) {
    return commonBeginning(a, chosen.points) < commonBeginning(b, chosen.points);
  };
  chosen.camera_info = *std::max_element(cameras.value.begin(), cameras.value.end(), farther);
  return {{}, chosen};
}

}  // namespace objectness_segmentation
