// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "objectness_segmentation/config_fields.hpp"

namespace objectness {

/// Parameters of earlier versions that pipeline.method has replaced. Presets, `--set` and rosparam still take them,
/// with a warning, until version 2.
class FormerParameters {
 public:
  /// As configFields(); they point into this object.
  std::vector<ConfigField> fields();

  /// Lays those that were given (full names, of other parameters too) over `config`. Where pipeline.method is given,
  /// too, they have no effect: a parameter server may still hold what an earlier version wrote there. Returns a warning
  /// for each, which names what to write instead.
  std::vector<std::string> apply(const std::set<std::string>& given, Config& config) const;

 private:
  bool grouping_ = true, follow_superpixels_ = true;
};

}  // namespace objectness
