// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "integral/cue_voxels.hpp"

namespace objectness {

/// Marks the voxels of one angle one by one: the definition that Voxelizer must agree with.
CueVoxels markVoxelsPlain(const Frame& frame, const Table& table, const CuePoints& points, const Grid& grid,
                          const VolumeConfig& config);

}  // namespace objectness
