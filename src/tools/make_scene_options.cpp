// SPDX-License-Identifier: BSD-3-Clause
#include "tools/make_scene_options.hpp"

#include <boost/program_options.hpp>
#include <sstream>

#include "objectness_segmentation/io/camera_yaml.hpp"
#include "sim/lenses.hpp"
#include "sim/scene_generator.hpp"
#include "tools/command_line.hpp"

namespace objectness::sim {
namespace {

namespace po = boost::program_options;
using Options = Result<MakeSceneOptions>;

constexpr int kMaxCount = 1000000;  // folders are numbered
constexpr int kMaxSide_px = 4096;
constexpr double kMinRate_hz = 0.01, kMaxRate_hz = 1000;

constexpr const char* kIntroduction =
    "Simulates a depth camera that looks at things on a table, and writes what it sees with the truth about it.\n"
    "\n"
    "  make_scene --demo | --level NAME|all|everyday [OPTION...] --out DIR | --bag FILE.bag\n"
    "\n"
    "A scene is a folder: depth.png (16-bit millimetres), color.png, camera.yaml, labels.png (0 void, 1 table,\n"
    "2 tray, tote or shelf, 3 what stands around it, 20, 30, ... objects), objects.yaml (table, other background, and "
    "of\n"
    "each object kind, extent in the picture, visible share, pose and size) and pose.yaml (of the camera). A bag has "
    "the topics of a camera driver, and the truth on\n"
    "/truth/labels and /truth/objects. The same options give the same files.\n"
    "\n";

constexpr const char* kExamples =
    "\n"
    "Examples:\n"
    "  make_scene --demo --out scene\n"
    "  make_scene --level all --count 25 --out scenes\n"
    "  make_scene --level clutter --objects 12 --table round:1.1x0.72 --seed 7 --frames 60 --out sequence\n"
    "  make_scene --demo --frames 30 --rate 10 --bag demo.bag\n"
    "  make_scene --level everyday --count 25 --lens azure --out everyday\n"
    "  make_scene --level tray --around arm,table --lens realsense --sensor stereo --out tray\n"
    "  make_scene --level shapes --frames 20 --still --sensor stereo --out still\n"
    "\n"
    "Exit status: 0 everything written, 1 some scene could not be made or written, 2 wrong command line.\n";

Options bad(const std::string& message) { return Options::error(StatusCode::kBadConfig, message); }

po::options_description shownOptions() {
  po::options_description options("Options");
  auto add = options.add_options();
  const auto text = [](const char* name) { return po::value<std::string>()->value_name(name); };
  const auto number = [] { return po::value<long>()->value_name("N"); };
  add("demo", po::bool_switch(), "the built-in scene; the seed moves its objects a little");
  add("level", text("NAME"),
      "what the scene is like (--list); all: the levels from boxes to clutter; everyday: those from plates to "
      "contents");
  add("list", po::bool_switch(), "print the levels, from easy to hard, the everyday ones last");
  add("objects", number(), "how many objects, 0 to 40 (otherwise drawn at random)");
  add("seed", number(), "another seed, other scenes (1)");
  add("count", number(), "N scenes a level: DIR/LEVEL_0000, ... and their groups in DIR/groups.csv");
  add("frames", number(), "N frames of a camera that swings around the scene: DIR/frame_0000, ..., or one bag");
  add("still", po::bool_switch(),
      "the camera of --frames stands still: the same view, each frame with noise of its own");
  add("rate", po::value<double>()->value_name("HZ"), "frames of a bag a second (10)");
  add("ideal", po::bool_switch(), "a depth camera without noise, steps, shadows or limits");
  add("sensor", text("KIND"),
      "structured (light, like a Kinect; default), stereo (like a RealSense) or tof (time of flight, like an Azure "
      "Kinect)");
  add("camera", text("CAMERA.yaml"), "the camera's intrinsics (640 x 480, f = 525)");
  add("lens", text("NAME"), ("the size and lens of a depth camera: " + lensNames()).c_str());
  add("size", text("WIDTHxHEIGHT"), "scale the camera to another image width; the height is cut or grows");
  add("table", text("SIZE"), "metres: WIDTHxDEPTHxHEIGHT or round:DIAMETERxHEIGHT (otherwise drawn at random)");
  add("around", text("LIST"),
      "what stands around: arm, wall, rack, table, or none (drawn at random at everyday levels, otherwise none)");
  add("table-share", po::value<double>()->value_name("X"),
      "least share of the picture that table and objects fill, 0 to 0.9 (0.15); more means less floor");
  add("out", text("DIR"), "folder for the scene or scenes, made when missing");
  add("bag", text("FILE.bag"), "the scene as a recording, replaced when it exists");
  add("help,h", po::bool_switch(), "print this");
  return options;
}

std::string listLevels() {
  std::ostringstream list;
  for (const Level& level : levels()) {
    list << level.name << '\t' << level.min_objects << '-' << level.max_objects << '\t' << level.description
         << ", seen from " << level.view.min_tilt_deg << " to " << level.view.max_tilt_deg << " deg down\n";
  }
  return list.str();
}

/// The option's number in `value` if it was given and is in range; otherwise a message.
template <class Number>
std::string readNumber(const po::variables_map& values, const char* name, long least, long most, Number& value) {
  if (!values.count(name)) return "";
  const long given = values[name].as<long>();
  if (given < least || given > most) {
    return "--" + std::string(name) + " " + std::to_string(given) + ": must be " + std::to_string(least) + " to " +
           std::to_string(most);
  }
  value = static_cast<std::uint32_t>(given);
  return "";
}

/// The same lens on a sensor of another size.
Result<PinholeCamera> resize(const PinholeCamera& camera, const std::string& text) {
  std::istringstream in(text);
  int width = 0, height = 0;
  char x = 0;
  in >> width >> x >> height;
  if (!in || !(in >> std::ws).eof() || x != 'x' || width < 32 || height < 32 || width > kMaxSide_px ||
      height > kMaxSide_px) {
    return Result<PinholeCamera>::error(StatusCode::kBadConfig,
                                        "--size " + text + ": must be WIDTHxHEIGHT, 32 to 4096 pixels each");
  }
  const double scale = static_cast<double>(width) / camera.width;
  return {{},
          {camera.fx * scale, camera.fy * scale, (camera.cx + 0.5) * scale - 0.5,
           (camera.cy + 0.5 - camera.height / 2.0) * scale + height / 2.0 - 0.5, width, height}};
}

// What the options say is read in parts; each returns what is wrong, empty when nothing is.

std::string readScenes(const po::variables_map& values, MakeSceneOptions& o) {
  const std::string level = textOf(values, "level");
  const bool demo = values["demo"].as<bool>(), all = level == "all", everyday = level == "everyday";
  if (demo == (values.count("level") > 0)) return "give either --demo or --level NAME";
  if (!demo && !all && !everyday && !findLevel(level)) {
    return "--level " + level + ": must be all, " + levelNames() + " or everyday";
  }
  for (const Level& known : levels()) {
    if ((all && !known.everyday) || (everyday && known.everyday) || known.name == level) o.levels.push_back(known.name);
  }
  for (const std::string& problem :
       {readNumber(values, "objects", 0, kMaxObjects, o.objects), readNumber(values, "count", 1, kMaxCount, o.count),
        readNumber(values, "frames", 1, kMaxCount, o.frames), readNumber(values, "seed", 0, 4294967295, o.seed)}) {
    if (!problem.empty()) return problem;
  }
  if (demo &&
      (o.objects || o.count || values.count("table") || values.count("table-share") || values.count("around"))) {
    return "--objects, --count, --table, --table-share and --around belong to --level: the demo scene has its own";
  }
  if ((all || everyday) && !o.count) return "--level " + level + " needs --count N: how many scenes of each level?";
  o.still = values["still"].as<bool>();
  if (o.still && !o.frames) return "--still needs --frames N: how many?";
  if (o.count && o.frames) return "--count and --frames exclude each other: a sequence is of one scene";
  if (values.count("table")) {
    const Result<TableSize> table = parseTable(textOf(values, "table"));
    if (!table.ok()) return "--table: " + table.status.message;
    o.table = table.value;
  }
  if (values.count("around")) {
    const Result<Surroundings> around = parseSurroundings(textOf(values, "around"));
    if (!around.ok()) return "--around: " + around.status.message;
    o.around = around.value;
  }
  if (values.count("table-share")) {
    o.table_share = values["table-share"].as<double>();
    if (!(*o.table_share >= 0 && *o.table_share <= 0.9)) return "--table-share must be 0 to 0.9";
  }
  return "";
}

std::string readSensor(const po::variables_map& values, MakeSceneOptions& o) {
  if (values.count("camera") && values.count("lens")) return "--camera and --lens exclude each other";
  if (values.count("lens")) {
    const std::string name = textOf(values, "lens");
    const PinholeCamera* lens = findLens(name);
    if (!lens) return "--lens " + name + ": must be " + lensNames();
    o.sensor.camera = *lens;
  }
  if (values.count("camera")) {
    const std::string path = textOf(values, "camera");
    const Result<PinholeCamera> camera = loadCamera(path);
    if (!camera.ok()) return "--camera " + path + ": " + camera.status.message;
    o.sensor.camera = camera.value;
  }
  if (values.count("size")) {
    const Result<PinholeCamera> camera = resize(o.sensor.camera, textOf(values, "size"));
    if (!camera.ok()) return camera.status.message;
    o.sensor.camera = camera.value;
  }
  const std::string kind = values.count("sensor") ? textOf(values, "sensor") : "structured";
  if (kind != "structured" && kind != "stereo" && kind != "tof") {
    return "--sensor " + kind + ": must be structured, stereo or tof";
  }
  if (kind == "stereo") o.sensor = DepthSensor::stereo(o.sensor.camera);
  if (kind == "tof") o.sensor = DepthSensor::timeOfFlight(o.sensor.camera);
  o.sensor.ideal = values["ideal"].as<bool>();
  return "";
}

std::string readOutput(const po::variables_map& values, MakeSceneOptions& o) {
  if (values.count("rate")) o.rate_hz = values["rate"].as<double>();
  if (!(o.rate_hz >= kMinRate_hz && o.rate_hz <= kMaxRate_hz)) return "--rate: must be 0.01 to 1000 Hz";
  o.out = textOf(values, "out");
  o.bag = textOf(values, "bag");
  if (o.out.empty() && o.bag.empty()) return "neither --out DIR nor --bag FILE given: where shall the scene go?";
  if (o.count && !o.bag.empty()) return "--count and --bag exclude each other: a bag is of one scene";
  if (values.count("rate") && o.bag.empty()) return "--rate belongs to --bag";
  return "";
}

Options interpret(const po::variables_map& values) {
  Options options;
  if (values["help"].as<bool>()) {
    std::ostringstream help;
    help << kIntroduction << shownOptions() << kExamples;
    options.value.print = help.str();
    return options;
  }
  if (values["list"].as<bool>()) {
    options.value.print = listLevels();
    return options;
  }
  for (const auto read : {readScenes, readSensor, readOutput}) {
    const std::string problem = read(values, options.value);
    if (!problem.empty()) return bad(problem);
  }
  return options;
}

}  // namespace

Result<MakeSceneOptions> parseMakeSceneOptions(int argc, const char* const* argv) {
  try {
    return interpret(parseCommandLine(argc, argv, shownOptions(), Inputs::kNone));
  } catch (const po::error& e) {
    return bad(e.what());
  }
}

}  // namespace objectness::sim
