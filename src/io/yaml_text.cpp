// SPDX-License-Identifier: BSD-3-Clause
#include "yaml_text.hpp"

namespace objectness {

YAML::Node parseYaml(const std::string& text) {
  // In a list, yaml-cpp 0.6 (Debian 11, Ubuntu 20.04) never gets past a colon before ']' or the end of the text, and
  // takes memory all the while (its issue 793). Before white space a colon is what it would have been anyway.
  std::string ended;
  for (std::size_t i = 0; i < text.size(); ++i) {
    ended += text[i];
    if (text[i] == ':' && i + 1 < text.size() && text[i + 1] == ']') ended += ' ';
  }
  return YAML::Load(ended + '\n');
}

}  // namespace objectness
