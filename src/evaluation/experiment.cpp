// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/experiment.hpp"

#include <filesystem>

#include "evaluation/commit.hpp"
#include "evaluation/processes.hpp"
#include "evaluation/run.hpp"
#include "evaluation/scene_job.hpp"

namespace objectness::evaluation {
namespace fs = std::filesystem;
namespace {

struct Task {
  const Scene* scene;
  const Method* method;
  std::string made_from;
  std::string failure;  ///< of the process that tried it
};

bool isFinished(const std::string& report, const Task& task, const SceneResult& result) {
  std::error_code ignored;
  if (result.state == SceneResult::State::kNotApplicable) return result.made_from == task.made_from;
  return result.state == SceneResult::State::kDone && result.made_from == task.made_from &&
         fs::exists(fs::path(resultPath(report, result.method, result.scene)) / "labels.png", ignored);
}

void throwOnError(const Status& status) {
  if (!status.ok()) throw std::runtime_error(status.message);
}

}  // namespace

Result<std::vector<SceneResult>> runExperiment(const std::string& report, const std::vector<Scene>& scenes,
                                               const std::vector<Method>& methods, int jobs,
                                               const std::function<void(const Progress&)>& on_progress) {
  std::vector<SceneResult> results(scenes.size() * methods.size());
  std::vector<Task> tasks;
  std::vector<std::size_t> unfinished;
  for (const Scene& scene : scenes) {
    for (const Method& method : methods) {
      tasks.push_back({&scene, &method, madeFrom(commit(), method, scene), ""});
      const std::size_t index = tasks.size() - 1;
      Result<SceneResult> earlier = loadResult(report, method.name, scene.name);
      if (earlier.ok() && isFinished(report, tasks.back(), earlier.value)) {
        results[index] = std::move(earlier.value);
      } else {
        std::error_code ignored;
        fs::remove(resultPath(report, method.name, scene.name) + ".json", ignored);
        unfinished.push_back(index);
      }
    }
  }

  Progress progress;
  progress.total = static_cast<int>(tasks.size());
  progress.done = progress.total - static_cast<int>(unfinished.size());
  on_progress(progress);
  Status status;
  const auto collect = [&](std::size_t index) {
    Result<SceneResult> result = loadResult(report, tasks[index].method->name, tasks[index].scene->name);
    if (!result.ok()) status = result.status;
    results[index] = std::move(result.value);
    ++progress.done;
    ++progress.computed;
    progress.result = &results[index];
    if (result.ok()) on_progress(progress);
  };

  std::vector<std::size_t> died;
  forEachInProcess(
      static_cast<int>(unfinished.size()), jobs,
      [&](int i) {
        const Task& task = tasks[unfinished[i]];
        throwOnError(evaluateScene(report, *task.scene, *task.method, task.made_from));
      },
      [&](int i, const std::string& failure) {
        tasks[unfinished[i]].failure = failure;
        if (failure.empty()) {
          collect(unfinished[i]);
        } else {
          died.push_back(unfinished[i]);
        }
      });
  forEachInProcess(
      static_cast<int>(died.size()), jobs,
      [&](int i) {
        const Task& task = tasks[died[i]];
        throwOnError(recordFailure(report, *task.scene, *task.method, task.made_from, task.failure));
      },
      [&](int i, const std::string&) { collect(died[i]); });
  if (!status.ok()) return Result<std::vector<SceneResult>>::error(status);
  return {{}, results};
}

}  // namespace objectness::evaluation
