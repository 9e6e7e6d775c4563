// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "objectness_segmentation/common/status.hpp"

namespace objectness {

struct PcdLayout {
  std::uint32_t width = 0, height = 0;
  std::uint64_t data_offset = 0;  ///< where the header ends, bytes
};

/// Checks the header of a PCD file against itself and against the length of the file, and returns what it
/// announces. PCL allocates whatever the header claims, and prints on the console what it does not like.
Result<PcdLayout> checkPcdHeader(const std::string& path);

}  // namespace objectness
