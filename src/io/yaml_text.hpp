// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

namespace objectness {

/// YAML::Load for texts that anybody may have written. Throws YAML::Exception.
YAML::Node parseYaml(const std::string& text);

}  // namespace objectness
