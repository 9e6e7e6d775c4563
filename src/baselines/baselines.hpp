// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "baselines/baselines_config.hpp"
#include "objectness_segmentation/config.hpp"
#include "objectness_segmentation/result.hpp"
#include "objectness_segmentation/scene/frame.hpp"

namespace objectness {

/// Segmenters of PCL that the package's own method is measured against.
enum class Baseline {
  kMps,
  kLccp,
  kCpc,
  kEuclidean,  ///< PCL alone: RANSAC's plane, then Euclidean clusters
  kOrganized   ///< PCL alone: RANSAC's plane, then connected components of the image
};

/// "mps", "lccp", "cpc", "euclidean", "organized".
const char* toString(Baseline baseline);

/// Segments a frame by one of PCL's own segmenters. kMps, kLccp and kCpc get the points on the table and the normals
/// that segment() starts from, by the same functions and on as many threads (config.runtime.threads), so that methods
/// differ only in what comes after. kEuclidean and kOrganized are what is written with PCL alone: of the package they
/// have nothing, and of `config` nothing counts.
///
/// Segments come largest first; their box, objectness and cues are not set. The same frame and settings give the same
/// result. Never throws for bad data: the reason is in Segmentation::status, kBadConfig for settings out of range
/// among them. PCL's messages are kept off the console.
Segmentation segmentWithBaseline(Baseline baseline, const Frame& frame, const Config& config,
                                 const BaselinesConfig& settings = {});

/// The settings of a baseline in one line: "voxel_m 0.006, seed_m 0.025, ...".
std::string settingsText(Baseline baseline, const BaselinesConfig& settings);

}  // namespace objectness
