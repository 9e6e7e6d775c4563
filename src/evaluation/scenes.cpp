// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/evaluation/scenes.hpp"

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
bool hasTruth(const fs::path& folder) { return isThere(folder / "labels.png"); }

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
  explicit Finder(Groups groups, bool groups_given) : groups_(std::move(groups)), groups_given_(groups_given) {}

  Status add(const std::string& given) {
    const fs::path path = cleanPath(given);
    std::error_code ignored;
    if (!fs::is_directory(path, ignored)) {
      list_.errors.push_back(given + (isThere(path) ? ": is no folder" : ": there is no such folder"));
      return {};
    }
    if (isScene(path)) {
      if (hasTruth(path)) return addScenes({path}, path.parent_path());
      list_.errors.push_back(given + ": holds no labels.png: without truth it cannot be evaluated");
      return {};
    }
    return addDataSet(given, path);
  }

  SceneList take() { return std::move(list_); }

 private:
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
    if (!skipped.empty()) list_.notes.push_back(given + ": left out, as they have no labels.png: " + skipped);
    if (scenes.empty()) list_.errors.push_back(given + ": neither is a scene folder nor holds any with a labels.png");
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
      const auto [earlier, is_new] = folder_of_.emplace(name, folder.string());
      if (is_new) {
        const auto group = groups.find(name);
        list_.scenes.push_back({name, folder.string(), group == groups.end() ? "all" : group->second});
      } else if (earlier->second != folder.string()) {
        list_.errors.push_back(folder.string() + ": has the same name as " + earlier->second +
                               ": evaluate them apart with different --report");
      }
    }
    return {};
  }

  Groups groups_;
  bool groups_given_;
  std::map<std::string, std::string> folder_of_;
  SceneList list_;
};

}  // namespace

Result<SceneList> findScenes(const std::vector<std::string>& paths, const std::string& groups_file) {
  Groups groups;
  if (!groups_file.empty()) {
    const Result<Groups> read = readGroups(groups_file);
    if (!read.ok()) return Result<SceneList>::error(read.status);
    groups = read.value;
  }
  Finder finder(groups, !groups_file.empty());
  for (const std::string& path : paths) {
    const Status status = finder.add(path);
    if (!status.ok()) return Result<SceneList>::error(status);
  }
  return {{}, finder.take()};
}

}  // namespace objectness::evaluation
