// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/scenes.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>

#include "io/file_access.hpp"
#include "objectness_segmentation/io/input_file.hpp"

namespace objectness::evaluation {
namespace fs = std::filesystem;
namespace {

using Groups = std::map<std::string, std::string>;  // by scene

bool isThere(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

bool isScene(const fs::path& folder) { return isThere(folder / "depth.png") || isThere(folder / "labels.png"); }

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) {
    cell.erase(std::remove_if(cell.begin(), cell.end(), [](char c) { return c == '\r' || c == '"'; }), cell.end());
    cells.push_back(cell);
  }
  return cells;
}

Result<Groups> readGroups(const std::string& path) {
  const Result<std::string> text = readFile(path, 64 * kMaxTextBytes);
  if (!text.ok()) return Result<Groups>::error(about(path, text.status));
  std::istringstream lines(text.value);
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> header = cells(line);
  const auto column = [&](const char* name) {
    return static_cast<std::size_t>(std::find(header.begin(), header.end(), name) - header.begin());
  };
  const std::size_t scene = column("scene"), group = column("group");
  if (scene == header.size() || group == header.size()) {
    return Result<Groups>::error(StatusCode::kBadInput,
                                 path + ": its first line must name the columns scene and group");
  }
  Result<Groups> groups;
  while (std::getline(lines, line)) {
    const std::vector<std::string> row = cells(line);
    if (row.size() > std::max(scene, group)) groups.value[row[scene]] = row[group];
  }
  return groups;
}

/// The groups file that belongs to a data set, or "".
std::string groupsFileOf(const fs::path& data_set) {
  const fs::path inside = data_set / "groups.csv",
                 beside = data_set.parent_path() / (inputName(data_set.string()) + "_groups.csv");
  return isThere(inside) ? inside.string() : isThere(beside) ? beside.string() : "";
}

/// The path without what depends on the current folder or ends in a slash.
fs::path cleanPath(const std::string& path) {
  std::error_code ignored;
  const fs::path full = fs::absolute(path, ignored).lexically_normal();
  return full.has_filename() ? full : full.parent_path();
}

class Finder {
 public:
  Finder(Groups groups, bool groups_given, const SceneRules& rules)
      : groups_(std::move(groups)), groups_given_(groups_given), rules_(rules) {}

  Status add(const std::string& given) {
    const fs::path path = cleanPath(given);
    std::error_code ignored;
    if (!fs::is_directory(path, ignored)) {
      list_.errors.push_back(given + (isThere(path) ? ": is no folder" : ": there is no such folder"));
      return {};
    }
    if (isScene(path)) {
      if (hasTruth(path)) return addScenes({path}, path.parent_path());
      list_.errors.push_back(given + ": holds " + lacking() + ": without truth it cannot be evaluated");
      return {};
    }
    return addDataSet(given, path);
  }

  SceneList take() {
    if (!rules_.same_names) return std::move(list_);
    std::map<std::string, int> uses;
    for (const Scene& scene : list_.scenes) ++uses[scene.name];
    std::map<std::string, std::string> folder_of;
    std::vector<Scene> named;
    for (Scene& scene : list_.scenes) {
      if (uses[scene.name] > 1) scene.name = scene.camera + "/" + scene.name;
      const auto [earlier, is_new] = folder_of.emplace(scene.name, scene.folder);
      if (is_new) {
        named.push_back(std::move(scene));
      } else {
        addClash(scene.folder, earlier->second);
      }
    }
    list_.scenes = std::move(named);
    return std::move(list_);
  }

 private:
  bool hasTruth(const fs::path& folder) const {
    if (!rules_.needs_truth) return true;
    return isThere(folder / "labels.png") || (rules_.boxes_are_truth && isThere(folder / "objects.yaml"));
  }

  std::string lacking() const { return rules_.boxes_are_truth ? "no labels.png and no objects.yaml" : "no labels.png"; }

  void addClash(const std::string& folder, const std::string& earlier) {
    list_.errors.push_back(folder + ": has the same name as " + earlier +
                           ": evaluate them apart with different --report");
  }

  Status addDataSet(const std::string& given, const fs::path& path) {
    std::vector<fs::path> scenes;
    std::string skipped;
    std::error_code error;
    std::vector<fs::path> folders;
    for (fs::directory_iterator entry(path, error), end; !error && entry != end; entry.increment(error)) {
      folders.push_back(entry->path());
    }
    std::sort(folders.begin(), folders.end());
    for (const fs::path& folder : folders) {
      if (!isScene(folder)) continue;
      if (hasTruth(folder)) {
        scenes.push_back(folder);
      } else {
        skipped += (skipped.empty() ? "" : ", ") + folder.filename().string();
      }
    }
    if (!skipped.empty()) list_.notes.push_back(given + ": left out, as they have " + lacking() + ": " + skipped);
    if (scenes.empty()) {
      list_.errors.push_back(given + ": neither is a scene folder nor holds any with a labels.png" +
                             (rules_.boxes_are_truth ? " or objects.yaml" : ""));
    }
    return addScenes(scenes, path);
  }

  Status addScenes(const std::vector<fs::path>& folders, const fs::path& data_set) {
    const std::string file = groups_given_ ? "" : groupsFileOf(data_set);
    Groups own;
    if (!file.empty()) {
      const Result<Groups> read = readGroups(file);
      if (!read.ok()) return read.status;
      own = read.value;
    }
    const Groups& groups = groups_given_ ? groups_ : own;
    for (const fs::path& folder : folders) {
      const std::string name = folder.filename().string();
      // With same_names only a folder given twice is the same scene.
      const auto [earlier, is_new] = folder_of_.emplace(rules_.same_names ? folder.string() : name, folder.string());
      if (is_new) {
        const auto group = groups.find(name);
        list_.scenes.push_back({name, folder.string(), group == groups.end() ? "all" : group->second,
                                folder.parent_path().filename().string(), rules_.needs_truth});
      } else if (earlier->second != folder.string()) {
        addClash(folder.string(), earlier->second);
      }
    }
    return {};
  }

  Groups groups_;
  bool groups_given_;
  SceneRules rules_;
  std::map<std::string, std::string> folder_of_;
  SceneList list_;
};

}  // namespace

Result<SceneList> findScenes(const std::vector<std::string>& paths, const std::string& groups_file,
                             const SceneRules& rules) {
  Groups groups;
  if (!groups_file.empty()) {
    const Result<Groups> read = readGroups(groups_file);
    if (!read.ok()) return Result<SceneList>::error(read.status);
    groups = read.value;
  }
  Finder finder(groups, !groups_file.empty(), rules);
  for (const std::string& path : paths) {
    const Status status = finder.add(path);
    if (!status.ok()) return Result<SceneList>::error(status);
  }
  return {{}, finder.take()};
}

}  // namespace objectness::evaluation
