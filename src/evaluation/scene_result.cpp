// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/scene_result.hpp"

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/file_access.hpp"

namespace objectness::evaluation {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kStates[] = {"done", "failed", "unusable", "not_applicable"};

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

Json toJson(const std::optional<PictureBoxCounts>& counts) {
  if (!counts) return {};
  Json json;
  PictureBoxCounts::fields(*counts, [&](const char* name, int value) { json[name] = value; });
  return json;
}

Json toJson(const BoxFit& fit) {
  const BoxErrors& errors = fit.errors;
  Json json = {{"object", fit.object},
               {"kind", fit.kind},
               {"dice", fit.dice},
               {"overlap", errors.overlap},
               {"points_overlap", fit.points_overlap},
               {"centre_mm", errors.centre_mm},
               {"yaw_deg", errors.yaw_deg ? Json(*errors.yaw_deg) : Json()},
               {"sides_mm", {errors.sides_mm[0], errors.sides_mm[1], errors.sides_mm[2]}}};
  return json;
}

std::vector<double> numbers(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Json toJson(const OrientedBox& box) {
  const Eigen::Quaterniond q(box.T_camera_box.linear());
  return {{"position", numbers(box.T_camera_box.translation())},
          {"orientation_xyzw", {q.x(), q.y(), q.z(), q.w()}},
          {"size_m", numbers(box.size_m)}};
}

Eigen::Vector3d toVector(const Json& json) { return Eigen::Vector3d(json.get<std::array<double, 3>>().data()); }

OrientedBox toBox(const Json& json) {
  const auto q = json.at("orientation_xyzw").get<std::array<double, 4>>();
  OrientedBox box;
  box.T_camera_box.linear() = Eigen::Quaterniond(q.data()).normalized().toRotationMatrix();
  box.T_camera_box.translation() = toVector(json.at("position"));
  box.size_m = toVector(json.at("size_m"));
  return box;
}

BoxFit toBoxFit(const Json& json) {
  BoxFit fit;
  json.at("object").get_to(fit.object);
  json.at("kind").get_to(fit.kind);
  json.at("dice").get_to(fit.dice);
  json.at("overlap").get_to(fit.errors.overlap);
  json.at("points_overlap").get_to(fit.points_overlap);
  json.at("centre_mm").get_to(fit.errors.centre_mm);
  if (!json.at("yaw_deg").is_null()) fit.errors.yaw_deg = json.at("yaw_deg").get<double>();
  for (int k = 0; k < 3; ++k) json.at("sides_mm").at(k).get_to(fit.errors.sides_mm[k]);
  return fit;
}

std::optional<PictureBoxCounts> toPictureBoxes(const Json& json) {
  if (json.is_null()) return {};
  PictureBoxCounts counts;
  PictureBoxCounts::fields(counts, [&](const char* name, int& value) { json.at(name).get_to(value); });
  return counts;
}

SceneResult::State toState(const std::string& text) {
  for (std::size_t i = 0; i < std::size(kStates); ++i) {
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
  result.picture_boxes = toPictureBoxes(json.at("picture_boxes"));
  for (const Json& box : json.at("segment_boxes")) result.segment_boxes.push_back(toBox(box));
  result.up = toVector(json.at("up"));
  for (const Json& fit : json.at("box_fits")) result.box_fits.push_back(toBoxFit(fit));
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
  Json timings = Json::object(), proposals = Json::object(), gaps = Json::object(), fits = Json::array();
  Json boxes = Json::array();
  for (const OrientedBox& box : result.segment_boxes) boxes.push_back(toJson(box));
  for (const BoxFit& fit : result.box_fits) fits.push_back(toJson(fit));
  for (const auto& [name, value] : result.gaps) gaps[name] = value;
  for (const auto& [column, value] : result.proposals) proposals[column] = value;
  for (const auto& [stage, ms] : result.timings_ms) timings[stage] = ms;
  const Json json = {{"scene", result.scene},
                     {"method", result.method},
                     {"state", kStates[static_cast<int>(result.state)]},
                     {"problem", result.problem},
                     {"object", toJson(result.object)},
                     {"part", toJson(result.part)},
                     {"picture_boxes", toJson(result.picture_boxes)},
                     {"box_fits", fits},
                     {"segment_boxes", boxes},
                     {"up", numbers(result.up)},
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
