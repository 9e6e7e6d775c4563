// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/ros/synchronized_inputs.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "guarded.hpp"
#include "objectness_segmentation/ros/topics.hpp"
#include "stamp_pairs.hpp"

namespace objectness_segmentation {
namespace {

/// Stamps of two topics may be as much out of order; what goes back farther is a jump in time.
constexpr double kDisorder_s = 0.5;
/// Clouds wait this long (wall time) for the first camera_info.
constexpr std::chrono::seconds kCameraPatience{2};
/// A picture goes with a depth image that is this near in time.
constexpr double kColorDistance_s = 0.1;
constexpr std::size_t kColorsKept = 10;

/// ros::Duration throws where the difference is too long for it, and any stamp may come.
double secondsBetween(const ros::Time& from, const ros::Time& to) { return to.toSec() - from.toSec(); }

}  // namespace

SynchronizedInputs::SynchronizedInputs(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh,
                                       const InputSettings& settings, Callbacks callbacks)
    : nh_(nh), private_nh_(private_nh), settings_(settings), callbacks_(std::move(callbacks)), image_transport_(nh) {
  if (settings.depth) {
    depth_pairs_ = std::make_unique<StampPairs<sensor_msgs::Image>>(
        settings.queue_size, settings.approximate, [this](const auto& depth, const auto& camera) {
          hand({nullptr, camera, depth, nearestColor(depth->header.stamp)});
        });
  } else {
    cloud_pairs_ = std::make_unique<StampPairs<sensor_msgs::PointCloud2>>(
        settings.queue_size, settings.approximate, [this](const auto& cloud, const auto& camera) {
          hand({cloud, camera, nullptr, nullptr});
        });
  }
}

SynchronizedInputs::~SynchronizedInputs() { unsubscribe(); }

void SynchronizedInputs::subscribe() {
  if (subscribed_.exchange(true)) return;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    counted_ = {};
    first_time_ = camera_time_ = {};
    recent_cameras_.clear();
    recent_firsts_.clear();
    colors_.clear();
    forgetPairs();
  }
  const auto size = static_cast<std::uint32_t>(settings_.queue_size);
  camera_ = nh_.subscribe(topics::kCameraInfo, size, &SynchronizedInputs::receiveCamera, this);
  if (!settings_.depth) {
    cloud_ = nh_.subscribe(topics::kPoints, size, &SynchronizedInputs::receiveCloud, this);
    return;
  }
  const auto hints = [this](const char* parameter) {
    return image_transport::TransportHints("raw", {}, private_nh_, parameter);
  };
  color_ = image_transport_.subscribe(topics::kColor, size, &SynchronizedInputs::receiveColor, this,
                                      hints("image_transport"));
  depth_ = image_transport_.subscribe(topics::kDepth, size, &SynchronizedInputs::receiveDepth, this,
                                      hints("depth_image_transport"));
}

void SynchronizedInputs::unsubscribe() {
  if (!subscribed_.exchange(false)) return;
  cloud_.shutdown();
  depth_.shutdown();
  color_.shutdown();
  camera_.shutdown();
}

InputState SynchronizedInputs::state() const {
  std::lock_guard<std::mutex> lock(mutex_);
  InputState state = counted_;
  state.subscribed = subscribed_;
  state.first_topic = nh_.resolveName(settings_.depth ? topics::kDepth : topics::kPoints);
  state.camera_topic = nh_.resolveName(topics::kCameraInfo);
  state.first_publishers = settings_.depth ? depth_.getNumPublishers() : cloud_.getNumPublishers();
  state.camera_publishers = camera_.getNumPublishers();
  return state;
}

void SynchronizedInputs::hand(const InputMessages& messages) {
  ++counted_.frames;
  callbacks_.frame(messages);
}

void SynchronizedInputs::forgetPairs() {
  if (cloud_pairs_) cloud_pairs_->clear();
  if (depth_pairs_) depth_pairs_->clear();
}

void SynchronizedInputs::noticeJump(const ros::Time& stamp, TopicTime& topic, TopicTime& other) {
  const bool first_message = topic.newest.isZero();
  const bool back = !first_message && secondsBetween(stamp, topic.newest) > kDisorder_s;
  topic.newest = back ? stamp : std::max(topic.newest, stamp);
  if (back && topic.epoch >= other.epoch) {
    ++topic.epoch;
    other.stale = 0;
    forgetPairs();
    colors_.clear();
    recent_cameras_.clear();
    recent_firsts_.clear();
    callbacks_.jump();
  } else if (back || first_message) {
    // The other one went back before: what waits for its partner is of the new time, unless it came on this topic.
    topic.epoch = other.epoch;
    if (topic.stale > 0) {
      forgetPairs();
      for (const auto& camera : recent_cameras_) addCamera(camera);
      for (const auto& add_again : std::exchange(recent_firsts_, {})) add_again();
    }
    topic.stale = 0;
  } else if (topic.epoch < other.epoch) {
    ++topic.stale;
  }
}

void SynchronizedInputs::addCamera(const sensor_msgs::CameraInfoConstPtr& camera) {
  if (cloud_pairs_) cloud_pairs_->addCamera(camera);
  if (depth_pairs_) depth_pairs_->addCamera(camera);
}

/// What came on the first topic while the camera_info of the time before is still coming must not be lost with that.
void SynchronizedInputs::addFirst(const std::function<void()>& add) {
  if (first_time_.epoch > camera_time_.epoch) {
    recent_firsts_.push_back(add);
    if (recent_firsts_.size() > static_cast<std::size_t>(settings_.queue_size)) recent_firsts_.pop_front();
  } else {
    recent_firsts_.clear();
  }
  add();
}

/// Whether there has been no camera_info for so long that there will be none.
bool SynchronizedInputs::noteFirst(const ros::Time& stamp) {
  noticeJump(stamp, first_time_, camera_time_);
  if (counted_.first_seen++ == 0) first_arrival_ = Clock::now();
  counted_.first_stamp = stamp;
  return counted_.camera_infos_seen == 0 && Clock::now() - first_arrival_ > kCameraPatience;
}

/// message_filters, too, throws at stamps that are too far apart.
template <class TakeIn>
void SynchronizedInputs::guarded(const TakeIn& take_in) {
  objectness_segmentation::guarded(
      [&] {
        std::lock_guard<std::mutex> lock(mutex_);
        take_in();
      },
      callbacks_.exception);
}

void SynchronizedInputs::receiveCloud(const sensor_msgs::PointCloud2ConstPtr& cloud) {
  guarded([&] {
    if (noteFirst(cloud->header.stamp)) {
      hand({cloud, nullptr, nullptr, nullptr});
    } else {
      addFirst([this, cloud] { cloud_pairs_->addFirst(cloud); });
    }
  });
}

void SynchronizedInputs::receiveDepth(const sensor_msgs::ImageConstPtr& depth) {
  guarded([&] {
    noteFirst(depth->header.stamp);
    addFirst([this, depth] { depth_pairs_->addFirst(depth); });
  });
}

void SynchronizedInputs::receiveCamera(const sensor_msgs::CameraInfoConstPtr& camera) {
  guarded([&] {
    noticeJump(camera->header.stamp, camera_time_, first_time_);
    ++counted_.camera_infos_seen;
    counted_.camera_stamp = camera->header.stamp;
    if (camera_time_.epoch >= first_time_.epoch) recent_cameras_.push_back(camera);
    if (recent_cameras_.size() > static_cast<std::size_t>(settings_.queue_size)) recent_cameras_.pop_front();
    addCamera(camera);
  });
}

void SynchronizedInputs::receiveColor(const sensor_msgs::ImageConstPtr& color) {
  guarded([&] {
    ++counted_.colors_seen;
    colors_.push_back(color);
    if (colors_.size() > kColorsKept) colors_.pop_front();
  });
}

sensor_msgs::ImageConstPtr SynchronizedInputs::nearestColor(const ros::Time& stamp) const {
  sensor_msgs::ImageConstPtr nearest;
  double least = kColorDistance_s;
  for (const auto& color : colors_) {
    const double distance = std::abs(secondsBetween(stamp, color->header.stamp));
    if (distance <= least) least = distance, nearest = color;
  }
  return nearest;
}

}  // namespace objectness_segmentation
