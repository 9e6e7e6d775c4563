// SPDX-License-Identifier: BSD-3-Clause
#include "io/yaml_text.hpp"

#include <boost/algorithm/string/replace.hpp>

namespace objectness {

YAML::Node parseYaml(const std::string& text) {
  // Inside brackets, yaml-cpp 0.6 (Debian 11, Ubuntu 20.04) never gets past a colon before ']' or the end of the text,
  // and takes memory all the while (its issue 793). White space after it changes nothing but quoted text, which no file
  // of ours goes by.
  return YAML::Load(boost::replace_all_copy(text, ":]", ": ]") + '\n');
}

}  // namespace objectness
