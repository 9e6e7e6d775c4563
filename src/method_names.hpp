// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "objectness_segmentation/method.hpp"

namespace objectness {

/// Of kMethodNames. std::out_of_range: the value is none of the enumerators.
std::string toString(SegmentationMethod method);

/// Nothing for what is no name of a method.
std::optional<SegmentationMethod> methodNamed(const std::string& name);

/// All names, the last one after `last`: "objectness, paper or boxes" with ", " and " or ".
std::string joinedMethodNames(const std::string& separator, const std::string& last);

}  // namespace objectness
