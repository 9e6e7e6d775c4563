// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "evaluation/scores.hpp"
#include "objectness_segmentation/common/status.hpp"

namespace objectness::evaluation {

/// What a report is about; kept as run.json in its folder, beside the results.
struct Run {
  struct MethodInfo {
    std::string name, description, settings;
    bool operator==(const MethodInfo& other) const { return name == other.name && settings == other.settings; }
  };
  struct SceneInfo {
    std::string name, group;
    std::string camera = {};  ///< Scene::camera
  };

  std::string commit;
  std::vector<std::string> machines;  ///< more than one after a merge
  int jobs = 1;                       ///< processes at a time: times are comparable when it is 1
  int shard = 1, shards = 1;          ///< this is part `shard` (1..shards) of a split data set
  std::vector<Level> levels;
  std::vector<MethodInfo> methods;
  std::vector<SceneInfo> scenes;  ///< of this shard, in the order of their names
  bool still = false;             ///< data sets are sequences of frames of a still scene
};

Status saveRun(const std::string& report, const Run& run);

/// kBadInput when the folder holds no report.
Result<Run> loadRun(const std::string& report);

}  // namespace objectness::evaluation
