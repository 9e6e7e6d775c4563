// SPDX-License-Identifier: BSD-3-Clause
// Measures methods on scenes with known truth: see `evaluate --help`.
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <opencv2/core/utils/logger.hpp>

#include "common/frame_memory.hpp"
#include "evaluation/box_tables.hpp"
#include "evaluation/camera_tables.hpp"
#include "evaluation/commit.hpp"
#include "evaluation/experiment.hpp"
#include "evaluation/machine.hpp"
#include "evaluation/merge.hpp"
#include "evaluation/run.hpp"
#include "evaluation/stability.hpp"
#include "evaluation/tables.hpp"
#include "tools/evaluate_options.hpp"
#include "tools/evaluate_progress.hpp"

namespace {

using namespace objectness;
using namespace objectness::evaluation;
namespace fs = std::filesystem;

enum ExitStatus { kAllDone = 0, kSomeFailed = 1, kUsageError = 2 };

constexpr std::size_t kMostBefore = 40;  // frames that are gone through for the one that is scored

ExitStatus fail(const std::string& message) {
  printLine(message);
  return kSomeFailed;
}

/// Empty when files can be written into the folder, which is made.
std::string folderProblem(const std::string& folder) {
  std::error_code error, ignored;
  fs::create_directories(folder, error);
  if (fs::is_directory(folder, ignored) && access(folder.c_str(), W_OK | X_OK) == 0) return "";
  return error ? error.message() : fs::is_directory(folder, ignored) ? "no permission to write" : "it is a file";
}

/// Draws the plots and writes report.html with the Python script beside this program. What it lacks is no reason to
/// lose the tables: a warning, then.
void writePictures(const std::string& report) {
  std::error_code error;
  const fs::path script = fs::read_symlink("/proc/self/exe", error).parent_path() / "evaluation_report.py";
  fs::remove(fs::path(report) / "report.html", error);
  // The system's Python knows Debian's packages; the first one in PATH may be a bare one.
  const char* python = access("/usr/bin/python3", X_OK) == 0 ? "/usr/bin/python3" : "python3";
  const pid_t pid = fork();
  if (pid == 0) {
    execlp(python, python, script.c_str(), report.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  int status = 0;
  if (pid > 0 && waitpid(pid, &status, 0) == pid && WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  printLine(
      "warning: no plots and no report.html, summary.json and scenes.csv are complete. They need python3 with "
      "matplotlib (apt-get install python3-matplotlib); then run " +
      script.string() + " " + report);
}

/// Everything that is made from the results.
ExitStatus writeReport(const std::string& report, const Run& run, const std::vector<SceneResult>& results) {
  Status status = saveRun(report, run);
  if (status.ok()) status = writeTables(report, run, results);
  if (status.ok()) status = writeCameraTables(report, run, results);
  if (status.ok()) status = writeBoxTables(report, run, results);
  if (!status.ok()) return fail(status.message);
  const std::vector<SummaryRow> rows = summarize(run, results);
  const std::vector<CameraRow> cameras = summarizeCameras(run, results);
  Result<std::vector<StabilityRow>> stability;
  if (run.still) stability = summarizeStability(report, run, results);
  if (stability.ok() && run.still) stability.status = writeStability(report, stability.value);
  if (!stability.ok()) return fail(stability.status.message);
  std::cout << toText(rows) << toText(cameras) << toText(summarizeBoxes(run, results)) << toText(stability.value)
            << std::flush;
  writePictures(report);
  std::error_code ignored;
  const char* file = fs::exists(fs::path(report) / "report.html", ignored) ? "report.html" : "summary.json";
  std::cout << "Report: " << (fs::path(report) / file).string() << std::endl;
  const bool scored =
      !stability.value.empty() || std::any_of(results.begin(), results.end(), [](const SceneResult& result) {
        return result.object || result.part || result.picture_boxes;
      });
  const bool complete =
      scored && std::all_of(results.begin(), results.end(), [](const SceneResult& result) {
        return result.state == SceneResult::State::kDone || result.state == SceneResult::State::kNotApplicable;
      });
  return complete ? kAllDone : kSomeFailed;
}

std::vector<Scene> ofShard(const std::vector<Scene>& scenes, int shard, int shards) {
  std::vector<Scene> chosen;
  for (std::size_t i = static_cast<std::size_t>(shard) - 1; i < scenes.size(); i += static_cast<std::size_t>(shards)) {
    chosen.push_back(scenes[i]);
  }
  return chosen;
}

/// Scenes in the order of their names.
void followFrames(int fuse_frames, std::vector<Scene>& scenes, std::vector<Method>& methods) {
  std::map<std::string, std::vector<std::string>> before;
  for (Scene& scene : scenes) {
    std::vector<std::string>& folders = before[scene.camera];
    scene.before = folders;
    folders.push_back(scene.folder);
    if (folders.size() > kMostBefore) folders.erase(folders.begin());
  }
  for (Method& method : methods) {
    method.fuse_frames = fuse_frames;
    method.settings += "\nframes follow one another, fused: " + std::to_string(fuse_frames) + "\n";
  }
}

ExitStatus evaluate(const EvaluateOptions& options) {
  SceneRules rules;
  rules.boxes_are_truth = rules.same_names = true;
  rules.needs_truth = !options.still;
  const Result<SceneList> list = findScenes(options.inputs, options.groups_file, rules);
  if (!list.ok()) return fail(list.status.message);
  for (const std::string& note : list.value.notes) printLine(note);
  for (const std::string& error : list.value.errors) printLine(error);
  std::vector<Scene> scenes = list.value.scenes;
  if (scenes.empty())
    return fail("no scenes to evaluate: name scene folders with labels.png or objects.yaml, or folders of such");
  std::sort(scenes.begin(), scenes.end(), [](const Scene& a, const Scene& b) { return a.name < b.name; });
  scenes = ofShard(scenes, options.shard, options.shards);

  Result<std::vector<Method>> methods = makeMethods(options.methods, options.config, options.model);
  if (!methods.ok()) return fail(methods.status.message);
  if (options.fuse_frames > 0) followFrames(options.fuse_frames, scenes, methods.value);
  Run run{commit(), {describeMachine()}, options.jobs, options.shard, options.shards, options.levels, {}, {}};
  run.still = options.still;
  for (const Method& m : methods.value) run.methods.push_back({m.name, m.description, m.settings});
  for (const Scene& scene : scenes) run.scenes.push_back({scene.name, scene.group, scene.camera});

  Result<std::vector<SceneResult>> results;
  {
    ProgressDisplay display;
    results = runExperiment(options.report, scenes, methods.value, options.jobs,
                            [&](const Progress& progress) { display.show(progress); });
  }
  if (!results.ok()) return fail("cannot write to --report " + options.report + ": " + results.status.message);
  const ExitStatus written = writeReport(options.report, run, results.value);
  // A shard without scenes is one of a set smaller than the number of shards.
  const bool nothing_to_do = scenes.empty() && options.shards > 1;
  return !list.value.errors.empty() ? kSomeFailed : nothing_to_do ? kAllDone : written;
}

ExitStatus merge(const EvaluateOptions& options) {
  const Result<Run> run = mergeShards(options.report, options.inputs);
  if (!run.ok()) return fail(run.status.message);
  std::vector<SceneResult> results;
  for (const auto& scene : run.value.scenes) {
    for (const auto& method : run.value.methods) {
      Result<SceneResult> result = loadResult(options.report, method.name, scene.name);
      if (!result.ok()) return fail(result.status.message);
      results.push_back(std::move(result.value));
    }
  }
  return writeReport(options.report, run.value, results);
}

}  // namespace

int main(int argc, char** argv) {
  // Every problem is reported once, in our words.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  const Result<EvaluateOptions> parsed = parseEvaluateOptions(argc, argv);
  if (!parsed.ok()) {
    printLine(parsed.status.message + " (evaluate --help)");
    return kUsageError;
  }
  const EvaluateOptions& options = parsed.value;
  if (!options.print.empty()) {
    std::cout << options.print << std::flush;
    return std::cout ? kAllDone : kSomeFailed;
  }
  keepFrameMemory();  // for all processes that run a scene
  const std::string problem = folderProblem(options.report);
  if (!problem.empty()) return fail("--report " + options.report + ": cannot write there: " + problem);
  try {
    return options.merge ? merge(options) : evaluate(options);
  } catch (const std::exception& e) {
    return fail(e.what());
  }
}
