// SPDX-License-Identifier: BSD-3-Clause
#include "method_names.hpp"

#include <algorithm>

namespace objectness {

std::string toString(SegmentationMethod method) { return kMethodNames.at(static_cast<std::size_t>(method)); }

std::optional<SegmentationMethod> methodNamed(const std::string& name) {
  const auto found = std::find(kMethodNames.begin(), kMethodNames.end(), name);
  if (found == kMethodNames.end()) return {};
  return static_cast<SegmentationMethod>(found - kMethodNames.begin());
}

std::string joinedMethodNames(const std::string& separator, const std::string& last) {
  std::string text;
  for (std::size_t k = 0; k < kMethodNames.size(); ++k) {
    text += (k == 0 ? "" : k + 1 == kMethodNames.size() ? last : separator) + kMethodNames[k];
  }
  return text;
}

}  // namespace objectness
