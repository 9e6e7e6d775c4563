// SPDX-License-Identifier: BSD-3-Clause
#include "tools/segment_options.hpp"

#include <boost/program_options.hpp>
#include <sstream>

#include "objectness_segmentation/io/camera_yaml.hpp"
#include "objectness_segmentation/io/config_yaml.hpp"
#include "objectness_segmentation/io/depth_scale.hpp"
#include "tools/command_line.hpp"
#include "tools/config_options.hpp"

namespace objectness {
namespace {

namespace po = boost::program_options;

constexpr const char* kIntroduction =
    "Finds and segments the objects on a table by their 3D objectness.\n"
    "\n"
    "  segment [OPTION...] --out DIR INPUT...\n"
    "\n"
    "INPUT is a scene folder (depth.png: 16-bit millimetres, camera.yaml: as ROS camera_info, optional color.png)\n"
    "or a .pcd file. For each, DIR/NAME/labels.png (0 nothing, 1 table, 2 and above the objects, best first) and\n"
    "DIR/NAME/objects.json are written; NAME is the folder's name, or the file's without .pcd.\n"
    "\n";

constexpr const char* kExamples =
    "\n"
    "Examples:\n"
    "  segment --pictures --out results scene\n"
    "  segment --out results --camera camera.yaml list_of_points.pcd\n"
    "  segment --out results --depth-scale 5000 scene_of_fifths_of_a_millimetre\n"
    "  segment --out results --set search.angle_step_deg=10 --set filter.threshold=0.8 scenes/*\n"
    "  segment --print-config --set volume.min_extent_m=1 > preset.yaml\n"
    "  segment --config preset.yaml --out results scene\n"
    "\n"
    "Exit status: 0 all inputs done (no object on the table is a result), 1 some input could not be used, or its\n"
    "results not written, 2 wrong command line.\n";

Result<SegmentOptions> bad(const std::string& message) {
  return Result<SegmentOptions>::error(StatusCode::kBadConfig, message);
}

po::options_description shownOptions() {
  po::options_description options("Options");
  auto add = options.add_options();
  addConfigOptions(options);
  add("camera", po::value<std::string>()->value_name("CAMERA.yaml"),
      "the camera of .pcd files (otherwise recovered from the pixel grid) and of folders without camera.yaml");
  add("depth-scale", po::value<std::string>()->value_name("N"),
      "unit of depth.png: N units are a metre, or where N is less than 1, metres of a unit (input.depth_unit_m; "
      "otherwise depth_scale of camera.yaml, or 1000: millimetres)");
  add("pictures", po::bool_switch(), "write DIR/NAME/overlay.png too");
  add("out", po::value<std::string>()->value_name("DIR"), "folder for the results, made when missing");
  add("list-parameters", po::bool_switch(), "print every parameter: name, type, default, least, largest, description");
  add("print-config", po::bool_switch(), "print the parameters as they result from --config, --set, ... as a preset");
  add("help,h", po::bool_switch(), "print this");
  return options;
}

Result<SegmentOptions> interpret(const po::variables_map& values) {
  const auto text = [&](const char* name) { return textOf(values, name); };
  const auto is_set = [&](const char* name) { return values[name].as<bool>(); };

  Result<SegmentOptions> options;
  if (is_set("help")) {
    std::ostringstream help;
    help << kIntroduction << shownOptions() << kExamples;
    options.value.print = help.str();
    return options;
  }
  if (is_set("list-parameters")) {
    options.value.print = listParameters();
    return options;
  }

  std::vector<std::string> inputs = listOf(values, "input");
  const Status status = readConfigOptions(values, inputs, options.value.config);
  if (!status.ok()) return bad(status.message);
  if (values.count("depth-scale")) {
    const Result<double> unit = depthUnit(text("depth-scale"));
    if (!unit.ok()) return bad("--depth-scale " + unit.status.message);
    options.value.config.input.depth_unit_m = unit.value;
  }
  if (is_set("print-config")) {
    options.value.print = toYaml(options.value.config);
    return options;
  }

  const Status model = readModelOption(values, options.value.model);
  if (!model.ok()) return bad(model.message);
  if (values.count("camera")) {
    const Result<ImageCamera> camera = loadImageCamera(text("camera"));
    if (!camera.ok()) return bad("--camera " + text("camera") + ": " + camera.status.message);
    options.value.camera = camera.value;
  }
  options.value.out = text("out");
  options.value.pictures = is_set("pictures");
  options.value.inputs = inputs;
  if (inputs.empty()) return bad("no INPUT given: name a scene folder or a .pcd file");
  if (options.value.out.empty()) return bad("no --out DIR given: where shall the results go?");
  return options;
}

}  // namespace

Result<SegmentOptions> parseSegmentOptions(int argc, const char* const* argv) {
  try {
    return interpret(parseCommandLine(argc, argv, shownOptions(), Inputs::kAny));
  } catch (const po::error& e) {
    return bad(e.what());
  }
}

}  // namespace objectness
