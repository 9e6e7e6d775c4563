// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/former_parameters.hpp"

namespace objectness {
namespace {

constexpr char kGrouping[] = "grouping.enabled", kFollow[] = "segments.follow_superpixels";

}  // namespace

std::vector<ConfigField> FormerParameters::fields() {
  return {{"grouping", "enabled", &grouping_}, {"segments", "follow_superpixels", &follow_superpixels_}};
}

std::vector<std::string> FormerParameters::apply(const std::set<std::string>& given, Config& config) const {
  SegmentationMethod& method = config.pipeline.method;
  std::vector<std::string> warnings;
  if (given.count(kGrouping)) {
    if (grouping_) {
      method = SegmentationMethod::kObjectness;
    } else if (method == SegmentationMethod::kObjectness) {
      method = SegmentationMethod::kPaper;
    }
    warnings.push_back(std::string(kGrouping) +
                       " is replaced by pipeline.method: " + (grouping_ ? "objectness" : "paper"));
  }
  // Superpixels follow boxes only: this never turned the default method into another one.
  if (given.count(kFollow)) {
    if (method != SegmentationMethod::kObjectness) {
      method = follow_superpixels_ ? SegmentationMethod::kPaper : SegmentationMethod::kBoxes;
    }
    warnings.push_back(std::string(kFollow) +
                       " is replaced by pipeline.method: " + (follow_superpixels_ ? "paper" : "boxes"));
  }
  return warnings;
}

}  // namespace objectness
