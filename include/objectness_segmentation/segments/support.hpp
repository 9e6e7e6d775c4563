// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace objectness {

enum class SupportKind {
  kTable,
  kSegment,  ///< another segment
  kOther,    ///< a thing on the table that is in no segment
};

/// What an object stands on.
struct Support {
  SupportKind kind = SupportKind::kTable;
  int segment = -1;     ///< index of the other segment, -1 when it is none
  double height_m = 0;  ///< of the surface that carries the object, over the table
};

}  // namespace objectness
