// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace objectness {

/// " (did you mean NAME?)" for the candidate nearest to a misspelt name, empty when none is near. A candidate whose
/// part after the last dot is the name itself is near: its group was forgotten.
std::string didYouMean(const std::string& name, const std::vector<std::string>& candidates);

}  // namespace objectness
