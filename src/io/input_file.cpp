// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/io/input_file.hpp"

#include <filesystem>

#include "io/file_access.hpp"
#include "objectness_segmentation/io/camera_yaml.hpp"
#include "objectness_segmentation/io/pcd_file.hpp"
#include "objectness_segmentation/io/scene_folder.hpp"

namespace objectness {
namespace fs = std::filesystem;
namespace {

bool isPcd(const fs::path& path) { return path.extension() == ".pcd" || path.extension() == ".PCD"; }

}  // namespace

std::string inputName(const std::string& path) {
  std::error_code error;
  fs::path full = fs::absolute(path, error).lexically_normal();
  if (!full.has_filename()) full = full.parent_path();  // "scene/"
  return isPcd(full) && !fs::is_directory(full, error) ? full.stem().string() : full.filename().string();
}

Result<Frame> loadInput(const std::string& path, const std::optional<ImageCamera>& camera, const InputConfig& config) {
  std::error_code error;
  const fs::file_status type = fs::status(path, error);
  if (fs::is_directory(type)) return loadSceneFolder(path, camera, config);
  if (!fs::exists(type)) return Result<Frame>::error(StatusCode::kBadInput, "there is no such file or folder");
  if (!isPcd(path)) {
    return Result<Frame>::error(StatusCode::kBadInput,
                                "is neither a scene folder (depth.png, camera.yaml) nor a .pcd file");
  }
  const Result<RawCloud> cloud = loadPcd(path);
  if (!cloud.ok()) return Result<Frame>::error(cloud.status);
  if (!camera) return makeFrame(cloud.value, std::nullopt, config);
  const Result<PinholeCamera> pinhole = rectifiedCamera(*camera);
  if (!pinhole.ok()) return Result<Frame>::error(about("its camera", pinhole.status));
  Result<Frame> frame = makeFrame(cloud.value, pinhole.value, config);
  frame.value.remarks.insert(frame.value.remarks.begin(), camera->remarks.begin(), camera->remarks.end());
  return frame;
}

}  // namespace objectness
