// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/tables.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "evaluation/table_text.hpp"
#include "io/file_access.hpp"

namespace objectness::evaluation {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kAllGroups = "ALL";
constexpr const char* kNoGroup = "all";

std::map<std::string, std::string> groupsOf(const Run& run) {
  std::map<std::string, std::string> groups;
  for (const auto& scene : run.scenes) groups[scene.name] = scene.group;
  return groups;
}

/// Collects the scenes of one row.
struct Sums {
  MeanScores scores;
  std::vector<double> ms;
  double peak_mib = 0;
  std::vector<Metrics> proposals, gaps;

  void add(const SceneResult& result, Level level) {
    scores.add(*result.scores(level));
    if (const auto total = result.totalMs()) ms.push_back(*total);
    peak_mib = std::max(peak_mib, result.peak_mib);
    if (level != Level::kObject) return;
    proposals.push_back(result.proposals);
    gaps.push_back(result.gaps);
  }
  Metrics columns() const {
    Metrics columns{{"scenes", scores.count()}};
    const Scores means = scores.mean();
    Scores::fields(means, [&](const char* name, double mean) { columns.emplace_back(name, mean); });
    columns.emplace_back("ms", ms.empty() ? 0 : median(ms));
    columns.emplace_back("peak_mib", peak_mib);
    return columns;
  }
  SummaryRow row(const std::string& method, Level level, const std::string& group) const {
    return {method, toString(level), group, columns(), poolProposals(proposals), poolGaps(gaps)};
  }
};

std::string toCsv(const Run& run, const std::vector<SceneResult>& results) {
  const auto groups = groupsOf(run);
  std::ostringstream csv;
  const Scores none;
  csv << "method,level,scene,group,state";
  Scores::fields(none, [&](const char* name, double) { csv << ',' << name; });
  csv << ",segments,ms,peak_mib";
  const Metrics proposals = toMetrics(ProposalMetrics{});
  for (const auto& column : proposals) csv << ',' << column.first;
  csv << '\n';
  for (const auto& method : run.methods) {
    for (const Level level : run.levels) {
      for (const SceneResult& result : results) {
        if (result.method != method.name || !result.scores(level)) continue;
        csv << method.name << ',' << toString(level) << ',' << csvCell(result.scene) << ','
            << csvCell(groups.at(result.scene)) << ',' << (result.problem.empty() ? "done" : "failed");
        Scores::fields(*result.scores(level), [&](const char*, double value) { csv << ',' << fixedText(value, 5); });
        csv << ',' << result.segments << ',' << fixedText(result.totalMs().value_or(0), 1) << ','
            << fixedText(result.peak_mib, 1);
        const bool has_proposals = level == Level::kObject && !result.proposals.empty();
        for (const auto& column : has_proposals ? result.proposals : proposals) {
          csv << ',' << (has_proposals ? fixedText(column.second, 5) : "");
        }
        csv << '\n';
      }
    }
  }
  return csv.str();
}

}  // namespace

std::vector<SummaryRow> summarize(const Run& run, const std::vector<SceneResult>& results) {
  const auto groups = groupsOf(run);
  std::vector<SummaryRow> rows;
  for (const auto& method : run.methods) {
    for (const Level level : run.levels) {
      std::map<std::string, Sums> of_group;
      Sums of_all;
      for (const SceneResult& result : results) {
        if (result.method != method.name || !result.scores(level)) continue;
        const std::string& group = groups.at(result.scene);
        if (group != kNoGroup) of_group[group].add(result, level);
        of_all.add(result, level);
      }
      for (const auto& [group, sums] : of_group) rows.push_back(sums.row(method.name, level, group));
      if (of_all.scores.count() > 0) rows.push_back(of_all.row(method.name, level, kAllGroups));
    }
  }
  return rows;
}

std::string toText(const std::vector<SummaryRow>& rows) {
  if (rows.empty()) return "";
  std::ostringstream text;
  const auto pad = [&](const std::string& cell, std::size_t width, bool left) { writeCell(text, cell, width, left); };
  constexpr std::size_t kName = 10, kNumber = 6;
  for (const char* name : {"method", "level", "group"}) pad(name, kName, true);
  for (const auto& column : rows.front().columns) pad(column.first, kNumber, false);
  text << '\n';
  for (const SummaryRow& row : rows) {
    for (const std::string& name : {row.method, row.level, row.group}) pad(name, kName, true);
    for (const auto& [name, value] : row.columns) {
      pad(fixedText(value, name == "scenes" || name == "ms" || name == "peak_mib" ? 0 : 3),
          std::max(kNumber, name.size()), false);
    }
    text << '\n';
  }
  for (const SummaryRow& row : rows) {
    if (row.group != kAllGroups || row.gaps.empty()) continue;
    text << row.method << ", short of the best choice at most:";
    for (const auto& [name, value] : row.gaps) text << ' ' << name << ' ' << fixedText(value, 5);
    text << '\n';
  }
  return text.str();
}

Status writeTables(const std::string& report, const Run& run, const std::vector<SceneResult>& results) {
  Json summary = Json::object();
  for (const SummaryRow& row : summarize(run, results)) {
    Json& columns = summary[row.method][row.level][row.group];
    for (const auto& [name, value] : row.columns) columns[name] = name == "scenes" ? Json(int(value)) : Json(value);
    for (const auto& [name, value] : row.proposals) columns[name] = value;
    for (const auto& [name, value] : row.gaps) columns[name] = value;
  }
  const auto file = [&](const char* name) { return (fs::path(report) / name).string(); };
  const Status status = writeFile(file("scenes.csv"), toCsv(run, results));
  if (!status.ok()) return status;
  return writeFile(file("summary.json"), summary.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace objectness::evaluation
