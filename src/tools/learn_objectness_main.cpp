// SPDX-License-Identifier: BSD-3-Clause
// Learns the model of the bottom-up method from labelled scenes: see `learn_objectness --help`.
#include <unistd.h>

#include <boost/program_options.hpp>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>

#include "evaluation/learn.hpp"
#include "tools/command_line.hpp"
#include "tools/config_options.hpp"
#include "tools/tool_message.hpp"

namespace {

namespace po = boost::program_options;
using namespace objectness;
using namespace objectness::evaluation;

constexpr const char* kIntroduction =
    "Learns how much a group of superpixels looks like one whole object, from scenes whose objects are known.\n\n"
    "  learn_objectness --out MODEL.json [OPTION...] SCENES...\n\n"
    "SCENES are scene folders with labels.png, or folders of such. Prints how well scenes are segmented by models "
    "that\n"
    "were learned without them (cross-validation), by group. Cues and gap links that --set switches off\n"
    "(group_cues.free=false, links.gaps=false) are not learned from; use the model with the same switches.\n\n";

int fail(const std::string& message, int status) {
  printToolMessage("learn_objectness", message);
  return status;
}

/// Empty when the file can be written; looked at before hours of learning, not after.
std::string outputProblem(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return "it is a folder";
  if (fs::exists(path, ignored)) return access(path.c_str(), W_OK) == 0 ? "" : "no permission to write";
  const fs::path parent = fs::path(path).parent_path();
  const std::string folder = parent.empty() ? "." : parent.string();
  if (!fs::is_directory(folder, ignored)) return "there is no folder " + folder;
  return access(folder.c_str(), W_OK | X_OK) == 0 ? "" : "no permission to write into " + folder;
}

void printScores(const std::vector<HeldOutScores>& held_out) {
  std::map<std::string, std::pair<int, std::map<std::string, double>>> groups;
  std::vector<std::string> columns;
  for (const HeldOutScores& scene : held_out) {
    for (const std::string& group : {scene.group, std::string("~ALL")}) {  // ~ sorts last
      auto& [count, sums] = groups[group];
      ++count;
      Scores::fields(scene.scores, [&](const char* name, double value) { sums[name] += value; });
    }
  }
  const Scores none;
  Scores::fields(none, [&](const char* name, double) { columns.emplace_back(name); });
  std::cout << std::left << std::setw(12) << "held out" << std::right << std::setw(7) << "scenes";
  for (const std::string& column : columns) std::cout << std::setw(8) << column;
  std::cout << std::fixed << std::setprecision(4) << "\n";
  for (const auto& [group, entry] : groups) {
    std::cout << std::left << std::setw(12) << (group == "~ALL" ? "ALL" : group) << std::right << std::setw(7)
              << entry.first;
    for (const std::string& column : columns) std::cout << std::setw(8) << entry.second.at(column) / entry.first;
    std::cout << "\n";
  }
}

int run(const po::variables_map& values) {
  std::vector<std::string> inputs = listOf(values, "input");
  LearnSettings settings;
  const Status read = readParameterOptions(values, inputs, {}, settings.config);
  if (!read.ok()) return fail(read.message + " (learn_objectness --help)", 2);
  if (inputs.empty()) return fail("no SCENES given (learn_objectness --help)", 2);
  const std::string path = textOf(values, "out"), problem = outputProblem(path);
  if (!problem.empty()) return fail("--out " + path + ": cannot be written: " + problem, 1);
  const Result<SceneList> list = findScenes(inputs, textOf(values, "groups"));
  if (!list.ok()) return fail(list.status.message, 1);
  for (const std::string& error : list.value.errors) fail(error, 1);
  if (!list.value.errors.empty()) return 1;

  settings.folds = values["folds"].as<int>();
  settings.threads = values["threads"].as<int>();
  if (settings.threads < 0) return fail("--threads must not be negative", 2);
  if (settings.folds < 2) return fail("--folds must be at least 2", 2);
  const int weight = values["recorded-weight"].as<int>();
  if (weight < 1) return fail("--recorded-weight must be at least 1", 2);
  if (weight > 1) {
    for (const Scene& scene : list.value.scenes) {
      if (!std::filesystem::exists(scene.folder + "/pose.yaml")) settings.weights[scene.folder] = weight;
    }
  }
  const bool terminal = isatty(STDERR_FILENO);
  settings.progress = [&](const std::string& stage, std::size_t done, std::size_t of) {
    if (terminal)
      std::cerr << "\r\033[K" << stage << " " << done << "/" << of << (done == of ? "\n" : "") << std::flush;
  };
  Result<LearnedModel> learned = learn(list.value.scenes, settings);
  if (!learned.ok()) return fail(learned.status.message, 1);
  for (const std::string& note : learned.value.notes) fail("left out: " + note, 0);
  learned.value.model.trained_on = values["note"].as<std::string>();
  std::cout << list.value.scenes.size() << " scenes; samples: " << learned.value.contacts << " contacts, "
            << learned.value.gaps << " gaps, " << learned.value.groups << " groups\n";
  printScores(learned.value.held_out);

  std::ofstream file(path);
  file << toJson(learned.value.model) << "\n";
  file.close();
  return file ? 0 : fail(path + ": cannot be written", 1);
}

}  // namespace

int main(int argc, char** argv) {
  po::options_description options("Options");
  auto add = options.add_options();
  add("out", po::value<std::string>()->value_name("MODEL.json"), "the model");
  add("note", po::value<std::string>()->value_name("TEXT")->default_value(""),
      "what it was learned from, in words; kept in the model");
  add("groups", po::value<std::string>()->value_name("FILE.csv"), "groups of the scenes (columns scene, group)");
  addParameterOptions(options);
  add("recorded-weight", po::value<int>()->value_name("N")->default_value(1),
      "scenes that make_scene did not make (without pose.yaml) count N times");
  add("folds", po::value<int>()->value_name("N")->default_value(5), "of the cross-validation");
  add("threads", po::value<int>()->value_name("N")->default_value(2), "worker threads, 0: one per processor");
  add("help,h", "print this");
  try {
    const po::variables_map values = parseCommandLine(argc, argv, options, Inputs::kAny);
    if (values.count("help")) {
      std::cout << kIntroduction << options;
      return 0;
    }
    if (textOf(values, "out").empty()) return fail("no --out MODEL.json given (learn_objectness --help)", 2);
    return run(values);
  } catch (const po::error& e) {
    return fail(std::string(e.what()) + " (learn_objectness --help)", 2);
  } catch (const std::exception& e) {
    return fail(e.what(), 1);
  }
}
