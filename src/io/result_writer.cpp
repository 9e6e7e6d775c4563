// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/io/result_writer.hpp"

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/file_access.hpp"
#include "io/png_file.hpp"
#include "objectness_segmentation/io/overlay.hpp"

namespace objectness {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

Json toJson(const Eigen::Vector3d& v) { return Json::array({v.x(), v.y(), v.z()}); }

Json orientation(const Eigen::Matrix3d& rotation) {
  Eigen::Quaterniond q(rotation);
  q.normalize();
  if (q.w() < 0) q.coeffs() *= -1;  // of the two that mean the same
  return Json::array({q.x(), q.y(), q.z(), q.w()});
}

Json toJson(const Table& table) {
  const Eigen::Isometry3d T_camera_table = table.T_table_camera.inverse();
  Json hull = Json::array(), measured = Json::array();
  for (const Eigen::Vector2d& corner : table.hull) hull.push_back({corner.x(), corner.y()});
  for (const char side : table.hull_measured) measured.push_back(side != 0);
  return {{"normal", toJson(table.normal)},
          {"d", table.d},
          {"frame",
           {{"position", toJson(T_camera_table.translation())}, {"orientation", orientation(T_camera_table.linear())}}},
          {"hull", hull},
          {"hull_measured", measured}};
}

/// Label of what an object stands on: 0 where it is nothing that has one.
int labelOf(const Support& support) {
  if (support.kind == SupportKind::kTable) return kTableLabel;
  return support.kind == SupportKind::kSegment ? support.segment + kFirstObjectLabel : 0;
}

Json labelsOf(const std::vector<int>& segments) {
  Json labels = Json::array();
  for (const int segment : segments) labels.push_back(segment + kFirstObjectLabel);
  return labels;
}

Json toJson(const OrientedBox& box) {
  return {{"position", toJson(box.T_camera_box.translation())},
          {"orientation", orientation(box.T_camera_box.linear())},
          {"size", toJson(box.size_m)}};
}

Json toJson(const Segment& segment, std::size_t label) {
  return {{"label", label},
          {"position", toJson(segment.box.T_camera_box.translation())},
          {"orientation", orientation(segment.box.T_camera_box.linear())},
          {"size", toJson(segment.box.size_m)},
          {"objectness", segment.objectness},
          {"cues",
           {{"edge_density", segment.cues.edge_density},
            {"outer_edges", segment.cues.outer_edges},
            {"straddling", segment.cues.straddling},
            {"free_space", segment.cues.free_space}}},
          {"points", segment.pixels.size()},
          {"round", segment.round},
          {"supported_by", labelOf(segment.support)},
          {"base_height", segment.support.height_m},
          {"supports", labelsOf(segment.carried)},
          {"visible_box", toJson(segment.visible_box)}};
}

Json toJson(const Unmeasured& thing) {
  Json outline = Json::array();
  for (const Eigen::Vector3d& corner : thing.outline) outline.push_back(toJson(corner));
  Json json = {{"outline", outline},
               {"points", thing.pixels},
               {"area", thing.area_m2},
               {"table_share", thing.table_share},
               {"noise_ratio", thing.noise_ratio},
               {"box", nullptr}};
  if (thing.box) json["box"] = toJson(*thing.box);
  return json;
}

Json toJson(const Report& report) {
  Json json = Json::object();
  Report::figures(report, [&](const char* name, const auto& figure) {
    if (figure) json[name] = +*figure;  // true is written as 1
  });
  Json& timings = json["timings_ms"] = Json::object();
  for (const auto& [stage, ms] : report.timings_ms) timings[stage] = std::round(ms * 1000) / 1000;
  return json;
}

}  // namespace

std::string toJson(const std::string& input, const Segmentation& result) {
  Json json;
  json["input"] = input;
  json["status"] = toString(result.status.code);
  if (!result.status.ok()) json["message"] = result.status.message;
  json["remarks"] = result.report.remarks;
  const bool has_table = result.table.d != 0;  // the camera never lies in the table's plane
  json["table"] = has_table ? toJson(result.table) : Json();
  json["objects"] = Json::array();
  for (std::size_t k = 0; k < result.segments.size(); ++k) {
    json["objects"].push_back(toJson(result.segments[k], k + kFirstObjectLabel));
  }
  json["unmeasured"] = Json::array();
  for (const Unmeasured& thing : result.unmeasured) json["unmeasured"].push_back(toJson(thing));
  json["report"] = toJson(result.report);
  // A file name need not be UTF-8: what is not is replaced.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Status writeResult(const std::string& folder, const std::string& input, const Frame& frame, const Segmentation& result,
                   bool pictures) {
  const auto file = [&](const char* name) { return (fs::path(folder) / name).string(); };
  Status status = makeFolder(folder);
  if (status.ok()) removeResult(folder);
  if (status.ok()) status = writePng(file("labels.png"), result.labels);
  if (status.ok() && pictures) status = writePng(file("overlay.png"), drawOverlay(frame, result));
  if (status.ok()) status = writeFile(file("objects.json"), toJson(input, result));
  return status;
}

void removeResult(const std::string& folder) {
  std::error_code ignored;
  for (const char* name : {"labels.png", "objects.json", "overlay.png"}) fs::remove(fs::path(folder) / name, ignored);
}

}  // namespace objectness
