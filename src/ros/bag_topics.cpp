// SPDX-License-Identifier: BSD-3-Clause
#include "ros/bag_topics.hpp"

#include <rosbag/view.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/image_encodings.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <vector>

#include "ros/recorded_image.hpp"

namespace objectness_segmentation {
namespace {

namespace encodings = sensor_msgs::image_encodings;
using objectness::Result;
using objectness::StatusCode;
using Names = std::vector<std::string>;
using Choice = Result<InputTopics>;

struct Topic {
  std::string type;
  std::uint32_t messages = 0;
};

std::size_t commonBeginning(const std::string& a, const std::string& b) {
  return static_cast<std::size_t>(std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin());
}

Choice bad(const std::string& message) { return Choice::error(StatusCode::kBadInput, message); }

bool contains(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

class TopicChooser {
 public:
  explicit TopicChooser(const rosbag::Bag& bag) : bag_(bag) {
    rosbag::View all(bag);
    for (const rosbag::ConnectionInfo* connection : all.getConnections()) {
      rosbag::View messages(bag, rosbag::TopicQuery(connection->topic));
      topics_[connection->topic] = {connection->datatype, messages.size()};
    }
  }

  Choice choose(const InputTopics& wanted) const {
    const Result<Names> cameras = find<sensor_msgs::CameraInfo>(wanted.camera_info);
    if (!cameras.ok() && !wanted.camera_info.empty()) return Choice::error(cameras.status);
    const bool depth = !wanted.depth.empty() || !wanted.color.empty();
    Choice chosen = depth ? ofDepth(wanted, cameras) : ofClouds(wanted.points, cameras);
    if (!chosen.ok() && !depth && wanted.points.empty()) chosen = anyOther(cameras, chosen);
    if (chosen.ok() && !cameras.value.empty()) {
      const std::string& first = chosen.value.first();
      chosen.value.camera_info = *std::max_element(
          cameras.value.begin(), cameras.value.end(),
          [&](const auto& a, const auto& b) { return commonBeginning(a, first) < commonBeginning(b, first); });
    }
    return chosen;
  }

 private:
  /// Topics of the type that hold messages: all of them, or the wanted one.
  template <class Message>
  Result<Names> find(const std::string& wanted) const {
    const std::string type = ros::message_traits::datatype<Message>();
    Result<Names> found;
    for (const auto& [name, topic] : topics_) {
      if (topic.type == type && topic.messages > 0 && (wanted.empty() || name == wanted)) found.value.push_back(name);
    }
    if (found.value.empty()) {
      found.status = {StatusCode::kBadInput,
                      "holds no " + type + " on " + (wanted.empty() ? "any topic" : wanted) + ", but " + describe()};
    }
    return found;
  }

  /// Topics of images, raw or compressed. As image_transport has it, the name of the raw topic stands for the
  /// compressed one, where only that was recorded.
  Result<Names> findImages(const std::string& wanted) const {
    Result<Names> raw = find<sensor_msgs::Image>(wanted), found = raw;
    for (const char* transport : {"", "/compressedDepth", "/compressed"}) {
      if (wanted.empty() && *transport) break;
      const Result<Names> compressed = find<sensor_msgs::CompressedImage>(wanted.empty() ? wanted : wanted + transport);
      if (compressed.ok()) found.value.insert(found.value.end(), compressed.value.begin(), compressed.value.end());
    }
    if (!found.value.empty()) found.status = {};
    return found;
  }
  bool isRaw(const std::string& topic) const {
    return topics_.at(topic).type == ros::message_traits::datatype<sensor_msgs::Image>();
  }

  std::string describe() const {
    std::string text;
    for (const auto& [name, topic] : topics_) {
      text += (text.empty() ? "" : ", ") + name + " (" + topic.type + ", " + std::to_string(topic.messages) + ")";
    }
    return text.empty() ? "no messages" : text;
  }

  template <class Message>
  boost::shared_ptr<const Message> firstOf(const std::string& topic) const {
    rosbag::View messages(bag_, rosbag::TopicQuery(topic));
    return messages.begin()->instantiate<Message>();
  }
  /// Null: of another version, or it cannot be decoded.
  sensor_msgs::ImageConstPtr firstImage(const std::string& topic) const {
    rosbag::View messages(bag_, rosbag::TopicQuery(topic));
    try {
      return readImage(*messages.begin());
    } catch (const rosbag::BagFormatException&) {
      return nullptr;
    }
  }
  bool isOrganized(const std::string& topic) const {
    const auto first = firstOf<sensor_msgs::PointCloud2>(topic);
    return first && first->height > 1;
  }
  std::string most(const Names& names) const {
    return *std::max_element(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
      return topics_.at(a).messages < topics_.at(b).messages;
    });
  }

  Choice ofClouds(const std::string& wanted, const Result<Names>& cameras) const {
    Result<Names> clouds = find<sensor_msgs::PointCloud2>(wanted);
    if (!clouds.ok()) return Choice::error(clouds.status);
    Names& names = clouds.value;
    const auto organized =
        std::stable_partition(names.begin(), names.end(), [&](const std::string& name) { return isOrganized(name); });
    InputTopics topics;
    if (organized != names.begin()) {
      names.erase(organized, names.end());
    } else if (wanted.empty() || !cameras.ok()) {
      return bad(
          "its clouds are not organized (height 1), which takes a camera_info: record that of their camera, or the "
          "cloud "
          "of the camera driver as it is; the bag holds " +
          describe());
    }
    topics.points = most(names);
    return {{}, topics};
  }

  Choice ofDepth(const InputTopics& wanted, const Result<Names>& cameras) const {
    const Result<Names> depths = findImages(wanted.depth), colors = findImages(wanted.color);
    if (!depths.ok()) return Choice::error(depths.status);
    if (!colors.ok()) return Choice::error(colors.status);
    const Names candidates = wanted.depth.empty() ? depthAmong(depths.value, wanted.color) : depths.value;
    if (candidates.empty() || !wanted.depth.empty()) {
      const std::string problem = undecodedAmong(depths.value);
      if (!problem.empty()) return bad(problem);
    }
    if (candidates.empty()) {
      return bad("holds no sensor_msgs/Image of 16UC1 or 32FC1, compressed or not, on any topic, but " + describe());
    }
    if (!cameras.ok()) return bad("depth images need a camera_info, and the bag " + cameras.status.message);
    std::map<std::string, std::string> color_of;
    for (const std::string& depth : candidates) {
      color_of[depth] = wanted.color.empty() ? pictureOf(depth, colors.value) : colors.value.front();
    }
    const auto rank = [&](const std::string& name) {
      return std::make_tuple(contains(name, "depth"), !color_of[name].empty(), contains(name, "rect"), isRaw(name),
                             topics_.at(name).messages);
    };
    InputTopics topics;
    topics.depth = *std::max_element(candidates.begin(), candidates.end(),
                                     [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
    topics.color = color_of[topics.depth];
    return {{}, topics};
  }

  /// What is taken where there are no organized clouds and nothing is asked for.
  Choice anyOther(const Result<Names>& cameras, const Choice& otherwise) const {
    const Result<Names> images = findImages(""), clouds = find<sensor_msgs::PointCloud2>("");
    if (!depthAmong(images.value, "").empty() || !undecodedAmong(images.value).empty()) return ofDepth({}, cameras);
    if (!clouds.ok() || !cameras.ok()) return otherwise;
    InputTopics topics;
    topics.points = most(clouds.value);
    return {{}, topics};
  }

  Names depthAmong(Names images, const std::string& color) const {
    const auto is_other = [&](const std::string& name) { return name == color || !isDepth(name); };
    images.erase(std::remove_if(images.begin(), images.end(), is_other), images.end());
    return images;
  }
  /// Why a compressed depth image cannot be read; empty: there is none such.
  std::string undecodedAmong(const Names& images) const {
    for (const std::string& name : images) {
      const auto first = firstOf<sensor_msgs::CompressedImage>(name);
      if (!first || !isCompressedDepth(*first)) continue;
      const auto decoded = decodeDepth(*first);
      if (!decoded.ok()) return name + " " + decoded.status.message;
    }
    return {};
  }
  bool isDepth(const std::string& topic) const {
    const auto first = firstImage(topic);
    return first && (first->encoding == encodings::TYPE_16UC1 || first->encoding == encodings::TYPE_32FC1);
  }
  /// The one that is registered to the depth images; empty: there is none.
  std::string pictureOf(const std::string& depth, const Names& images) const {
    const auto image = firstImage(depth);
    Names found;
    for (const std::string& name : images) {
      const auto color = firstImage(name);
      if (image && color && name != depth && encodings::isColor(color->encoding) && color->width == image->width &&
          color->height == image->height && color->header.frame_id == image->header.frame_id) {
        found.push_back(name);
      }
    }
    const auto compressed =
        std::stable_partition(found.begin(), found.end(), [&](const std::string& name) { return isRaw(name); });
    if (compressed != found.begin()) found.erase(compressed, found.end());
    return found.empty() ? std::string() : most(found);
  }

  const rosbag::Bag& bag_;
  std::map<std::string, Topic> topics_;
};

}  // namespace

Result<InputTopics> chooseTopics(const rosbag::Bag& bag, const InputTopics& wanted) {
  return TopicChooser(bag).choose(wanted);
}

}  // namespace objectness_segmentation
