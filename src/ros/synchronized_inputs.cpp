// SPDX-License-Identifier: BSD-3-Clause
#include "ros/synchronized_inputs.hpp"

#include <algorithm>
#include <utility>

#include "objectness_segmentation/ros/topics.hpp"
#include "ros/camera_partners.hpp"
#include "ros/diagnostics.hpp"
#include "ros/guarded.hpp"
#include "ros/nearest_color.hpp"
#include "ros/public_names.hpp"

namespace objectness_segmentation {
namespace {

using Clock = CameraPartners::Clock;

/// Stamps of two topics may be as much out of order; what goes back farther is a jump in time.
constexpr double kDisorder_s = 0.5;
constexpr std::size_t kColorsKept = 10;
/// How often it is looked whether something has waited long enough; wall time.
constexpr double kLook_s = 0.1;
constexpr char kRaw[] = "raw";

}  // namespace

SynchronizedInputs::SynchronizedInputs(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh,
                                       const InputSettings& settings, Callbacks callbacks)
    : nh_(nh),
      private_nh_(private_nh),
      settings_(settings),
      callbacks_(std::move(callbacks)),
      // A depth image is nothing without its camera.
      partners_(std::make_unique<CameraPartners>(CameraPartners::Settings{
          settings.approximate, !settings.depth, static_cast<std::size_t>(settings.queue_size)})),
      image_transport_(nh) {}

SynchronizedInputs::~SynchronizedInputs() { unsubscribe(); }

void SynchronizedInputs::subscribe() {
  if (subscribed_.exchange(true)) return;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    counted_ = {};
    first_time_ = camera_time_ = {};
    partners_->reset();
    colors_.clear();
  }
  const auto size = static_cast<std::uint32_t>(settings_.queue_size);
  timer_ = nh_.createWallTimer(ros::WallDuration(kLook_s), [this](const ros::WallTimerEvent&) { lookAgain(); });
  camera_ = nh_.subscribe(absolute(topics::kCameraInfo), size, &SynchronizedInputs::receiveCamera, this);
  if (!settings_.depth) {
    cloud_ = nh_.subscribe(absolute(topics::kPoints), size, &SynchronizedInputs::receiveCloud, this);
    return;
  }
  const auto open = [&](const char* topic, const char* parameter, auto receive) {
    const image_transport::TransportHints hints(kRaw, {}, private_nh_, parameter);
    return image_transport_.subscribe(imageTopic(topic, hints), size, receive, this, hints);
  };
  color_ = open(topics::kColor, "image_transport", &SynchronizedInputs::receiveColor);
  depth_ = open(topics::kDepth, "depth_image_transport", &SynchronizedInputs::receiveDepth);
}

void SynchronizedInputs::unsubscribe() {
  if (!subscribed_.exchange(false)) return;
  timer_.stop();
  cloud_.shutdown();
  depth_.shutdown();
  color_.shutdown();
  camera_.shutdown();
}

std::string SynchronizedInputs::absolute(const char* topic) const { return publicName(private_nh_, topic); }

/// Other transports than raw subscribe to TOPIC/TRANSPORT, which a remapping of TOPIC would not reach.
std::string SynchronizedInputs::imageTopic(const char* topic, const image_transport::TransportHints& hints) const {
  return hints.getTransport() == kRaw ? absolute(topic) : nh_.resolveName(absolute(topic));
}

InputState SynchronizedInputs::state() const {
  std::lock_guard<std::mutex> lock(mutex_);
  return describe();
}

InputState SynchronizedInputs::describe() const {
  InputState state = counted_;
  state.subscribed = subscribed_;
  state.approximate = settings_.approximate;
  state.with_last_camera = partners_->withLastCamera();
  state.first_topic = nh_.resolveName(absolute(settings_.depth ? topics::kDepth : topics::kPoints));
  state.camera_topic = nh_.resolveName(absolute(topics::kCameraInfo));
  state.first_publishers = settings_.depth ? depth_.getNumPublishers() : cloud_.getNumPublishers();
  state.camera_publishers = camera_.getNumPublishers();
  return state;
}

void SynchronizedInputs::hand(const InputMessages& messages) {
  ++counted_.frames;
  callbacks_.frame(messages);
}

/// Which topic this jump back in time shows on: the first of the two, or the one that follows. A stamp of 0 says
/// nothing about time.
SynchronizedInputs::Jump SynchronizedInputs::noticeJump(const ros::Time& stamp, TopicTime& topic,
                                                        const TopicTime& other) {
  if (stamp.isZero()) return Jump::kNone;
  const bool first_message = topic.newest.isZero();
  const bool back = !first_message && topic.newest.toSec() - stamp.toSec() > kDisorder_s;
  topic.newest = back ? stamp : std::max(topic.newest, stamp);
  if (back && topic.epoch >= other.epoch) {
    ++topic.epoch;
    return Jump::kFirst;
  }
  if (!back && !first_message) return Jump::kNone;
  topic.epoch = other.epoch;
  return back ? Jump::kFollowing : Jump::kNone;
}

void SynchronizedInputs::forgetTime() {
  partners_->forgetInputs();
  partners_->forgetStamps();
  colors_.clear();
  callbacks_.jump();
}

void SynchronizedInputs::noteFirst(const std_msgs::Header& header) {
  const Jump jump = noticeJump(header.stamp, first_time_, camera_time_);
  if (jump == Jump::kFirst) forgetTime();
  if (jump == Jump::kFollowing) partners_->forgetInputs();  // they came of the time before since the other one's jump
  ++counted_.first_seen;
  counted_.first_stamp = header.stamp;
  counted_.first_frame = header.frame_id;
}

template <class TakeIn>
void SynchronizedInputs::guarded(const TakeIn& take_in) {
  objectness_segmentation::guarded(
      [&] {
        std::lock_guard<std::mutex> lock(mutex_);
        take_in();
        warnOfLastCamera();
      },
      callbacks_.exception);
}

void SynchronizedInputs::receiveCloud(const sensor_msgs::PointCloud2ConstPtr& cloud) {
  guarded([&] {
    noteFirst(cloud->header);
    partners_->addInput(cloud->header, Clock::now(), [this, cloud](const auto& camera) {
      hand({cloud, camera, nullptr, nullptr});
    });
  });
}

void SynchronizedInputs::receiveDepth(const sensor_msgs::ImageConstPtr& depth) {
  guarded([&] {
    noteFirst(depth->header);
    partners_->addInput(depth->header, Clock::now(), [this, depth](const auto& camera) {
      hand({nullptr, camera, depth, nearestColor(depth->header.stamp)});
    });
  });
}

void SynchronizedInputs::receiveCamera(const sensor_msgs::CameraInfoConstPtr& camera) {
  guarded([&] {
    const Jump jump = noticeJump(camera->header.stamp, camera_time_, first_time_);
    if (jump == Jump::kFirst) forgetTime();
    if (jump == Jump::kFollowing) partners_->forgetStamps();
    ++counted_.camera_infos_seen;
    counted_.camera_stamp = camera->header.stamp;
    counted_.camera_frame = camera->header.frame_id;
    partners_->addCamera(camera, Clock::now());
  });
}

void SynchronizedInputs::receiveColor(const sensor_msgs::ImageConstPtr& color) {
  guarded([&] {
    ++counted_.colors_seen;
    colors_.push_back(color);
    if (colors_.size() > kColorsKept) colors_.pop_front();
  });
}

void SynchronizedInputs::lookAgain() {
  guarded([&] { partners_->lookAgain(Clock::now()); });
}

sensor_msgs::ImageConstPtr SynchronizedInputs::nearestColor(const ros::Time& stamp) const {
  NearestColor nearest(stamp);
  for (const auto& color : colors_) nearest.consider(color);
  return nearest.found();
}

void SynchronizedInputs::warnOfLastCamera() {
  if (warned_of_last_camera_ || partners_->partnersCome() || partners_->withLastCamera() == 0) return;
  warned_of_last_camera_ = true;
  callbacks_.warning(lastCameraUsed(describe()));
}

}  // namespace objectness_segmentation
