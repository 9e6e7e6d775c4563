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
/// every problem. warnings: gets a sentence for each name of an earlier version (FormerParameters); nullptr: they are
/// taken in silence.
Status loadConfig(const std::string& path, Config& config, std::vector<std::string>* warnings = nullptr);

/// Lays assignments "group.field=value" over `config`, all or none of them; errors as loadConfig().
Status setParameters(const std::vector<std::string>& assignments, Config& config,
                     std::vector<std::string>* warnings = nullptr);

/// Every field as a preset that loadConfig() reads back to the same values.
std::string toYaml(const Config& config);

/// A line per field: name, type (double, int, bool or string), default, least, largest and description, separated by
/// tabs. Of a string, what it may be stands in the place of the least ("objectness|paper|boxes").
std::string listParameters();

}  // namespace objectness
