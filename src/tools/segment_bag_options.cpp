// SPDX-License-Identifier: BSD-3-Clause
#include "tools/segment_bag_options.hpp"

#include <boost/program_options.hpp>
#include <filesystem>
#include <sstream>

#include "tools/command_line.hpp"
#include "tools/config_options.hpp"

namespace objectness_segmentation {
namespace {

namespace po = boost::program_options;
using Options = objectness::Result<SegmentBagOptions>;

constexpr const char* kIntroduction =
    "Segments every cloud or depth image of a recorded bag: what the node /segment_objects would publish if it had\n"
    "all the time it needs.\n"
    "\n"
    "  segment_bag [OPTION...] --out OUT.bag IN.bag\n"
    "\n"
    "OUT.bag holds /segment_objects/objects, /segment_objects/segments and /segment_objects/markers for every one,\n"
    "at the time of its stamp; play it together with IN.bag. No roscore is needed.\n"
    "\n"
    "Without --points and --depth the organized clouds with the most messages are taken; where there are none, depth\n"
    "images; where there are none either, clouds that are not organized. These two need a camera_info; organized\n"
    "clouds without one are segmented, too. One whose stamp no camera_info has gets the last one of its frame_id.\n"
    "\n";

constexpr const char* kEnd =
    "\n"
    "The same bag, parameters and seed give the same file, with any number of threads: processing_time and\n"
    "dropped_frames are 0 in it.\n"
    "Exit status: 0 every frame has its result (no object on the table is one), 1 some have none, or the results\n"
    "could not be written; what was finished is kept; 2 wrong command line.\n";

Options bad(const std::string& message) { return Options::error(objectness::StatusCode::kBadConfig, message); }

po::options_description shownOptions() {
  po::options_description options("Options");
  auto add = options.add_options();
  add("points", po::value<std::string>()->value_name("TOPIC"), "the clouds, sensor_msgs/PointCloud2");
  add("depth", po::value<std::string>()->value_name("TOPIC"),
      "depth images in the place of clouds, sensor_msgs/Image, rectified, 16UC1 (millimetres) or 32FC1 (metres)");
  add("rgb", po::value<std::string>()->value_name("TOPIC"),
      "pictures of the size of the depth images, for the colour of the results (default: those with their frame_id and "
      "size)");
  add("camera-info", po::value<std::string>()->value_name("TOPIC"),
      "their camera (default: the one with the nearest name)");
  add("approximate-sync", po::bool_switch(),
      "take the camera_info with the nearest stamp, whatever its frame_id, when none has the very stamp");
  add("fuse-frames", po::value<int>()->value_name("N"),
      "while camera and scene stand still depth is averaged over N frames, 1 to 100 (8); 1: every frame for itself");
  objectness::addConfigOptions(options);
  add("out", po::value<std::string>()->value_name("OUT.bag"), "the bag to write, replaced when it exists");
  add("help,h", po::bool_switch(), "print this");
  return options;
}

Options interpret(const po::variables_map& values) {
  Options options;
  SegmentBagOptions& value = options.value;
  if (values["help"].as<bool>()) {
    std::ostringstream help;
    help << kIntroduction << shownOptions() << kEnd;
    value.print = help.str();
    return options;
  }
  std::vector<std::string> inputs = objectness::listOf(values, "input");
  const auto status = objectness::readConfigOptions(values, inputs, value.settings.config);
  if (!status.ok()) return bad(status.message);
  const auto model = objectness::readModelOption(values, value.settings.model);
  if (!model.ok()) return bad(model.message);
  if (values.count("fuse-frames")) value.settings.fuse_frames = values["fuse-frames"].as<int>();
  if (value.settings.fuse_frames < 1 || value.settings.fuse_frames > objectness::kMostFused) {
    return bad("--fuse-frames must be 1 to 100");
  }
  value.settings.approximate_sync = values["approximate-sync"].as<bool>();
  value.topics = {objectness::textOf(values, "points"), objectness::textOf(values, "camera-info"),
                  objectness::textOf(values, "depth"), objectness::textOf(values, "rgb")};
  const InputTopics& topics = value.topics;
  if (!topics.points.empty() && !topics.depth.empty()) return bad("--points and --depth exclude each other");
  if (!topics.points.empty() && !topics.color.empty()) {
    return bad("--rgb belongs to depth images: clouds bring their own colour");
  }
  value.out = objectness::textOf(values, "out");
  if (inputs.size() != 1) return bad("one IN.bag is needed, not " + std::to_string(inputs.size()));
  value.in = inputs[0];
  if (value.out.empty()) return bad("no --out OUT.bag given: where shall the results go?");
  std::error_code none;
  if (std::filesystem::equivalent(value.in, value.out, none)) return bad("--out would overwrite the input " + value.in);
  return options;
}

}  // namespace

Options parseSegmentBagOptions(int argc, const char* const* argv) {
  try {
    return interpret(objectness::parseCommandLine(argc, argv, shownOptions(), objectness::Inputs::kAny));
  } catch (const po::error& e) {
    return bad(e.what());
  }
}

}  // namespace objectness_segmentation
