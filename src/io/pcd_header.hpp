// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "objectness_segmentation/common/status.hpp"

namespace objectness {

/// Checks the header of a PCD file against itself and against the length of the file. PCL allocates whatever the header
/// claims, and prints on the console what it does not like.
Status checkPcdHeader(const std::string& path);

}  // namespace objectness
