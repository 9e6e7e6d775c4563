// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "objectness_segmentation/common/status.hpp"

namespace objectness::evaluation {

/// A scene folder with truth: depth.png, camera.yaml, labels.png or objects.yaml and, if there is one, color.png.
struct Scene {
  std::string name;  ///< of the folder, after that of the data set where needed; no two of a list share one
  std::string folder;
  std::string group = "all";
  std::string camera = {};               ///< name of the data set, the folder of the scene folder
  bool needs_truth = true;               ///< off: it is evaluated without any, too
  std::vector<std::string> before = {};  ///< folders of the frames before it in its sequence, in their order
};

/// What findScenes() accepts.
struct SceneRules {
  bool boxes_are_truth = false;  ///< objects.yaml is truth enough, labels.png need not be there
  /// Scenes of one name in different data sets are all called DATA_SET/NAME; off: all but the first are errors.
  bool same_names = false;
  bool needs_truth = true;  ///< off: scenes without truth are taken, too
};

struct SceneList {
  std::vector<Scene> scenes;
  std::vector<std::string> notes;   ///< what was left out of a data set and why
  std::vector<std::string> errors;  ///< paths that cannot be evaluated, a sentence each
};

/// Finds the scenes of `paths`, each a scene folder or a data set: a folder of scene folders, taken in the order of
/// their names; those without truth are left out with a note. Groups come from `groups_file` (CSV with the columns
/// scene and group), or when it is empty from groups.csv in the data set's folder or \<data set\>_groups.csv beside it.
/// kBadInput: a groups file that cannot be read.
Result<SceneList> findScenes(const std::vector<std::string>& paths, const std::string& groups_file,
                             const SceneRules& rules = {});

}  // namespace objectness::evaluation
