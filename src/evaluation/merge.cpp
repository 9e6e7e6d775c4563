// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/merge.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

#include "io/file_access.hpp"

namespace objectness::evaluation {
namespace fs = std::filesystem;
namespace {

/// Empty when a shard belongs to the same run as the first one.
std::string misfit(const Run& first, const Run& other) {
  if (other.commit != first.commit) return "is of commit " + other.commit + ", not " + first.commit;
  if (other.shards != first.shards) {
    return "is one of " + std::to_string(other.shards) + " shards, not of " + std::to_string(first.shards);
  }
  if (other.methods != first.methods) return "was computed with other methods or settings";
  if (other.levels != first.levels) return "has other levels";
  return "";
}

/// The first run with the scenes of all.
Result<Run> joinRuns(const std::vector<std::string>& folders, const std::vector<Run>& runs) {
  const auto bad = [](const std::string& message) { return Result<Run>::error(StatusCode::kBadInput, message); };
  Result<Run> all;
  all.value = runs.front();
  Run& joined = all.value;
  joined.scenes.clear();
  std::map<int, std::string> folder_of_shard;
  std::map<std::string, std::string> folder_of_scene;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::string problem = misfit(runs.front(), runs[i]);
    if (!problem.empty()) return bad(folders[i] + ": does not fit to " + folders.front() + ": it " + problem);
    const auto [same, is_new] = folder_of_shard.emplace(runs[i].shard, folders[i]);
    const std::string shard = std::to_string(runs[i].shard) + "/" + std::to_string(runs[i].shards);
    if (!is_new) return bad(folders[i] + ": is shard " + shard + ", as " + same->second + " is");
    for (const Run::SceneInfo& scene : runs[i].scenes) {
      const auto [holder, first] = folder_of_scene.emplace(scene.name, folders[i]);
      if (!first) return bad(folders[i] + ": holds scene " + scene.name + ", as " + holder->second + " does");
      joined.scenes.push_back(scene);
    }
    for (const std::string& machine : runs[i].machines) {
      const auto& known = joined.machines;
      if (std::find(known.begin(), known.end(), machine) == known.end()) joined.machines.push_back(machine);
    }
    joined.jobs = std::max(joined.jobs, runs[i].jobs);
  }
  for (int shard = 1; shard <= joined.shards; ++shard) {
    if (folder_of_shard.count(shard)) continue;
    return bad("shard " + std::to_string(shard) + "/" + std::to_string(joined.shards) + " is missing");
  }
  joined.shard = joined.shards = 1;
  std::sort(joined.scenes.begin(), joined.scenes.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return all;
}

}  // namespace

Result<Run> mergeShards(const std::string& report, const std::vector<std::string>& shards) {
  std::vector<Run> runs;
  for (const std::string& shard : shards) {
    Result<Run> run = loadRun(shard);
    if (!run.ok()) return run;
    runs.push_back(std::move(run.value));
  }
  if (runs.empty()) return Result<Run>::error(StatusCode::kBadInput, "no folder of a shard to merge");
  Result<Run> joined = joinRuns(shards, runs);
  if (!joined.ok()) return joined;
  for (const std::string& shard : shards) {
    std::error_code error;
    if (fs::equivalent(shard, report, error)) continue;
    for (const char* part : {"results", "truth"}) {
      if (!fs::exists(fs::path(shard) / part, error)) continue;
      fs::copy(fs::path(shard) / part, fs::path(report) / part,
               fs::copy_options::recursive | fs::copy_options::overwrite_existing, error);
      if (error) {
        return Result<Run>::error(StatusCode::kBadInput,
                                  "cannot copy the results of " + shard + " to " + report + ": " + error.message());
      }
    }
  }
  return joined;
}

}  // namespace objectness::evaluation
