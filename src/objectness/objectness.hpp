// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "integral/cue_volumes.hpp"
#include "objectness_segmentation/objectness/box.hpp"
#include "objectness_segmentation/objectness/objectness_config.hpp"

namespace objectness {

/// Eq. 6: delta = w_i delta_i + w_o delta_o delta_l + w_f delta_f (+ constant).
double objectness(const CueValues& cues, const ObjectnessConfig& config);

/// How far b_eps of Eq. 2 reaches beyond b, in voxels.
struct Ring {
  int xy = 0, z = 0;
};
Ring ringOf(const ObjectnessConfig& config, double voxel_m);

/// The box with its cues and objectness, or nothing when a gate rejects it. The definition that every search must agree
/// with to the last bit.
std::optional<ScoredBox> scoreBox(const CueVolumes& volumes, const Box& box, const Ring& ring,
                                  const ObjectnessConfig& config);

}  // namespace objectness
