// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/box_tables.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>

#include "evaluation/table_text.hpp"
#include "io/file_access.hpp"

namespace objectness::evaluation {
namespace fs = std::filesystem;
namespace {

constexpr const char* kNoGroup = "all";
constexpr double kHalf = 0.5, kMost = 0.7, kNear_mm = 10;

/// A mean of what was added, 0 of nothing.
struct Mean {
  double sum = 0;
  int count = 0;

  void add(double value) { sum += value, ++count; }
  double value() const { return count > 0 ? sum / count : 0; }
};

/// Collects the objects of one row.
struct Sums {
  Mean all, overlap, half, most, points, points_half, points_most, centre, yaw, sides[3], near;

  void add(const BoxFit& fit) {
    const BoxErrors& errors = fit.errors;
    all.add(errors.overlap);
    if (!fit.isSegmented()) return;
    overlap.add(errors.overlap);
    half.add(errors.overlap > kHalf);
    most.add(errors.overlap > kMost);
    points.add(fit.points_overlap);
    points_half.add(fit.points_overlap > kHalf);
    points_most.add(fit.points_overlap > kMost);
    centre.add(errors.centre_mm);
    if (errors.yaw_deg) yaw.add(*errors.yaw_deg);
    for (int k = 0; k < 3; ++k) sides[k].add(std::abs(errors.sides_mm[k]));
    near.add(errors.sides_mm.cwiseAbs().maxCoeff() <= kNear_mm);
  }
  Metrics columns() const {
    return {{"objects", all.count},         {"segmented", overlap.count},      {"IoU_all", all.value()},
            {"IoU", overlap.value()},       {"IoU50", half.value()},           {"IoU70", most.value()},
            {"points_IoU", points.value()}, {"points50", points_half.value()}, {"points70", points_most.value()},
            {"centre_mm", centre.value()},  {"yaw_deg", yaw.value()},          {"long_mm", sides[0].value()},
            {"short_mm", sides[1].value()}, {"height_mm", sides[2].value()},   {"sides_10mm", near.value()}};
  }
};

bool isCount(const std::string& column) { return column == "objects" || column == "segmented"; }

std::string toCsv(const std::vector<BoxRow>& rows) {
  std::ostringstream csv;
  csv << "method,by,name";
  for (const auto& column : Sums{}.columns()) csv << ',' << column.first;
  csv << '\n';
  for (const BoxRow& row : rows) {
    csv << row.method << ',' << row.by << ',' << csvCell(row.name);
    for (const auto& [name, value] : row.columns) csv << ',' << fixedText(value, isCount(name) ? 0 : 5);
    csv << '\n';
  }
  return csv.str();
}

std::string objectsCsv(const Run& run, const std::vector<SceneResult>& results) {
  std::ostringstream csv;
  csv << "method,scene,object,kind,dice,IoU,points_IoU,centre_mm,yaw_deg,long_mm,short_mm,height_mm\n";
  for (const auto& method : run.methods) {
    for (const SceneResult& result : results) {
      if (result.method != method.name) continue;
      for (const BoxFit& fit : result.box_fits) {
        const BoxErrors& errors = fit.errors;
        csv << method.name << ',' << csvCell(result.scene) << ',' << fit.object << ',' << csvCell(fit.kind) << ','
            << fixedText(fit.dice, 5) << ',' << fixedText(errors.overlap, 5) << ',' << fixedText(fit.points_overlap, 5)
            << ',' << fixedText(errors.centre_mm, 2) << ',' << (errors.yaw_deg ? fixedText(*errors.yaw_deg, 2) : "");
        for (int side = 0; side < 3; ++side) csv << ',' << fixedText(errors.sides_mm[side], 2);
        csv << '\n';
      }
    }
  }
  return csv.str();
}

}  // namespace

std::vector<BoxRow> summarizeBoxes(const Run& run, const std::vector<SceneResult>& results) {
  std::map<std::string, std::string> group_of;
  for (const auto& scene : run.scenes) group_of[scene.name] = scene.group;
  std::vector<BoxRow> rows;
  for (const auto& method : run.methods) {
    Sums all;
    std::map<std::string, Sums> of_group, of_kind;
    for (const SceneResult& result : results) {
      if (result.method != method.name) continue;
      for (const BoxFit& fit : result.box_fits) {
        const std::string& group = group_of.at(result.scene);
        all.add(fit);
        if (group != kNoGroup) of_group[group].add(fit);
        if (!fit.kind.empty()) of_kind[fit.kind].add(fit);
      }
    }
    if (all.all.count == 0) continue;
    rows.push_back({method.name, "all", "", all.columns()});
    for (const auto& [name, sums] : of_group) rows.push_back({method.name, "group", name, sums.columns()});
    for (const auto& [name, sums] : of_kind) rows.push_back({method.name, "kind", name, sums.columns()});
  }
  return rows;
}

std::string toText(const std::vector<BoxRow>& rows) {
  if (rows.empty()) return "";
  constexpr std::size_t kName = 10, kNumber = 6;
  std::ostringstream text;
  text << "\nBoxes in space (from IoU on: of the objects segmented)\n";
  for (const char* name : {"method", "by", "name"}) writeCell(text, name, kName, true);
  for (const auto& column : rows.front().columns) writeCell(text, column.first, kNumber, false);
  text << '\n';
  for (const BoxRow& row : rows) {
    for (const std::string& name : {row.method, row.by, row.name}) writeCell(text, name, kName, true);
    for (const auto& [name, value] : row.columns) {
      const bool measured = name.find("_mm") != std::string::npos || name.find("_deg") != std::string::npos;
      writeCell(text, fixedText(value, isCount(name) ? 0 : measured ? 1 : 3), std::max(kNumber, name.size()), false);
    }
    text << '\n';
  }
  return text.str();
}

Status writeBoxTables(const std::string& report, const Run& run, const std::vector<SceneResult>& results) {
  const auto file = [&](const char* name) { return (fs::path(report) / name).string(); };
  const Status status = writeFile(file("boxes.csv"), toCsv(summarizeBoxes(run, results)));
  return status.ok() ? writeFile(file("objects.csv"), objectsCsv(run, results)) : status;
}

}  // namespace objectness::evaluation
