// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/former_parameters.hpp"

#include "method_names.hpp"

namespace objectness {
namespace {

constexpr char kGrouping[] = "grouping.enabled", kFollow[] = "segments.follow_superpixels";

}  // namespace

std::vector<ConfigField> FormerParameters::fields() {
  return {{"grouping", "enabled", &grouping_}, {"segments", "follow_superpixels", &follow_superpixels_}};
}

std::vector<std::string> FormerParameters::apply(const std::set<std::string>& given, Config& config) const {
  SegmentationMethod& method = config.pipeline.method;
  const bool replaced = given.count("pipeline.method") > 0;
  std::vector<std::string> warnings;
  const auto warn = [&](const char* name, SegmentationMethod meant) {
    warnings.push_back(std::string(name) + " is replaced by pipeline.method: " + toString(meant) +
                       (replaced ? ", and has no effect beside it" : ""));
  };
  if (given.count(kGrouping)) {
    warn(kGrouping, grouping_ ? SegmentationMethod::kObjectness : SegmentationMethod::kPaper);
    if (!replaced && grouping_) {
      method = SegmentationMethod::kObjectness;
    } else if (!replaced && method == SegmentationMethod::kObjectness) {
      method = SegmentationMethod::kPaper;
    }
  }
  if (given.count(kFollow)) {
    const SegmentationMethod meant = follow_superpixels_ ? SegmentationMethod::kPaper : SegmentationMethod::kBoxes;
    warn(kFollow, meant);
    // Superpixels follow boxes only: this never turned the default method into another one.
    if (!replaced && method != SegmentationMethod::kObjectness) method = meant;
  }
  return warnings;
}

}  // namespace objectness
