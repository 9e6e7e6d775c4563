// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "evaluation/methods.hpp"
#include "evaluation/scene_result.hpp"
#include "evaluation/scenes.hpp"

namespace objectness::evaluation {

/// How far an experiment is; `result` is the one that has just been finished, null at the start.
struct Progress {
  int done = 0, computed = 0, total = 0;
  const SceneResult* result = nullptr;
};

/// Runs every method in every scene, each in a process of its own, `jobs` at a time. A result that is there and was
/// made from the same commit, settings and files is kept; what failed is tried again. Results by scene, then method. An
/// error: a result could not be written.
Result<std::vector<SceneResult>> runExperiment(const std::string& report, const std::vector<Scene>& scenes,
                                               const std::vector<Method>& methods, int jobs,
                                               const std::function<void(const Progress&)>& on_progress);

}  // namespace objectness::evaluation
