// SPDX-License-Identifier: BSD-3-Clause
#include "tools/evaluate_options.hpp"

#include <algorithm>
#include <boost/program_options.hpp>
#include <cstdio>
#include <sstream>

#include "evaluation/methods.hpp"
#include "objectness_segmentation/tracking/depth_fusion.hpp"
#include "tools/command_line.hpp"
#include "tools/config_options.hpp"

namespace objectness::evaluation {
namespace {

namespace po = boost::program_options;

constexpr const char* kIntroduction =
    "Measures how well methods find the objects of scenes with known truth.\n"
    "\n"
    "  evaluate [OPTION...] --report DIR SCENES...\n"
    "  evaluate merge --report DIR SHARD_DIR...\n"
    "\n"
    "SCENES are scene folders with truth, or data sets: folders of such. Truth is labels.png, or objects.yaml with\n"
    "boxes in the picture, or both. Scenes of one name in different data sets are called DATA_SET/NAME.\n"
    "DIR gets report.html, summary.json, scenes.csv, cameras.csv (a row a data set), picture_boxes.csv, boxes.csv\n"
    "and objects.csv (boxes in space, of simulated scenes), plots/ and all results (results/METHOD/SCENE.json,\n"
    "SCENE/labels.png, SCENE/overlay.png). The method oracle gives every piece of the default method to its true\n"
    "object: what perfect grouping would reach. clustering is correlation clustering of the default method's links,\n"
    "to compare its choice with.\n"
    "What DIR holds already of the same commit, settings and scene is not computed again, so an interrupted run\n"
    "goes on where it was. `merge` joins the reports that were computed with --shard into one.\n"
    "\n";

constexpr const char* kExamples =
    "\n"
    "Examples:\n"
    "  evaluate --report report scenes/\n"
    "  evaluate --method paper --method boxes --level object --level part --jobs 4 --report report scenes/\n"
    "  parallel evaluate --shard {}/8 --report part{} scenes/ ::: 1 2 3 4 5 6 7 8\n"
    "  evaluate merge --report report part?\n"
    "\n"
    "Exit status: 0 all evaluated, 1 some scene could not be used, some method failed in a scene (it then counts as\n"
    "having found nothing there), or the report could not be written; 2 wrong command line.\n";

constexpr int kMostJobs = 1024, kMostThreads = 64, kMostShards = 1000000;

Result<EvaluateOptions> bad(const std::string& message) {
  return Result<EvaluateOptions>::error(StatusCode::kBadConfig, message);
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

po::options_description shownOptions() {
  po::options_description options("Options");
  auto add = options.add_options();
  const auto list = [] { return po::value<std::vector<std::string>>()->composing(); };
  const std::string methods =
      "a method, may be repeated: " + joined(methodNames()) + " (default: all but the last two)";
  add("method", list()->value_name("NAME"), methods.c_str());
  add("level", list()->value_name("object|part"),
      "what counts as one object of the truth: whole objects or their annotated parts; may be repeated (default: "
      "object)");
  addParameterOptions(options);
  addModelOption(options);
  add("jobs", po::value<int>()->value_name("N")->default_value(1),
      "scenes at a time; compare milliseconds only of runs with 1");
  add("threads", po::value<int>()->value_name("N")->default_value(2),
      "worker threads of a method, 0: one per processor");
  add("still", po::bool_switch(),
      "each data set is a sequence of frames of a scene that stands still, by name: report how much results differ "
      "from "
      "frame to frame; truth need not be there");
  add("fuse-frames", po::value<int>()->value_name("N")->default_value(0),
      "with --still: frames follow one another as in segment_bag, with its --fuse-frames N; 0: every frame for itself");
  add("shard", po::value<std::string>()->value_name("K/N"), "only every N-th scene, beginning with the K-th (1..N)");
  add("groups", po::value<std::string>()->value_name("FILE.csv"),
      "groups of scenes (columns scene, group); default: groups.csv in the folder of the scenes, or "
      "FOLDER_groups.csv beside it");
  add("report", po::value<std::string>()->value_name("DIR"), "folder of the report, made when missing");
  add("help,h", po::bool_switch(), "print this");
  return options;
}

bool parseShard(const std::string& text, int& shard, int& shards) {
  char rest = 0;
  return std::sscanf(text.c_str(), "%d/%d%c", &shard, &shards, &rest) == 2 && shards >= 1 && shards <= kMostShards &&
         shard >= 1 && shard <= shards;
}

// What the options say is read in parts; each returns what is wrong, empty when nothing is.

std::string readPlaces(const po::variables_map& values, EvaluateOptions& options) {
  options.report = textOf(values, "report");
  options.groups_file = textOf(values, "groups");
  options.inputs = listOf(values, "input");
  options.merge = !options.inputs.empty() && options.inputs.front() == "merge";
  if (options.merge) {
    options.inputs.erase(options.inputs.begin());
    for (const char* name :
         {"method", "level", "config", "set", "model", "jobs", "threads", "still", "fuse-frames", "shard", "groups"}) {
      if (values.count(name) && !values[name].defaulted()) {
        return std::string("--") + name + ": merge takes it from the shards";
      }
    }
    if (options.inputs.empty()) return "no SHARD_DIR given: name the report folders of all shards";
  }
  return options.report.empty() ? "no --report DIR given: where shall the report go?" : "";
}

std::string readMethodsAndLevels(const po::variables_map& values, EvaluateOptions& options) {
  options.methods = listOf(values, "method");
  if (options.methods.empty()) options.methods = usualMethodNames();
  const auto methods = makeMethods(options.methods, {});
  if (!methods.ok()) return "--method: " + methods.status.message;
  for (const std::string& level : listOf(values, "level")) {
    if (level != "object" && level != "part") return "--level " + level + ": must be object or part";
    const Level value = level == "object" ? Level::kObject : Level::kPart;
    if (std::find(options.levels.begin(), options.levels.end(), value) == options.levels.end()) {
      options.levels.push_back(value);
    }
  }
  if (options.levels.empty()) options.levels = {Level::kObject};
  return "";
}

std::string readNumber(const po::variables_map& values, const std::string& name, int least, int most, int& number) {
  number = values[name].as<int>();
  if (number >= least && number <= most) return "";
  return "--" + name + " " + std::to_string(number) + ": must be within " + std::to_string(least) + " and " +
         std::to_string(most);
}

std::string readWork(const po::variables_map& values, EvaluateOptions& options) {
  std::string problem = readNumber(values, "jobs", 1, kMostJobs, options.jobs);
  if (problem.empty()) problem = readNumber(values, "threads", 0, kMostThreads, options.threads);
  options.still = values["still"].as<bool>();
  if (problem.empty()) problem = readNumber(values, "fuse-frames", 0, kMostFused, options.fuse_frames);
  if (problem.empty() && options.fuse_frames > 0 && !options.still) problem = "--fuse-frames belongs to --still";
  const std::string shard = textOf(values, "shard");
  if (problem.empty() && options.still && values.count("shard")) problem = "--still: needs all frames, not a --shard";
  if (problem.empty() && values.count("shard") && !parseShard(shard, options.shard, options.shards)) {
    problem = "--shard " + shard + ": must be K/N with 1 <= K <= N, as 2/8";
  }
  return problem;
}

std::string readParameters(const po::variables_map& values, EvaluateOptions& options) {
  Status status = readParameterOptions(values, options.inputs, {"runtime.threads=" + std::to_string(options.threads)},
                                       options.config);
  if (status.ok()) status = readModelOption(values, options.model);
  return status.message;
}

Result<EvaluateOptions> interpret(const po::variables_map& values) {
  Result<EvaluateOptions> options;
  if (values["help"].as<bool>()) {
    std::ostringstream help;
    help << kIntroduction << shownOptions() << kExamples;
    options.value.print = help.str();
    return options;
  }
  for (const auto read : {readPlaces, readMethodsAndLevels, readWork, readParameters}) {
    const std::string problem = read(values, options.value);
    if (!problem.empty()) return bad(problem);
  }
  return options;
}

}  // namespace

Result<EvaluateOptions> parseEvaluateOptions(int argc, const char* const* argv) {
  try {
    return interpret(parseCommandLine(argc, argv, shownOptions(), Inputs::kAny));
  } catch (const po::error& e) {
    return bad(e.what());
  }
}

}  // namespace objectness::evaluation
