// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "objectness_segmentation/sequence.hpp"
#include "ros/bag_input.hpp"
#include "ros/bag_output.hpp"

namespace objectness_segmentation {

/// What became of one cloud or depth image.
struct BagFrame {
  std::size_t number = 0;  ///< from 1
  ros::Time stamp;
  objectness::Status status;
  std::size_t objects = 0;
  double milliseconds = 0;
};

struct SegmentBagSettings {
  bool approximate_sync = false;
  int fuse_frames = objectness::kFuseFrames;  ///< 1: every frame for itself
  objectness::Config config;
  std::optional<objectness::LearnedObjectness> model;  ///< none: the built-in one
  const std::atomic<bool>* cancel = nullptr;           ///< true: no further frame, the one at work is given up
};

struct SegmentBagReport {
  objectness::Status status;         ///< of the input; that of the output is its own
  std::size_t answered = 0;          ///< frames whose results are written
  std::size_t not_segmented = 0;     ///< of these, with a status that says why
  std::size_t with_last_camera = 0;  ///< with the last camera_info, as none has their stamp
  std::size_t without_camera = 0;    ///< without any camera_info
  /// What was unusual about the frames (objectness::Report::remarks) and how often, in the order of their coming; of
  /// more than kMaxRemarks different ones the first.
  std::vector<std::pair<std::string, std::size_t>> remarks;
  static constexpr std::size_t kMaxRemarks = 5;
};

/// The nodelet's messages, without tf, for every cloud or depth image of a bag, on /segment_objects/objects, segments
/// and markers. Their time is the input's stamp (the time of recording where that is 0), processing_time and
/// dropped_frames are 0: the same bag, configuration and seed give the same bytes.
SegmentBagReport segmentBag(const BagInput& input, const SegmentBagSettings& settings, BagOutput& output,
                            const std::function<void(const BagFrame&)>& on_frame);

}  // namespace objectness_segmentation
