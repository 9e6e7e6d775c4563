// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "objectness_segmentation/scene/frame.hpp"

namespace objectness {

/// The name results of an input go by: the folder's name, or the file's without its extension; empty for a root folder.
std::string inputName(const std::string& path);

/// Reads a scene folder (loadSceneFolder()) or a .pcd file (loadPcd()). `camera` is the one that took a PCD file, or a
/// folder that has no camera.yaml of its own. Messages do not repeat `path`.
Result<Frame> loadInput(const std::string& path, const std::optional<ImageCamera>& camera, const InputConfig& config);

}  // namespace objectness
