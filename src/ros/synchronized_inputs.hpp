// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <image_transport/image_transport.h>
#include <ros/node_handle.h>
#include <sensor_msgs/PointCloud2.h>

#include <atomic>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "objectness_segmentation/ros/segment_messages.hpp"
#include "ros/input_state.hpp"

namespace objectness_segmentation {

class CameraPartners;

struct InputSettings {
  bool depth = false;  ///< depth images (and rgb, when there is any), not clouds
  bool approximate = false;
  int queue_size = 5;
};

/// Subscribes to what a depth camera publishes and hands on what belongs together: cloud or depth image, with the
/// camera_info of the same stamp (or, when approximate, the nearest one), and where such ones do not come with the last
/// one of the same frame_id. Clouds go on alone when no camera_info at all has come for a while after the first cloud.
/// The picture that is nearest in time to a depth image goes with it when there is one. A stamp that goes back, as when
/// a bag begins again, makes everything that waits for its partner void.
class SynchronizedInputs {
 public:
  struct Callbacks {
    std::function<void(const InputMessages&)> frame;
    std::function<void()> jump;  ///< time went back; before anything of the new time is handed on
    std::function<void(const std::string& sentence)> warning;  ///< about the inputs; each once
    std::function<void(const std::string& what)> exception;    ///< what a message brought about: it is lost, no more
  };

  /// Subscribes to nothing yet. Topics are those of the namespace that private_nh lies in, remapped as nh says.
  /// Callbacks come through nh's queue, none after unsubscribe() has returned there.
  SynchronizedInputs(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh, const InputSettings& settings,
                     Callbacks callbacks);
  ~SynchronizedInputs();

  void subscribe();
  void unsubscribe();
  bool subscribed() const { return subscribed_; }

  /// What came in since the last subscribe().
  InputState state() const;

 private:
  void receiveCloud(const sensor_msgs::PointCloud2ConstPtr& cloud);
  void receiveDepth(const sensor_msgs::ImageConstPtr& depth);
  void receiveCamera(const sensor_msgs::CameraInfoConstPtr& camera);
  void receiveColor(const sensor_msgs::ImageConstPtr& color);
  void lookAgain();
  template <class TakeIn>
  void guarded(const TakeIn& take_in);
  void hand(const InputMessages& messages);
  void noteFirst(const std_msgs::Header& header);
  void warnOfLastCamera();
  InputState describe() const;
  struct TopicTime {
    ros::Time newest;
    int epoch = 0;  ///< jumps back in time that it has gone through
  };
  enum class Jump { kNone, kFirst, kFollowing };
  static Jump noticeJump(const ros::Time& stamp, TopicTime& topic, const TopicTime& other);
  void forgetTime();
  sensor_msgs::ImageConstPtr nearestColor(const ros::Time& stamp) const;
  std::string absolute(const char* topic) const;
  std::string imageTopic(const char* topic, const image_transport::TransportHints& hints) const;

  ros::NodeHandle nh_, private_nh_;
  InputSettings settings_;
  Callbacks callbacks_;

  mutable std::mutex mutex_;  // held while a message is taken in, and for what follows
  std::unique_ptr<CameraPartners> partners_;
  std::deque<sensor_msgs::ImageConstPtr> colors_;
  InputState counted_;
  // A jump shows on one topic first; messages of the time before may still come on the other one.
  TopicTime first_time_, camera_time_;
  bool warned_of_last_camera_ = false;

  std::atomic<bool> subscribed_{false};
  image_transport::ImageTransport image_transport_;
  image_transport::Subscriber depth_, color_;
  ros::Subscriber cloud_, camera_;
  ros::WallTimer timer_;
};

}  // namespace objectness_segmentation
