// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/evaluation/scene_result.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/file_access.hpp"

namespace objectness::evaluation {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kStates[] = {"done", "failed", "unusable"};

Json toJson(const std::optional<Scores>& scores) {
  if (!scores) return {};
  Json json;
  Scores::fields(*scores, [&](const char* name, double value) { json[name] = value; });
  return json;
}

std::optional<Scores> toScores(const Json& json) {
  if (json.is_null()) return {};
  Scores scores;
  Scores::fields(scores, [&](const char* name, double& value) { json.at(name).get_to(value); });
  return scores;
}

SceneResult::State toState(const std::string& text) {
  for (int i = 0; i < 3; ++i) {
    if (text == kStates[i]) return static_cast<SceneResult::State>(i);
  }
  throw std::runtime_error("unknown state " + text);
}

SceneResult toResult(const Json& json) {
  SceneResult result;
  json.at("scene").get_to(result.scene);
  json.at("method").get_to(result.method);
  json.at("made_from").get_to(result.made_from);
  result.state = toState(json.at("state"));
  json.at("problem").get_to(result.problem);
  result.object = toScores(json.at("object"));
  result.part = toScores(json.at("part"));
  json.at("segments").get_to(result.segments);
  for (const auto& [column, value] : json.at("proposals").items())
    result.proposals.emplace_back(column, value.get<double>());
  for (const auto& [name, value] : json.at("gaps").items()) result.gaps.emplace_back(name, value.get<double>());
  for (const auto& [stage, ms] : json.at("timings_ms").items()) result.timings_ms.emplace_back(stage, ms.get<double>());
  json.at("peak_mib").get_to(result.peak_mib);
  return result;
}

}  // namespace

std::optional<double> SceneResult::totalMs() const {
  for (const auto& [stage, ms] : timings_ms) {
    if (stage == "total") return ms;
  }
  return {};
}

std::string resultPath(const std::string& report, const std::string& method, const std::string& scene) {
  return (fs::path(report) / "results" / method / scene).string();
}

Status saveResult(const std::string& report, const SceneResult& result) {
  Json timings = Json::object(), proposals = Json::object(), gaps = Json::object();
  for (const auto& [name, value] : result.gaps) gaps[name] = value;
  for (const auto& [column, value] : result.proposals) proposals[column] = value;
  for (const auto& [stage, ms] : result.timings_ms) timings[stage] = ms;
  const Json json = {{"scene", result.scene},
                     {"method", result.method},
                     {"state", kStates[static_cast<int>(result.state)]},
                     {"problem", result.problem},
                     {"object", toJson(result.object)},
                     {"part", toJson(result.part)},
                     {"segments", result.segments},
                     {"proposals", proposals},
                     {"gaps", gaps},
                     {"timings_ms", timings},
                     {"peak_mib", result.peak_mib},
                     {"made_from", result.made_from}};
  const std::string path = resultPath(report, result.method, result.scene);
  const Status made = makeFolder(fs::path(path).parent_path().string());
  // A file name need not be UTF-8: what is not is replaced.
  return made.ok() ? writeFile(path + ".json", json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n") : made;
}

Result<SceneResult> loadResult(const std::string& report, const std::string& method, const std::string& scene) {
  const std::string path = resultPath(report, method, scene) + ".json";
  const Result<std::string> text = readFile(path, kMaxTextBytes);
  if (!text.ok()) return Result<SceneResult>::error(about(path, text.status));
  try {
    return {{}, toResult(Json::parse(text.value))};
  } catch (const std::exception&) {
    return Result<SceneResult>::error(StatusCode::kBadInput, path + ": is no result of this tool: remove it");
  }
}

}  // namespace objectness::evaluation
