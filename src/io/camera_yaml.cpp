// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/io/camera_yaml.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <iomanip>
#include <sstream>
#include <vector>

#include "io/file_access.hpp"
#include "io/yaml_text.hpp"
#include "objectness_segmentation/io/depth_scale.hpp"

namespace objectness {
namespace {

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

/// Copies a matrix that is given; kBadInput when it has another number of elements.
template <std::size_t count>
Status readMatrix(const YAML::Node& root, const char* calibration_name, const char* message_name,
                  std::array<double, count>& values) {
  const std::vector<double> given = matrix(root, calibration_name, message_name);
  if (given.empty()) return {};
  if (given.size() != count) {
    return Status::error(StatusCode::kBadInput, std::string("has a ") + calibration_name + " of " +
                                                    std::to_string(given.size()) + " numbers, must be " +
                                                    std::to_string(count));
  }
  std::copy(given.begin(), given.end(), values.begin());
  return {};
}

std::uint32_t number(const YAML::Node& node) { return node ? node.as<std::uint32_t>() : 0; }

Result<CameraCalibration> readCalibration(const YAML::Node& root) {
  using Calibration = Result<CameraCalibration>;
  const auto bad = [](const std::string& message) { return Calibration::error(StatusCode::kBadInput, message); };
  if (!root.IsMap()) return bad("is not a camera file: it must hold image_width, image_height and camera_matrix");
  const YAML::Node width = entry(root, "image_width", "width"), height = entry(root, "image_height", "height");
  if (!width || !height) return bad("lacks image_width or image_height");

  Calibration calibration;
  CameraCalibration& c = calibration.value;
  c.width = number(width);
  c.height = number(height);
  c.binning_x = number(root["binning_x"]);
  c.binning_y = number(root["binning_y"]);
  if (const YAML::Node roi = root["roi"]; roi && roi.IsMap()) {
    c.roi = {number(roi["x_offset"]), number(roi["y_offset"]), number(roi["width"]), number(roi["height"])};
  }
  if (const YAML::Node model = root["distortion_model"]; model && model.IsScalar()) c.distortion_model = model.Scalar();
  c.D = matrix(root, "distortion_coefficients", "D");
  Status status = readMatrix(root, "projection_matrix", "P", c.P);
  if (status.ok()) status = readMatrix(root, "camera_matrix", "K", c.K);
  if (!status.ok()) return Calibration::error(status);
  if (c.P[0] == 0 && c.K[0] == 0) {
    return bad("has no intrinsics: it needs a projection_matrix or a camera_matrix that is not zero");
  }
  return calibration;
}

Result<ImageCamera> readCamera(const YAML::Node& root) {
  using Camera = Result<ImageCamera>;
  const Result<CameraCalibration> calibration = readCalibration(root);
  if (!calibration.ok()) return Camera::error(calibration.status);
  Camera camera = imageCamera(calibration.value);
  if (!camera.ok()) return camera;
  if (const YAML::Node scale = root["depth_scale"]; scale) {
    const Result<double> unit = depthUnit(scale.IsScalar() ? scale.Scalar() : "");
    if (!unit.ok()) return Camera::error(StatusCode::kBadInput, "has a depth_scale that " + unit.status.message);
    camera.value.depth_unit_m = unit.value;
  }
  return camera;
}

}  // namespace

Result<ImageCamera> loadImageCamera(const std::string& path) {
  using Camera = Result<ImageCamera>;
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

Result<PinholeCamera> rectifiedCamera(const ImageCamera& camera) {
  if (!camera.lens) return {{}, camera.pinhole};
  return Result<PinholeCamera>::error(StatusCode::kBadCamera,
                                      "has lens distortion and no projection_matrix: rectify the images (image_proc) "
                                      "and give the projection_matrix of the rectified ones");
}

Result<PinholeCamera> loadCamera(const std::string& path) {
  const Result<ImageCamera> camera = loadImageCamera(path);
  return camera.ok() ? rectifiedCamera(camera.value) : Result<PinholeCamera>::error(camera.status);
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
