// SPDX-License-Identifier: BSD-3-Clause
#include "tools/tool_message.hpp"

#include <algorithm>
#include <iostream>

namespace objectness {

void printToolMessage(const std::string& tool, const std::string& message) {
  std::string line = tool + ": " + message;
  std::replace_if(
      line.begin(), line.end(), [](unsigned char c) { return c < ' '; }, ' ');
  std::cerr << line << std::endl;
}

}  // namespace objectness
