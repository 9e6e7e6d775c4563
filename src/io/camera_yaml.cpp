// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/io/camera_yaml.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <vector>

#include "file_access.hpp"
#include "yaml_text.hpp"

namespace objectness {
namespace {

using Camera = Result<PinholeCamera>;

/// The entry under either of its names, undefined when it has none of them.
YAML::Node entry(const YAML::Node& root, const char* calibration_name, const char* message_name) {
  return root[calibration_name] ? root[calibration_name] : root[message_name];
}

/// A matrix as {data: [...]} or as a plain list; empty when there is none.
std::vector<double> matrix(const YAML::Node& root, const char* calibration_name, const char* message_name) {
  const YAML::Node node = entry(root, calibration_name, message_name);
  const YAML::Node data = node && node.IsMap() ? node["data"] : node;
  if (!data || !data.IsSequence()) return {};
  return data.as<std::vector<double>>();
}

bool allZero(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return value == 0; });
}

Camera readCamera(const YAML::Node& root) {
  const auto bad = [](const std::string& message) { return Camera::error(StatusCode::kBadInput, message); };
  if (!root.IsMap()) return bad("is not a camera file: it must hold image_width, image_height and camera_matrix");
  const YAML::Node width = entry(root, "image_width", "width"), height = entry(root, "image_height", "height");
  if (!width || !height) return bad("lacks image_width or image_height");

  Camera camera;
  camera.value.width = width.as<int>();
  camera.value.height = height.as<int>();
  const std::vector<double> p = matrix(root, "projection_matrix", "P"), k = matrix(root, "camera_matrix", "K");
  if (!p.empty() && p.size() != 12)
    return bad("has a projection_matrix of " + std::to_string(p.size()) + " numbers, must be 12");
  if (!k.empty() && k.size() != 9)
    return bad("has a camera_matrix of " + std::to_string(k.size()) + " numbers, must be 9");

  const std::vector<double>& intrinsics = allZero(p) ? k : p;
  if (allZero(intrinsics))
    return bad("has no intrinsics: it needs a projection_matrix or a camera_matrix that is not zero");
  const std::size_t row = intrinsics.size() / 3;
  if (&intrinsics == &k && !allZero(matrix(root, "distortion_coefficients", "D"))) {
    return Camera::error(StatusCode::kBadCamera,
                         "has lens distortion and no projection_matrix: rectify the images (image_proc) and give the "
                         "projection_matrix of the rectified ones");
  }
  camera.value.fx = intrinsics[0];
  camera.value.cx = intrinsics[2];
  camera.value.fy = intrinsics[row + 1];
  camera.value.cy = intrinsics[row + 2];
  const Status status = validate(camera.value);
  return status.ok() ? camera : Camera::error(status);
}

}  // namespace

Result<PinholeCamera> loadCamera(const std::string& path) {
  const Result<std::string> text = readFile(path, kMaxTextBytes);
  if (!text.ok()) return Camera::error(text.status);
  try {
    return readCamera(parseYaml(text.value));
  } catch (const YAML::RepresentationException& e) {
    return Camera::error(StatusCode::kBadInput, std::string("has an entry that is no number: ") + e.what());
  } catch (const YAML::Exception& e) {
    return Camera::error(StatusCode::kBadInput, std::string("is not valid YAML: ") + e.what());
  }
}

Status saveCamera(const std::string& path, const PinholeCamera& camera) {
  std::ostringstream text;
  text << std::setprecision(9) << "image_width: " << camera.width << "\nimage_height: " << camera.height
       << "\ncamera_name: depth_optical\n"
       << "camera_matrix:\n  rows: 3\n  cols: 3\n  data: [" << camera.fx << ", 0, " << camera.cx << ", 0, " << camera.fy
       << ", " << camera.cy << ", 0, 0, 1]\n"
       << "distortion_model: plumb_bob\ndistortion_coefficients:\n  rows: 1\n  cols: 5\n  data: [0, 0, 0, 0, 0]\n"
       << "rectification_matrix:\n  rows: 3\n  cols: 3\n  data: [1, 0, 0, 0, 1, 0, 0, 0, 1]\n"
       << "projection_matrix:\n  rows: 3\n  cols: 4\n  data: [" << camera.fx << ", 0, " << camera.cx << ", 0, 0, "
       << camera.fy << ", " << camera.cy << ", 0, 0, 0, 1, 0]\n";
  return writeFile(path, text.str());
}

}  // namespace objectness
