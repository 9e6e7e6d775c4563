// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "objectness_segmentation/common/status.hpp"

namespace objectness::evaluation {

/// A scene folder with truth: depth.png, camera.yaml, labels.png and, if there is one, color.png.
struct Scene {
  std::string name;  ///< of the folder; no two of a list share one
  std::string folder;
  std::string group = "all";
};

struct SceneList {
  std::vector<Scene> scenes;
  std::vector<std::string> notes;   ///< what was left out of a data set and why
  std::vector<std::string> errors;  ///< paths that cannot be evaluated, a sentence each
};

/// Finds the scenes of `paths`, each a scene folder or a data set: a folder of scene folders, taken in the order of
/// their names; those without labels.png are left out with a note. Groups come from `groups_file` (CSV with the columns
/// scene and group), or when it is empty from groups.csv in the data set's folder or \<data set\>_groups.csv beside it.
/// kBadInput: a groups file that cannot be read.
Result<SceneList> findScenes(const std::vector<std::string>& paths, const std::string& groups_file);

}  // namespace objectness::evaluation
