// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>
#include <sensor_msgs/CameraInfo.h>
#include <std_msgs/Header.h>

#include <chrono>
#include <deque>
#include <functional>
#include <map>
#include <string>

namespace objectness_segmentation {

/// Finds the camera_info of every input, which is a cloud or a depth image.
///
/// Its partner is the camera_info of the same stamp or, when approximate, the one of the nearest stamp. An input waits
/// for it; when a later one has found its own, the earlier ones are given up.
///
/// But a camera is a constant: an input whose partner does not come goes on with the last camera_info of its frame_id
/// (when approximate: with the one of the nearest stamp, whatever its frame_id). Where this happens again and again, as
/// with camera_infos that are latched, slow or without a stamp, inputs do not wait any more. Where partners come again
/// for every one, they do.
///
/// No node and no clock in it: times of arrival are the caller's. Not thread safe.
class CameraPartners {
 public:
  using Clock = std::chrono::steady_clock;
  using CameraInfoPtr = sensor_msgs::CameraInfoConstPtr;
  /// Takes an input on its way, with its camera_info or (null) alone.
  using Hand = std::function<void(const CameraInfoPtr&)>;

  struct Settings {
    bool approximate = false;
    bool alone = false;          ///< inputs without any camera_info go on alone
    std::size_t queue_size = 5;  ///< inputs that wait
  };

  explicit CameraPartners(const Settings& settings) : settings_(settings) {}

  // Each may call hands, oldest input first, and in the end throws what they throw.
  void addInput(const std_msgs::Header& header, Clock::time_point now, Hand hand);
  void addCamera(const CameraInfoPtr& camera, Clock::time_point now);
  /// For what waits while nothing comes: to be called now and then.
  void lookAgain(Clock::time_point now);

  /// Of a time that is over. The last camera_info of each frame_id stays.
  void forgetInputs() { inputs_.clear(); }
  void forgetStamps() { cameras_.clear(); }
  /// Forgets all messages, but not whether partners come.
  void reset();

  /// Whether partners come with most inputs, as far as is known.
  bool partnersCome() const { return partners_come_; }
  /// Inputs that went on with a camera_info that is not their partner, since reset().
  std::size_t withLastCamera() const { return with_last_camera_; }

 private:
  struct Input {
    std_msgs::Header header;
    Clock::time_point arrival;
    Hand hand;                ///< empty: on its way, or overtaken
    bool after_first_camera;  ///< it could have had a partner
  };

  CameraInfoPtr partnerOf(const std_msgs::Header& header) const;
  bool comparesStamps(const ros::Time& stamp) const;
  CameraInfoPtr nearest(const ros::Time& stamp) const;
  CameraInfoPtr lastOf(const std::string& frame_id) const;
  bool mayGoAlone(Clock::time_point now) const;
  std::size_t tooMany() const;
  std::size_t overdueInputs(Clock::time_point now) const;
  void handWithPartner(std::size_t index, const CameraInfoPtr& partner);
  void handWithoutPartner(std::size_t index, Clock::time_point now);
  void noteOutcome(const Input& input, bool partner_came);

  Settings settings_;
  std::deque<Input> inputs_;           // in the order of arrival; handed ones while their partner may still come
  std::deque<CameraInfoPtr> cameras_;  // the newest, in the order of arrival
  std::map<std::string, CameraInfoPtr> last_of_frame_;
  CameraInfoPtr last_;  // of any frame
  bool any_input_ = false;
  Clock::time_point first_arrival_;
  std::size_t with_last_camera_ = 0;
  std::deque<bool> outcomes_;  // of the last inputs: did the partner come?
  bool partners_come_ = true;
};

}  // namespace objectness_segmentation
