// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate_options.hpp"

#include <algorithm>
#include <boost/program_options.hpp>
#include <cstdio>
#include <sstream>

#include "command_line.hpp"
#include "objectness_segmentation/evaluation/methods.hpp"

namespace objectness::evaluation {
namespace {

namespace po = boost::program_options;

constexpr const char* kIntroduction =
    "Measures how well methods find the objects of scenes with known truth.\n"
    "\n"
    "  evaluate [OPTION...] --report DIR SCENES...\n"
    "  evaluate merge --report DIR SHARD_DIR...\n"
    "\n"
    "SCENES are scene folders with truth (labels.png) or folders of such. DIR gets report.html, summary.json,\n"
    "scenes.csv, plots/ and all results (results/METHOD/SCENE.json, SCENE/labels.png, SCENE/overlay.png).\n"
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
  const std::string methods = "a method, may be repeated: " + joined(methodNames()) + " (default: all)";
  add("method", list()->value_name("NAME"), methods.c_str());
  add("level", list()->value_name("object|part"),
      "what counts as one object of the truth: whole objects or their annotated parts; may be repeated (default: "
      "object)");
  add("jobs", po::value<int>()->value_name("N")->default_value(1),
      "scenes at a time; compare milliseconds only of runs with 1");
  add("threads", po::value<int>()->value_name("N")->default_value(2),
      "worker threads of a method, 0: one per processor");
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

Result<EvaluateOptions> interpret(const po::variables_map& values) {
  const auto text = [&](const char* name) { return textOf(values, name); };
  const auto list = [&](const char* name) { return listOf(values, name); };
  Result<EvaluateOptions> result;
  EvaluateOptions& options = result.value;
  if (values["help"].as<bool>()) {
    std::ostringstream help;
    help << kIntroduction << shownOptions() << kExamples;
    options.print = help.str();
    return result;
  }
  options.report = text("report");
  options.groups_file = text("groups");
  options.inputs = list("input");
  options.jobs = values["jobs"].as<int>();
  options.threads = values["threads"].as<int>();
  if (!options.inputs.empty() && options.inputs.front() == "merge") {
    options.merge = true;
    options.inputs.erase(options.inputs.begin());
    for (const char* name : {"method", "level", "jobs", "threads", "shard", "groups"}) {
      if (values.count(name) && !values[name].defaulted()) {
        return bad(std::string("--") + name + ": merge takes it from the shards");
      }
    }
  }

  options.methods = list("method");
  if (options.methods.empty()) options.methods = methodNames();
  const auto methods = makeMethods(options.methods, 1);
  if (!methods.ok()) return bad("--method: " + methods.status.message);
  for (const std::string& level : list("level")) {
    if (level != "object" && level != "part") return bad("--level " + level + ": must be object or part");
    const Level value = level == "object" ? Level::kObject : Level::kPart;
    if (std::find(options.levels.begin(), options.levels.end(), value) == options.levels.end()) {
      options.levels.push_back(value);
    }
  }
  if (options.levels.empty()) options.levels = {Level::kObject};
  if (options.jobs < 1 || options.jobs > kMostJobs) {
    return bad("--jobs " + std::to_string(options.jobs) + ": must be within 1 and " + std::to_string(kMostJobs));
  }
  if (options.threads < 0 || options.threads > kMostThreads) {
    return bad("--threads " + std::to_string(options.threads) + ": must be within 0 and " +
               std::to_string(kMostThreads));
  }
  if (values.count("shard") && !parseShard(text("shard"), options.shard, options.shards)) {
    return bad("--shard " + text("shard") + ": must be K/N with 1 <= K <= N, as 2/8");
  }
  if (options.report.empty()) return bad("no --report DIR given: where shall the report go?");
  if (options.merge && options.inputs.empty()) {
    return bad("no SHARD_DIR given: name the report folders of all shards");
  }
  return result;
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
