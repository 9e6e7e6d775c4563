// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "objectness_segmentation/result.hpp"
#include "objectness_segmentation/scene/frame.hpp"

namespace objectness {

/// objects.json: the input, the status, the table with its frame, the objects, best objectness first, and the report.
/// All poses in the camera's optical frame, metres; quaternions x, y, z, w. `input` is the path the user gave.
std::string toJson(const std::string& input, const Segmentation& result);

/// Writes labels.png (16-bit: 0 nothing, 1 table, 2 and above result.segments), objects.json and, if asked for,
/// overlay.png into `folder`, which is made. Each file appears whole or not at all, objects.json as the last.
Status writeResult(const std::string& folder, const std::string& input, const Frame& frame, const Segmentation& result,
                   bool pictures);

/// Removes what writeResult() wrote before, so that an input that fails now is not taken for one that worked.
void removeResult(const std::string& folder);

}  // namespace objectness
