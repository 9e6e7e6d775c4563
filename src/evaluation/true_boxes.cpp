// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/true_boxes.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "common/true_labels.hpp"
#include "evaluation/visible_boxes.hpp"
#include "io/file_access.hpp"
#include "io/yaml_text.hpp"

namespace objectness::evaluation {
namespace {

std::vector<double> readNumbers(const YAML::Node& node, std::size_t count) {
  const auto numbers = node.as<std::vector<double>>();
  if (numbers.size() != count) throw YAML::Exception(node.Mark(), "expected " + std::to_string(count) + " numbers");
  return numbers;
}

TrueBox readBox(const YAML::Node& node) {
  TrueBox truth;
  truth.object = trueObject(node["label"].as<int>());
  if (node["kind"]) truth.kind = node["kind"].as<std::string>();
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

}  // namespace

bool TrueBox::isRound() const {
  static const std::set<std::string> kRound{"cylinder", "cone", "sphere", "bowl", "bottle"};
  return kRound.count(kind) > 0;
}

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
  cv::Mat_<int> objects(labels.size());
  std::transform(labels.begin(), labels.end(), objects.begin(), [](ushort label) { return trueObject(label); });
  std::vector<TrueBox> boxes;
  for (const auto& [object, box] : visibleBoxes(frame, table, objects, BoxBase::kTable)) boxes.push_back({object, box});
  return boxes;
}

Result<std::vector<TrueBox>> loadVisibleTrueBoxes(const std::string& scene_folder, const cv::Mat_<ushort>& labels) {
  Result<std::vector<TrueBox>> result = loadTrueBoxes(scene_folder);
  std::set<int> seen;
  for (const ushort label : labels) seen.insert(trueObject(label));
  const auto hidden = [&](const TrueBox& truth) { return seen.count(truth.object) == 0; };
  result.value.erase(std::remove_if(result.value.begin(), result.value.end(), hidden), result.value.end());
  return result;
}

Result<std::vector<TrueBox>> findTrueBoxes(const std::string& scene_folder, const Frame& frame, const Table& table,
                                           const cv::Mat_<ushort>& labels) {
  const Result<std::vector<TrueBox>> all = loadTrueBoxes(scene_folder);
  if (!all.ok()) return all;
  if (all.value.empty()) return {{}, fitTrueBoxes(frame, table, labels)};
  return loadVisibleTrueBoxes(scene_folder, labels);
}

}  // namespace objectness::evaluation
