// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "ros/segment_bag.hpp"

namespace objectness_segmentation {

/// What the command line of `segment_bag` asks for.
struct SegmentBagOptions {
  InputTopics topics;
  SegmentBagSettings settings;
  std::string in, out;
  std::string print;  ///< text to print instead (--help)
};

/// An error is one that a look at `segment_bag --help` helps with.
objectness::Result<SegmentBagOptions> parseSegmentBagOptions(int argc, const char* const* argv);

}  // namespace objectness_segmentation
