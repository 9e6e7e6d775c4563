// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/run.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/file_access.hpp"

namespace objectness::evaluation {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uintmax_t kMaxRunBytes = 64 * kMaxTextBytes;

std::string runPath(const std::string& report) { return (fs::path(report) / "run.json").string(); }

Run toRun(const Json& json) {
  Run run;
  json.at("commit").get_to(run.commit);
  json.at("machines").get_to(run.machines);
  json.at("jobs").get_to(run.jobs);
  json.at("shard").get_to(run.shard);
  json.at("shards").get_to(run.shards);
  run.still = json.value("still", false);
  for (const Json& level : json.at("levels")) {
    run.levels.push_back(level == Json(toString(Level::kObject)) ? Level::kObject : Level::kPart);
  }
  for (const Json& method : json.at("methods")) {
    run.methods.push_back({method.at("name"), method.at("description"), method.at("settings")});
  }
  for (const Json& scene : json.at("scenes")) {
    run.scenes.push_back({scene.at("name"), scene.at("group"), scene.value("camera", "")});
  }
  return run;
}

}  // namespace

Status saveRun(const std::string& report, const Run& run) {
  Json levels = Json::array(), methods = Json::array(), scenes = Json::array();
  for (const Level level : run.levels) levels.push_back(toString(level));
  for (const auto& method : run.methods) {
    methods.push_back(Json{{"name", method.name}, {"description", method.description}, {"settings", method.settings}});
  }
  for (const auto& scene : run.scenes) {
    scenes.push_back(Json{{"name", scene.name}, {"group", scene.group}, {"camera", scene.camera}});
  }
  const Json json = {{"commit", run.commit}, {"machines", run.machines}, {"jobs", run.jobs},
                     {"shard", run.shard},   {"shards", run.shards},     {"still", run.still},
                     {"levels", levels},     {"methods", methods},       {"scenes", scenes}};
  return writeFile(runPath(report), json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

Result<Run> loadRun(const std::string& report) {
  const Result<std::string> text = readFile(runPath(report), kMaxRunBytes);
  if (!text.ok()) {
    return Result<Run>::error(StatusCode::kBadInput,
                              report + ": holds no finished report (run.json: " + text.status.message + ")");
  }
  try {
    return {{}, toRun(Json::parse(text.value))};
  } catch (const std::exception&) {
    return Result<Run>::error(StatusCode::kBadInput, report + ": its run.json is not of this tool");
  }
}

}  // namespace objectness::evaluation
