// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "objectness_segmentation/objectness/box.hpp"
#include "segments/seen_thing.hpp"

namespace objectness {

/// The box of a book or board that leans: most of what is seen of it is one flat face that is neither upright nor
/// level, and it is thin behind that face. One axis of the box is level, one is the face's normal. The box is in the
/// table frame (T_camera_box maps from it to the table frame) and holds what is seen; its axes are in no order yet.
std::optional<OrientedBox> fitLeaningSlab(const SeenThing& thing);

}  // namespace objectness
