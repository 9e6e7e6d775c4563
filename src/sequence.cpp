// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/sequence.hpp"

#include <chrono>
#include <utility>

#include "remembering_segment.hpp"
#include "tracking/steady_boxes.hpp"

namespace objectness {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

}  // namespace

struct FrameSequence::Memory {
  explicit Memory(int fuse_frames) : fusion(fuse_frames) {}

  DepthFusion fusion;
  Tracker tracker;
  SteadyBoxes boxes;
  cv::Mat_<ushort> last_labels;
  double last_time_s = 0;

  void clear() {
    fusion.clear();
    tracker.clear();
    boxes.clear();
    last_labels.release();
  }

  /// Of what has not changed since the last frame; none where nothing is known.
  std::optional<GroupingMemory> grouping() const {
    const cv::Mat_<uchar>& counts = fusion.counts();
    if (last_labels.empty() || counts.size() != last_labels.size()) return {};
    GroupingMemory memory{last_labels.clone()};
    memory.labels.setTo(GroupingMemory::kUnknown, counts < 2);
    return memory;
  }
};

FrameSequence::FrameSequence(int fuse_frames) : memory_(std::make_unique<Memory>(fuse_frames)) {}
FrameSequence::~FrameSequence() = default;
FrameSequence::FrameSequence(FrameSequence&&) noexcept = default;
FrameSequence& FrameSequence::operator=(FrameSequence&&) noexcept = default;

std::size_t FrameSequence::memoryBytes() const { return memory_->fusion.memoryBytes(); }

SequenceResult FrameSequence::next(Frame frame, const std::optional<Eigen::Isometry3d>& T_fixed_camera, double time_s,
                                   const Config& config, const LearnedObjectness* model,
                                   const std::atomic<bool>* cancel) {
  if (time_s < memory_->last_time_s - kTimeJump_s) memory_->clear();
  memory_->last_time_s = time_s;

  SequenceResult result;
  result.frame = std::move(frame);
  const Clock::time_point start = Clock::now();
  result.fused = memory_->fusion.fuse(T_fixed_camera, config.runtime.threads, result.frame);
  result.fusion_ms = millisecondsSince(start);

  const std::optional<GroupingMemory> memory = memory_->grouping();
  result.segmentation = segmentRemembering(result.frame, config, model, memory ? &*memory : nullptr, cancel);
  memory_->last_labels = result.segmentation.status.ok() ? result.segmentation.labels : cv::Mat_<ushort>();
  if (!config.tracking.enabled) {
    memory_->tracker.clear();
    memory_->boxes.clear();
  } else if (result.segmentation.status.ok()) {
    const Clock::time_point segmented = Clock::now();
    const Eigen::Isometry3d pose = T_fixed_camera.value_or(Eigen::Isometry3d::Identity());
    std::vector<Segment>& segments = result.segmentation.segments;
    result.identities = memory_->tracker.update(result.frame, segments, pose, time_s, config.tracking);
    memory_->boxes.settle(result.frame, result.identities, pose, config.tracking.settle_frames, segments);
    result.tracking_ms = millisecondsSince(segmented);
  }
  return result;
}

}  // namespace objectness
