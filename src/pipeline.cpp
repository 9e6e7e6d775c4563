// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/pipeline.hpp"

#include "box_method.hpp"
#include "doubtful_scale.hpp"
#include "finished_segments.hpp"
#include "front_end.hpp"
#include "grouping_method.hpp"
#include "guarded_segmentation.hpp"
#include "needed_resolution.hpp"
#include "remembering_segment.hpp"

namespace objectness {
namespace {

void remarkOnScale(const Frame& frame, Segmentation& result) {
  const std::string remark = doubtfulScale(frame, result);
  if (!remark.empty()) result.report.remarks.push_back(remark);
}

/// Fills `result` as far as it gets.
void run(const Frame& frame, const Config& config, const LearnedObjectness* model, const GroupingMemory* memory,
         const std::atomic<bool>* cancel, Segmentation& result) {
  const Stages stage(cancel, result.report);
  observeScene(frame, config, stage, result);
  if (!result.status.ok()) {
    remarkOnScale(frame, result);
    return;
  }
  if (config.pipeline.method == SegmentationMethod::kObjectness) {
    groupPieces(frame, config, model, memory, stage, result);
  } else {
    searchBoxes(frame, config, stage, result);
  }
  if (!result.status.ok()) return;
  finishSegments(frame, config, stage, result);
  remarkOnScale(frame, result);
}

}  // namespace

Segmentation segmentRemembering(const Frame& frame, const Config& config, const LearnedObjectness* model,
                                const GroupingMemory* memory, const std::atomic<bool>* cancel) {
  return guardedSegmentation(frame, [&](Segmentation& result) {
    const std::vector<std::string> problems = validate(config);
    if (!problems.empty()) {
      result.status = Status::error(StatusCode::kBadConfig, problems.front());
      return;
    }
    try {
      atNeededResolution(frame, config, result,
                         [&](const Frame& seen) { run(seen, config, model, memory, cancel, result); });
    } catch (const Cancelled&) {
      result.status = Status::error(StatusCode::kCancelled, "cancelled between stages");
    }
  });
}

Segmentation segment(const Frame& frame, const Config& config, const std::atomic<bool>* cancel) {
  return segmentRemembering(frame, config, nullptr, nullptr, cancel);
}

Segmentation segment(const Frame& frame, const Config& config, const LearnedObjectness& model,
                     const std::atomic<bool>* cancel) {
  return segmentRemembering(frame, config, &model, nullptr, cancel);
}

}  // namespace objectness
