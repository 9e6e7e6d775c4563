// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "objectness_segmentation/common/status.hpp"
#include "objectness_segmentation/config.hpp"
#include "objectness_segmentation/learning/learned_objectness.hpp"
#include "objectness_segmentation/scene/image_camera.hpp"

namespace objectness {

/// What the command line of `segment` asks for.
struct SegmentOptions {
  Config config;
  std::optional<LearnedObjectness> model;  ///< none: the built-in one
  std::optional<ImageCamera> camera;
  std::string out;
  bool pictures = false;
  std::vector<std::string> inputs;
  std::string print;  ///< text to print instead of segmenting anything (--help and the like)
};

/// An error is one that a look at `segment --help` helps with.
Result<SegmentOptions> parseSegmentOptions(int argc, const char* const* argv);

}  // namespace objectness
