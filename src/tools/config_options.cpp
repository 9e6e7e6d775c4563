// SPDX-License-Identifier: BSD-3-Clause
#include "tools/config_options.hpp"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <iterator>

#include "method_names.hpp"
#include "objectness_segmentation/io/config_yaml.hpp"
#include "tools/tool_message.hpp"

namespace objectness {
namespace {

namespace po = boost::program_options;

/// group.field=value that is no file: what "--set A=1 B=2" leaves among the inputs.
bool isAssignment(const std::string& text) {
  const std::string name = text.substr(0, text.find('='));
  std::error_code ignored;
  return name.size() < text.size() && name.find('.') != std::string::npos && name.find('/') == std::string::npos &&
         !std::filesystem::exists(text, ignored);
}

}  // namespace

void addParameterOptions(po::options_description& options) {
  auto add = options.add_options();
  add("config", po::value<std::string>()->value_name("FILE.yaml"), "preset of parameters (group: {field: value})");
  add("set", po::value<std::vector<std::string>>()->value_name("NAME=VALUE")->composing(),
      "set a parameter after the preset, as group.field=value; may be repeated, and more may follow each");
}

void addModelOption(po::options_description& options) {
  options.add_options()("model", po::value<std::string>()->value_name("FILE.json"),
                        "model of learn_objectness for the method objectness (default: the one that is built in)");
}

void addConfigOptions(po::options_description& options) {
  options.add_options()("method", po::value<std::string>()->value_name("NAME"),
                        "objectness: groups of superpixels of any height and tilt, scored by what was learned (the "
                        "default); paper: the paper's boxes, which superpixels follow; boxes: the points within these "
                        "boxes (pipeline.method)");
  addParameterOptions(options);
  addModelOption(options);
  auto add = options.add_options();
  add("threads", po::value<std::string>()->value_name("N"), "worker threads, 0: one per processor (runtime.threads)");
  add("seed", po::value<std::string>()->value_name("N"), "seed of the selection (runtime.seed)");
}

Status readParameterOptions(const po::variables_map& values, std::vector<std::string>& inputs,
                            const std::vector<std::string>& more, Config& config) {
  std::vector<std::string> warnings;
  if (values.count("config")) {
    const auto path = values["config"].as<std::string>();
    const Status status = loadConfig(path, config, &warnings);
    if (!status.ok()) return Status::error(StatusCode::kBadConfig, "--config " + path + ": " + status.message);
  }
  std::vector<std::string> assignments;
  if (values.count("set")) {
    assignments = values["set"].as<std::vector<std::string>>();
    const auto first =
        std::stable_partition(inputs.begin(), inputs.end(), [](const auto& i) { return !isAssignment(i); });
    std::move(first, inputs.end(), std::back_inserter(assignments));
    inputs.erase(first, inputs.end());
  }
  assignments.insert(assignments.end(), more.begin(), more.end());
  const Status status = setParameters(assignments, config, &warnings);
  for (const std::string& warning : warnings) printToolMessage(program_invocation_short_name, warning);
  return status;
}

Status readConfigOptions(const po::variables_map& values, std::vector<std::string>& inputs, Config& config) {
  std::vector<std::string> assignments;
  if (values.count("method")) {
    const auto method = values["method"].as<std::string>();
    if (!methodNamed(method)) {
      return Status::error(StatusCode::kBadConfig, "--method " + method + ": there are only the methods '" +
                                                       joinedMethodNames("', '", "' and '") + "'");
    }
    assignments.push_back("pipeline.method=" + method);
  }
  for (const char* name : {"threads", "seed"}) {
    if (values.count(name))
      assignments.push_back(std::string("runtime.") + name + "=" + values[name].as<std::string>());
  }
  return readParameterOptions(values, inputs, assignments, config);
}

Status readModelOption(const po::variables_map& values, std::optional<LearnedObjectness>& model) {
  if (!values.count("model")) return {};
  const auto path = values["model"].as<std::string>();
  Result<LearnedObjectness> loaded = loadModel(path);
  if (!loaded.ok()) return Status::error(StatusCode::kBadConfig, "--model " + path + ": " + loaded.status.message);
  model = std::move(loaded.value);
  return {};
}

}  // namespace objectness
