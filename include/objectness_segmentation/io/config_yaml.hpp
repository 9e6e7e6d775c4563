// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "objectness_segmentation/common/status.hpp"
#include "objectness_segmentation/config.hpp"

namespace objectness {

/// Lays a preset over `config`:
///     search:
///       angle_step_deg: 10
/// Fields the file does not name keep their values. On kBadConfig (unknown name, wrong type, value out of range, fields
/// that contradict each other) or kBadInput (no such file, no YAML) `config` is left as it was, and the message lists
/// every problem.
Status loadConfig(const std::string& path, Config& config);

/// Lays assignments "group.field=value" over `config`, all or none of them; errors as loadConfig().
Status setParameters(const std::vector<std::string>& assignments, Config& config);

/// Every field as a preset that loadConfig() reads back to the same values.
std::string toYaml(const Config& config);

/// A line per field: name, type (double, int or bool), default, least, largest and description, separated by tabs.
std::string listParameters();

}  // namespace objectness
