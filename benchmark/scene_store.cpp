// SPDX-License-Identifier: BSD-3-Clause
#include "scene_store.hpp"

#include <opencv2/imgcodecs.hpp>
#include <set>
#include <stdexcept>

#include "evaluation/scores.hpp"
#include "objectness_segmentation/io/scene_folder.hpp"
#include "segments/segments.hpp"

namespace objectness::benchmarks {
namespace {

using Scenes = Result<std::vector<BenchmarkScene>>;

int countObjects(const cv::Mat_<ushort>& annotation) {
  std::set<ushort> objects;
  for (const ushort label : evaluation::truthAtLevel(annotation, evaluation::Level::kObject)) {
    if (label >= kFirstObjectLabel) objects.insert(label);
  }
  return static_cast<int>(objects.size());
}

}  // namespace

Scenes findBenchmarkScenes(const std::vector<std::string>& paths) {
  const Result<evaluation::SceneList> found = evaluation::findScenes(paths, "");
  if (!found.ok()) return Scenes::error(found.status);
  if (!found.value.errors.empty()) return Scenes::error(StatusCode::kBadInput, found.value.errors.front());
  Scenes scenes;
  for (const evaluation::Scene& source : found.value.scenes) {
    const cv::Mat labels = cv::imread(source.folder + "/labels.png", cv::IMREAD_UNCHANGED);
    if (labels.type() != CV_16UC1) {
      return Scenes::error(StatusCode::kBadInput, source.folder + "/labels.png: is no 16-bit label image");
    }
    scenes.value.push_back({source, labels.cols, labels.rows, countObjects(labels)});
  }
  return scenes;
}

const Frame& frameOf(const BenchmarkScene& scene) {
  static std::string kept;
  static Frame frame;
  if (kept != scene.source.folder) {
    Result<Frame> loaded = loadSceneFolder(scene.source.folder, {}, InputConfig{});
    if (!loaded.ok()) throw std::runtime_error(scene.source.folder + ": " + loaded.status.message);
    frame = std::move(loaded.value);
    kept = scene.source.folder;
  }
  return frame;
}

}  // namespace objectness::benchmarks
