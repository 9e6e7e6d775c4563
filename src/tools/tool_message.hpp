// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace objectness {

/// "TOOL: MESSAGE" as one line on standard error, whatever the message holds (file names may hold line breaks).
void printToolMessage(const std::string& tool, const std::string& message);

}  // namespace objectness
