// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/camera_tables.hpp"

#include <filesystem>
#include <map>
#include <sstream>

#include "evaluation/table_text.hpp"
#include "io/file_access.hpp"

namespace objectness::evaluation {
namespace fs = std::filesystem;
namespace {

constexpr const char* kNoGroup = "all";
constexpr const char* kLabelColumns[] = {"P", "R", "OvF", "BdF", "F75", "extra"};
constexpr const char* kBoxColumns[] = {"objects", "found", "tight", "merged", "segments", "stray"};

bool isScored(const SceneResult& result) { return result.object || result.picture_boxes; }

/// Collects the scenes of one row.
struct Sums {
  int scenes = 0;
  MeanScores labels;
  std::optional<PictureBoxCounts> boxes;
  std::vector<double> ms;

  void add(const SceneResult& result) {
    ++scenes;
    if (result.object) labels.add(*result.object);
    if (result.picture_boxes) {
      if (!boxes) boxes = PictureBoxCounts{};
      std::vector<int> more;
      PictureBoxCounts::fields(*result.picture_boxes, [&](const char*, int value) { more.push_back(value); });
      auto next = more.begin();
      PictureBoxCounts::fields(*boxes, [&](const char*, int& value) { value += *next++; });
    }
    if (const auto total = result.totalMs()) ms.push_back(*total);
  }
  CameraRow row(const std::string& method, const std::string& camera, const std::string& group) const {
    CameraRow row{method, camera, group, scenes, {}, labels.count(), boxes, ms.empty() ? 0 : median(ms)};
    if (labels.count() > 0) row.labels = labels.mean();
    return row;
  }
};

/// The value of a column as text, "" where it does not apply.
std::string cell(const CameraRow& row, const std::string& column, int digits) {
  std::string text;
  if (row.labels) {
    Scores::fields(*row.labels, [&](const char* name, double value) {
      if (name == column) text = fixedText(value, digits);
    });
  }
  if (row.boxes) {
    PictureBoxCounts::fields(*row.boxes, [&](const char* name, int value) {
      if (name == column) text = std::to_string(value);
    });
  }
  return text;
}

std::string toCsv(const std::vector<CameraRow>& rows) {
  std::ostringstream csv;
  csv << "method,camera,group,scenes,labelled";
  for (const char* column : kLabelColumns) csv << ',' << column;
  for (const char* column : kBoxColumns) csv << ',' << column;
  csv << ",ms\n";
  for (const CameraRow& row : rows) {
    csv << row.method << ',' << csvCell(row.camera) << ',' << csvCell(row.group) << ',' << row.scenes << ','
        << row.labelled;
    for (const char* column : kLabelColumns) csv << ',' << cell(row, column, 5);
    for (const char* column : kBoxColumns) csv << ',' << cell(row, column, 0);
    csv << ',' << fixedText(row.ms, 1) << '\n';
  }
  return csv.str();
}

std::string boxesCsv(const Run& run, const std::vector<SceneResult>& results) {
  std::ostringstream csv;
  csv << "method,scene";
  for (const char* column : kBoxColumns) csv << ',' << column;
  csv << '\n';
  for (const auto& method : run.methods) {
    for (const SceneResult& result : results) {
      if (result.method != method.name || !result.picture_boxes) continue;
      csv << method.name << ',' << csvCell(result.scene);
      PictureBoxCounts::fields(*result.picture_boxes, [&](const char*, int value) { csv << ',' << value; });
      csv << '\n';
    }
  }
  return csv.str();
}

}  // namespace

std::vector<CameraRow> summarizeCameras(const Run& run, const std::vector<SceneResult>& results) {
  std::map<std::string, const Run::SceneInfo*> info_of;
  for (const auto& scene : run.scenes) info_of[scene.name] = &scene;
  std::vector<CameraRow> rows;
  for (const auto& method : run.methods) {
    std::map<std::string, Sums> of_camera;
    std::map<std::string, std::map<std::string, Sums>> of_group;  // by camera
    for (const SceneResult& result : results) {
      if (result.method != method.name || !isScored(result)) continue;
      const Run::SceneInfo& info = *info_of.at(result.scene);
      of_camera[info.camera].add(result);
      if (info.group != kNoGroup) of_group[info.camera][info.group].add(result);
    }
    for (const auto& [camera, sums] : of_camera) {
      for (const auto& [group, part] : of_group[camera]) rows.push_back(part.row(method.name, camera, group));
      rows.push_back(sums.row(method.name, camera, ""));
    }
  }
  return rows;
}

std::string toText(const std::vector<CameraRow>& rows) {
  if (rows.empty()) return "";
  constexpr std::size_t kName = 10, kCamera = 18, kNumber = 6, kCount = 8;
  std::ostringstream text;
  text << "\nBy camera (boxes in the picture: sums over scenes)\n";
  writeCell(text, "method", kName, true);
  writeCell(text, "camera", kCamera, true);
  writeCell(text, "scenes", kNumber, false);
  for (const char* column : kLabelColumns) writeCell(text, column, kNumber, false);
  for (const char* column : kBoxColumns) writeCell(text, column, kCount, false);
  writeCell(text, "ms", kNumber, false);
  text << '\n';
  for (const CameraRow& row : rows) {
    writeCell(text, row.method, kName, true);
    writeCell(text, row.group.empty() ? row.camera : "  " + row.group, kCamera, true);
    writeCell(text, std::to_string(row.scenes), kNumber, false);
    for (const char* column : kLabelColumns) writeCell(text, cell(row, column, 3), kNumber, false);
    for (const char* column : kBoxColumns) writeCell(text, cell(row, column, 0), kCount, false);
    writeCell(text, fixedText(row.ms, 1), kNumber, false);
    text << '\n';
  }
  return text.str();
}

Status writeCameraTables(const std::string& report, const Run& run, const std::vector<SceneResult>& results) {
  const auto file = [&](const char* name) { return (fs::path(report) / name).string(); };
  const Status status = writeFile(file("cameras.csv"), toCsv(summarizeCameras(run, results)));
  return status.ok() ? writeFile(file("picture_boxes.csv"), boxesCsv(run, results)) : status;
}

}  // namespace objectness::evaluation
