// SPDX-License-Identifier: BSD-3-Clause
#include "ros/segment_service.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

#include "objectness_segmentation/common/status.hpp"
#include "objectness_segmentation/ros/topics.hpp"

namespace objectness_segmentation {
namespace {

constexpr double kMaxTimeout_s = 3600;
/// Frames may have been under way for so long when a request comes.
constexpr double kOldFrame_s = 1.0;
constexpr double kSlice_s = 0.05;  // how soon a shutdown of the whole process is noticed

using objectness::StatusCode;

/// Why no frame of those that came was an answer.
std::string describe(const SegmentService::Requests::OldFrames& frames) {
  char text[320];
  std::snprintf(
      text, sizeof(text),
      "%u frame(s) came, but stamps are %.1f s behind this clock, before the request: set both machines to the "
      "same time (NTP, chrony; or the driver to the host's clock), or where frames do take so long to arrive "
      "give a timeout that is longer",
      static_cast<unsigned>(frames.count), frames.age_s);
  return text;
}

}  // namespace

SegmentService::SegmentService(ros::NodeHandle& nh, Requests& requests, double default_timeout_s,
                               std::function<void()> changed, std::function<std::string()> missing)
    : requests_(requests),
      default_timeout_s_(default_timeout_s),
      changed_(std::move(changed)),
      missing_(std::move(missing)),
      spinner_(1, &queue_) {
  auto options = ros::AdvertiseServiceOptions::create<SegmentOnce>(
      topics::kSegmentOnce, [this](auto& request, auto& response) { return answer(request, response); },
      ros::VoidConstPtr(), &queue_);
  server_ = nh.advertiseService(options);
  spinner_.start();
}

void SegmentService::stop() {
  requests_.stop();
  server_.shutdown();
  spinner_.stop();
}

bool SegmentService::answer(SegmentOnce::Request& request, SegmentOnce::Response& response) {
  using Clock = std::chrono::steady_clock;
  const bool given = std::isfinite(request.timeout) && request.timeout > 0;
  const double timeout_s = given ? std::min<double>(request.timeout, kMaxTimeout_s) : default_timeout_s_;
  const auto deadline =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(timeout_s));
  std::optional<SegmentedObjectArrayConstPtr> result;
  Requests::OldFrames old_frames;
  {
    const double now_s = ros::Time::now().toSec();
    Requests::Request waiting(requests_, now_s);
    changed_();
    while (!result && !requests_.stopped() && !ros::isShuttingDown() && Clock::now() < deadline) {
      result = waiting.wait(std::min(kSlice_s, std::chrono::duration<double>(deadline - Clock::now()).count()));
    }
    old_frames = waiting.oldFrames();
  }
  if (result && *result) {
    response.result = **result;
  } else if (requests_.stopped() || ros::isShuttingDown()) {
    response.result.status = static_cast<std::uint8_t>(StatusCode::kCancelled);
    response.result.message = "the nodelet ends";
    return true;  // inputs may be gone already
  } else {
    char text[96];
    std::snprintf(text, sizeof(text), "no result for a frame newer than the request within %.2f s: ", timeout_s);
    response.result.status = static_cast<std::uint8_t>(StatusCode::kNoInput);
    response.result.message = text + (old_frames.age_s >= kOldFrame_s ? describe(old_frames) : missing_());
  }
  changed_();
  return true;
}

}  // namespace objectness_segmentation
