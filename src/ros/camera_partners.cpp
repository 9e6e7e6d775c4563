// SPDX-License-Identifier: BSD-3-Clause
#include "ros/camera_partners.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ros/frame_names.hpp"

namespace objectness_segmentation {
namespace {

using std::chrono::milliseconds;

/// An input waits this long for its partner. The one of the nearest stamp is known only when a later one comes.
constexpr milliseconds kExactPatience{500}, kNearestPatience{2000};
/// Inputs wait this long, from the first of them, for any camera_info at all.
constexpr milliseconds kCameraPatience{2000};
/// Some clouds take long to compute, and come long after their camera_info.
constexpr std::size_t kCamerasKept = 200;
constexpr std::size_t kFramesKept = 50;
/// Partners do not come when so many of the last inputs had none; they come again when all of these had one.
constexpr std::size_t kOutcomes = 10;
constexpr std::ptrdiff_t kMissing = 3;

/// ros::Duration throws where the difference is too long for it, and any stamp may come.
double secondsBetween(const ros::Time& from, const ros::Time& to) { return to.toSec() - from.toSec(); }

}  // namespace

void CameraPartners::addInput(const std_msgs::Header& header, Clock::time_point now, Hand hand) {
  if (!any_input_) first_arrival_ = now;
  any_input_ = true;
  inputs_.push_back({header, now, std::move(hand), last_ != nullptr});
  if (const CameraInfoPtr partner = partnerOf(header)) {
    handWithPartner(inputs_.size() - 1, partner);
  } else {
    lookAgain(now);
  }
}

void CameraPartners::addCamera(const CameraInfoPtr& camera, Clock::time_point now) {
  cameras_.push_back(camera);
  if (cameras_.size() > kCamerasKept) cameras_.pop_front();
  if (last_of_frame_.size() >= kFramesKept) last_of_frame_.clear();
  last_of_frame_[withoutSlash(camera->header.frame_id)] = last_ = camera;
  for (std::size_t i = 0; i < inputs_.size();) {
    const CameraInfoPtr partner = partnerOf(inputs_[i].header);
    if (partner) {
      handWithPartner(i, partner);
      i = 0;
    } else {
      ++i;
    }
  }
  lookAgain(now);
}

void CameraPartners::lookAgain(Clock::time_point now) {
  const std::size_t overdue = overdueInputs(now);
  const bool at_once = !partners_come_ || (!last_ && mayGoAlone(now));
  const std::size_t due = at_once ? inputs_.size() : overdue;
  if (due > 0 && inputs_[due - 1].hand) handWithoutPartner(due - 1, now);
  // What nothing could be done for waits on, as long as there is room.
  for (std::size_t i = 0; i < overdue && (tooMany() > 0 || !inputs_.front().hand); ++i) {
    noteOutcome(inputs_.front(), false);
    inputs_.pop_front();
  }
}

void CameraPartners::reset() {
  inputs_.clear();
  cameras_.clear();
  last_of_frame_.clear();
  last_ = nullptr;
  any_input_ = false;
  with_last_camera_ = 0;
}

CameraPartners::CameraInfoPtr CameraPartners::partnerOf(const std_msgs::Header& header) const {
  bool later = false;
  for (auto camera = cameras_.rbegin(); camera != cameras_.rend(); ++camera) {
    if ((*camera)->header.stamp == header.stamp) return *camera;
    later = later || (*camera)->header.stamp > header.stamp;
  }
  return later && comparesStamps(header.stamp) ? nearest(header.stamp) : nullptr;
}

/// A stamp of 0 is near to none.
bool CameraPartners::comparesStamps(const ros::Time& stamp) const { return settings_.approximate && !stamp.isZero(); }

/// The earlier one of two that are equally near, the newest one of several with the same stamp.
CameraPartners::CameraInfoPtr CameraPartners::nearest(const ros::Time& stamp) const {
  CameraInfoPtr found;
  double least = 0;
  for (auto camera = cameras_.rbegin(); camera != cameras_.rend(); ++camera) {
    const ros::Time& other = (*camera)->header.stamp;
    const double distance = std::abs(secondsBetween(stamp, other));
    if (!found || distance < least || (distance == least && other < found->header.stamp)) {
      found = *camera;
      least = distance;
    }
  }
  return found;
}

CameraPartners::CameraInfoPtr CameraPartners::lastOf(const std::string& frame_id) const {
  if (!last_ || mayBeSameFrame(frame_id, last_->header.frame_id)) return last_;
  for (const std::string& frame : {withoutSlash(frame_id), std::string()}) {
    const auto found = last_of_frame_.find(frame);
    if (found != last_of_frame_.end()) return found->second;
  }
  return nullptr;
}

bool CameraPartners::mayGoAlone(Clock::time_point now) const {
  return settings_.alone && (last_ || now - first_arrival_ >= kCameraPatience);
}

std::size_t CameraPartners::tooMany() const { return inputs_.size() - std::min(inputs_.size(), settings_.queue_size); }

/// How many of the oldest inputs have waited long enough, or have no more room.
std::size_t CameraPartners::overdueInputs(Clock::time_point now) const {
  const auto patience = settings_.approximate ? kNearestPatience : kExactPatience;
  std::size_t count = tooMany();
  while (count < inputs_.size() && now - inputs_[count].arrival >= patience) ++count;
  return count;
}

void CameraPartners::handWithPartner(std::size_t index, const CameraInfoPtr& partner) {
  const Hand hand = std::move(inputs_[index].hand);
  for (std::size_t i = 0; i < index; ++i) noteOutcome(inputs_[i], false);
  noteOutcome(inputs_[index], true);
  inputs_.erase(inputs_.begin(), inputs_.begin() + static_cast<std::ptrdiff_t>(index) + 1);
  if (hand) hand(partner);
}

void CameraPartners::handWithoutPartner(std::size_t index, Clock::time_point now) {
  const std_msgs::Header& header = inputs_[index].header;
  CameraInfoPtr camera = comparesStamps(header.stamp) ? nearest(header.stamp) : nullptr;
  if (!camera) camera = settings_.approximate ? last_ : lastOf(header.frame_id);
  if (!camera && !mayGoAlone(now)) return;
  if (camera) ++with_last_camera_;
  const Hand hand = std::move(inputs_[index].hand);
  for (std::size_t i = 0; i <= index; ++i) inputs_[i].hand = nullptr;
  hand(camera);
}

void CameraPartners::noteOutcome(const Input& input, bool partner_came) {
  if (!input.after_first_camera) return;
  outcomes_.push_back(partner_came);
  if (outcomes_.size() > kOutcomes) outcomes_.pop_front();
  const auto missing = std::count(outcomes_.begin(), outcomes_.end(), false);
  if (missing >= kMissing) partners_come_ = false;
  if (missing == 0 && outcomes_.size() == kOutcomes) partners_come_ = true;
}

}  // namespace objectness_segmentation
