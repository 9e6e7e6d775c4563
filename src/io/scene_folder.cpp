// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/io/scene_folder.hpp"

#include <algorithm>
#include <filesystem>

#include "io/file_access.hpp"
#include "io/png_file.hpp"
#include "objectness_segmentation/io/camera_yaml.hpp"

namespace objectness {
namespace fs = std::filesystem;

namespace {

std::string sizeText(const cv::Mat& image) { return std::to_string(image.cols) + " x " + std::to_string(image.rows); }

/// Why there is no depth image, with what is there in its place.
std::string withoutDepth(const std::string& folder) {
  std::string other;
  std::error_code ignored;
  for (fs::directory_iterator entry(folder, ignored), end; !ignored && entry != end; entry.increment(ignored)) {
    const fs::path name = entry->path().filename();
    if (name.stem() == "depth" && name.has_extension()) other = std::max(other, name.string());
  }
  if (other.empty()) {
    return "holds no depth.png: a scene folder has depth.png (16-bit millimetres) and camera.yaml";
  }
  return "holds " + other +
         ", which is not read: convert it to depth.png of 16 bits, in millimetres or finer with --depth-scale (10000: "
         "tenths of a millimetre)";
}

/// Colour is not needed: what is wrong with it is a remark.
cv::Mat usableColor(const std::string& path, const cv::Mat& depth, std::vector<std::string>& remarks) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return {};
  const Result<cv::Mat> read = readPng(path, PngKind::kColor);
  if (!read.ok()) {
    remarks.push_back(about("color.png", read.status).message + "; the results have no colour");
  } else if (read.value.size() != depth.size()) {
    remarks.push_back("color.png is " + sizeText(read.value) + ", depth.png " + sizeText(depth) +
                      ": the results have no colour; give the picture that is registered to depth");
  } else {
    return read.value;
  }
  return {};
}

}  // namespace

Result<Frame> loadSceneFolder(const std::string& folder, const std::optional<ImageCamera>& fallback,
                              const InputConfig& config) {
  const auto file = [&](const char* name) { return (fs::path(folder) / name).string(); };
  std::error_code ignored;
  if (!fs::exists(file("depth.png"), ignored)) {
    return Result<Frame>::error(StatusCode::kBadInput, withoutDepth(folder));
  }
  const Result<cv::Mat> depth = readPng(file("depth.png"), PngKind::kDepth);
  if (!depth.ok()) return Result<Frame>::error(about("depth.png", depth.status));

  Result<ImageCamera> camera;
  if (fallback && !fs::exists(file("camera.yaml"), ignored)) {
    camera.value = *fallback;
  } else {
    camera = loadImageCamera(file("camera.yaml"));
  }
  if (!camera.ok()) return Result<Frame>::error(about("camera.yaml", camera.status));
  const cv::Mat color = usableColor(file("color.png"), depth.value, camera.value.remarks);
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
