// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace objectness_segmentation {

/// Old drivers send the leading slash of tf, which tf2 does not know.
inline std::string withoutSlash(const std::string& frame) {
  return frame.empty() || frame[0] != '/' ? frame : frame.substr(1);
}

/// Whether something in one frame may be taken for something in the other. An empty frame_id says nothing.
inline bool mayBeSameFrame(const std::string& a, const std::string& b) {
  return a.empty() || b.empty() || withoutSlash(a) == withoutSlash(b);
}

}  // namespace objectness_segmentation
