// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace objectness {

/// While one of these lives PCL prints nothing; the last to go brings back the level that the first one found.
class QuietPcl {
 public:
  QuietPcl();
  ~QuietPcl();
  QuietPcl(const QuietPcl&) = delete;
  QuietPcl& operator=(const QuietPcl&) = delete;
};

}  // namespace objectness
