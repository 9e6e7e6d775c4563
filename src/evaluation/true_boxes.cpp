// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/evaluation/true_boxes.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <opencv2/imgproc.hpp>
#include <set>

#include "io/file_access.hpp"
#include "io/yaml_text.hpp"
#include "objectness_segmentation/common/angles.hpp"
#include "objectness_segmentation/common/true_labels.hpp"

namespace objectness::evaluation {
namespace {

constexpr float kNeighbor_m = 0.02f;  // pixels of one surface are no farther apart
constexpr int kMinNeighbors = 4;      // of eight; a pixel with fewer hangs between surfaces

std::vector<double> readNumbers(const YAML::Node& node, std::size_t count) {
  const auto numbers = node.as<std::vector<double>>();
  if (numbers.size() != count) throw YAML::Exception(node.Mark(), "expected " + std::to_string(count) + " numbers");
  return numbers;
}

TrueBox readBox(const YAML::Node& node) {
  TrueBox truth;
  truth.object = trueObject(node["label"].as<int>());
  const auto size = readNumbers(node["size_m"], 3), at = readNumbers(node["T_camera_box"]["position"], 3),
             q = readNumbers(node["T_camera_box"]["orientation_xyzw"], 4);
  truth.box.size_m = Eigen::Vector3d(size.data());
  truth.box.T_camera_box.translation() = Eigen::Vector3d(at.data());
  const Eigen::Quaterniond rotation(q.data());
  if (truth.box.size_m.minCoeff() <= 0 || std::abs(rotation.norm() - 1) > 1e-3) {
    throw YAML::Exception(node.Mark(), "size_m must be positive and orientation_xyzw of length 1");
  }
  truth.box.T_camera_box.linear() = rotation.normalized().toRotationMatrix();
  return truth;
}

/// The trueObject() of each pixel that lies on its surface, -1 of all others.
cv::Mat_<int> surfacePixels(const Frame& frame, const cv::Mat_<ushort>& labels) {
  cv::Mat_<int> objects(labels.size(), -1);
  for (int v = 1; v + 1 < labels.rows; ++v) {
    for (int u = 1; u + 1 < labels.cols; ++u) {
      const Eigen::Vector3f& p = frame.points[v * labels.cols + u];
      const int object = trueObject(labels(v, u));
      int neighbors = -1;  // the pixel itself
      for (int dv = -1; dv <= 1; ++dv) {
        for (int du = -1; du <= 1; ++du) {
          const Eigen::Vector3f& q = frame.points[(v + dv) * labels.cols + u + du];
          neighbors += trueObject(labels(v + dv, u + du)) == object && (p - q).norm() < kNeighbor_m;
        }
      }
      if (neighbors >= kMinNeighbors) objects(v, u) = object;
    }
  }
  return objects;
}

OrientedBox boxAround(const std::vector<cv::Point2f>& footprint, double top_m,
                      const Eigen::Isometry3d& T_table_camera) {
  const cv::RotatedRect rectangle = cv::minAreaRect(footprint);
  Eigen::Isometry3d T_table_box = Eigen::Isometry3d::Identity();
  T_table_box.translation() << rectangle.center.x, rectangle.center.y, 0.5 * top_m;
  T_table_box.rotate(Eigen::AngleAxisd(rectangle.angle * kDegree, Eigen::Vector3d::UnitZ()));
  return {T_table_camera.inverse() * T_table_box, {rectangle.size.width, rectangle.size.height, top_m}};
}

}  // namespace

Result<std::vector<TrueBox>> loadTrueBoxes(const std::string& scene_folder) {
  Result<std::vector<TrueBox>> result;
  const std::string path = (std::filesystem::path(scene_folder) / "objects.yaml").string();
  if (!std::filesystem::exists(path)) return result;
  const Result<std::string> text = readFile(path, kMaxTextBytes);
  if (!text.ok()) return Result<std::vector<TrueBox>>::error(about(path, text.status));
  try {
    for (const YAML::Node& node : parseYaml(text.value)["objects"]) {
      if (node["size_m"]) result.value.push_back(readBox(node));
    }
  } catch (const YAML::Exception& e) {
    return Result<std::vector<TrueBox>>::error(StatusCode::kBadInput, path + ": " + e.what());
  }
  return result;
}

std::vector<TrueBox> fitTrueBoxes(const Frame& frame, const Table& table, const cv::Mat_<ushort>& labels) {
  const cv::Mat_<int> objects = surfacePixels(frame, labels);
  std::map<int, std::vector<cv::Point2f>> footprints;
  std::map<int, double> tops_m;
  for (int i = 0; i < frame.size(); ++i) {
    const int object = objects(i / frame.width(), i % frame.width());
    if (object < 0) continue;
    const Eigen::Vector3d p = table.T_table_camera * frame.points[i].cast<double>();
    footprints[object].emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()));
    tops_m[object] = std::max(tops_m[object], p.z());
  }
  std::vector<TrueBox> boxes;
  for (const auto& [object, footprint] : footprints) {
    if (tops_m[object] > 0) boxes.push_back({object, boxAround(footprint, tops_m[object], table.T_table_camera)});
  }
  return boxes;
}

Result<std::vector<TrueBox>> findTrueBoxes(const std::string& scene_folder, const Frame& frame, const Table& table,
                                           const cv::Mat_<ushort>& labels) {
  Result<std::vector<TrueBox>> result = loadTrueBoxes(scene_folder);
  if (!result.ok()) return result;
  if (result.value.empty()) {
    result.value = fitTrueBoxes(frame, table, labels);
    return result;
  }
  std::set<int> seen;
  for (const ushort label : labels) seen.insert(trueObject(label));
  const auto hidden = [&](const TrueBox& truth) { return seen.count(truth.object) == 0; };
  result.value.erase(std::remove_if(result.value.begin(), result.value.end(), hidden), result.value.end());
  return result;
}

}  // namespace objectness::evaluation
