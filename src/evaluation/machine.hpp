// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace objectness::evaluation {

/// Processor, memory, system and the versions of the libraries that matter.
std::string describeMachine();

}  // namespace objectness::evaluation
