// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/io/scene_folder.hpp"

#include <filesystem>

#include "file_access.hpp"
#include "objectness_segmentation/io/camera_yaml.hpp"
#include "png_file.hpp"

namespace objectness {
namespace fs = std::filesystem;

Result<Frame> loadSceneFolder(const std::string& folder, const std::optional<PinholeCamera>& fallback,
                              const InputConfig& config) {
  const auto file = [&](const char* name) { return (fs::path(folder) / name).string(); };
  std::error_code ignored;
  if (!fs::exists(file("depth.png"), ignored)) {
    return Result<Frame>::error(
        StatusCode::kBadInput, "holds no depth.png: a scene folder has depth.png (16-bit millimetres) and camera.yaml");
  }
  const Result<cv::Mat> depth = readPng(file("depth.png"), PngKind::kDepth);
  if (!depth.ok()) return Result<Frame>::error(about("depth.png", depth.status));

  cv::Mat color;
  if (fs::exists(file("color.png"), ignored)) {
    const Result<cv::Mat> read = readPng(file("color.png"), PngKind::kColor);
    if (!read.ok()) return Result<Frame>::error(about("color.png", read.status));
    color = read.value;
  }

  Result<PinholeCamera> camera;
  if (fallback && !fs::exists(file("camera.yaml"), ignored)) {
    camera.value = *fallback;
  } else {
    camera = loadCamera(file("camera.yaml"));
  }
  if (!camera.ok()) return Result<Frame>::error(about("camera.yaml", camera.status));
  return makeFrame(depth.value, color, camera.value, config);
}

Status saveSceneFolder(const std::string& folder, const SceneImages& scene) {
  const auto file = [&](const char* name) { return (fs::path(folder) / name).string(); };
  Status status = makeFolder(folder);
  if (status.ok()) status = saveCamera(file("camera.yaml"), scene.camera);
  const auto save = [&](const char* name, const cv::Mat& image) {
    if (status.ok() && !image.empty()) status = writePng(file(name), image);
  };
  save("depth.png", scene.depth_mm);
  save("color.png", scene.color);
  save("labels.png", scene.true_labels);
  return status;
}

}  // namespace objectness
