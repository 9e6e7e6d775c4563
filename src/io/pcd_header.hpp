// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "objectness_segmentation/common/status.hpp"

namespace objectness {

struct PcdSize {
  std::uint32_t width = 0, height = 0;
};

/// Checks the header of a PCD file against itself and against the length of the file, and returns the size it
/// announces. PCL allocates whatever the header claims, and prints on the console what it does not like.
Result<PcdSize> checkPcdHeader(const std::string& path);

}  // namespace objectness
