// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/picture_boxes.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "common/assignment.hpp"
#include "io/file_access.hpp"
#include "io/yaml_text.hpp"
#include "segments/segments.hpp"

namespace objectness::evaluation {
namespace {

constexpr double kFound = 0.5, kTight = 0.7, kStray = 0.1;

PictureBox readBox(const YAML::Node& node) {
  const auto box = node["box"].as<std::vector<double>>();
  const auto seed = node["seed"].as<std::vector<int>>();
  if (box.size() != 4 || seed.size() != 2) throw YAML::Exception(node.Mark(), "expected a box of 4 and a seed of 2");
  if (box[2] <= box[0] || box[3] <= box[1]) throw YAML::Exception(node.Mark(), "a box of no size");
  return {{cv::Point2d(box[0], box[1]), cv::Point2d(box[2], box[3])}, {seed[0], seed[1]}};
}

double overlap(const cv::Rect2d& a, const cv::Rect2d& b) {
  const double shared = (a & b).area();
  return shared / (a.area() + b.area() - shared);
}

/// The extent and size of one segment.
struct Extent {
  int left, top, right, bottom;  ///< the last two within
  int pixels;

  cv::Rect2d box() const { return {cv::Point2d(left, top), cv::Point2d(right + 1, bottom + 1)}; }
};

std::vector<Extent> extentsOf(const cv::Mat_<ushort>& labels) {
  std::map<ushort, Extent> by_label;
  for (int v = 0; v < labels.rows; ++v) {
    for (int u = 0; u < labels.cols; ++u) {
      if (labels(v, u) < kFirstObjectLabel) continue;
      Extent& extent = by_label.emplace(labels(v, u), Extent{u, v, u, v, 0}).first->second;
      extent.left = std::min(extent.left, u);
      extent.right = std::max(extent.right, u);
      extent.bottom = v;
      ++extent.pixels;
    }
  }
  std::vector<Extent> extents;
  for (const auto& entry : by_label) extents.push_back(entry.second);
  return extents;
}

}  // namespace

Result<std::vector<PictureBox>> loadPictureBoxes(const std::string& scene_folder) {
  Result<std::vector<PictureBox>> result;
  const std::string path = (std::filesystem::path(scene_folder) / "objects.yaml").string();
  if (!std::filesystem::exists(path)) return result;
  const Result<std::string> text = readFile(path, kMaxTextBytes);
  if (!text.ok()) return Result<std::vector<PictureBox>>::error(about(path, text.status));
  try {
    for (const YAML::Node& node : parseYaml(text.value)["objects"]) {
      if (node["box"]) result.value.push_back(readBox(node));
    }
  } catch (const YAML::Exception& e) {
    return Result<std::vector<PictureBox>>::error(StatusCode::kBadInput, path + ": " + e.what());
  }
  return result;
}

PictureBoxCounts countPictureBoxes(const cv::Mat_<ushort>& labels, const std::vector<PictureBox>& truth) {
  const std::vector<Extent> segments = extentsOf(labels);
  PictureBoxCounts counts;
  counts.objects = static_cast<int>(truth.size());
  counts.segments = static_cast<int>(segments.size());
  Eigen::MatrixXd overlaps = Eigen::MatrixXd::Zero(counts.objects, counts.segments);
  for (int i = 0; i < counts.objects; ++i) {
    for (int j = 0; j < counts.segments; ++j) overlaps(i, j) = overlap(truth[i].box, segments[j].box());
  }
  std::vector<char> found(truth.size(), 0);
  if (overlaps.size() > 0) {
    for (const auto& [i, j] : assignMaximum(overlaps)) {
      found[i] = overlaps(i, j) >= kFound;
      counts.found += overlaps(i, j) >= kFound;
      counts.tight += overlaps(i, j) >= kTight;
    }
  }
  std::map<ushort, int> seeds;
  for (const PictureBox& object : truth) ++seeds[labels(object.seed)];
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const ushort label = labels(truth[i].seed);
    counts.merged += !found[i] && label >= kFirstObjectLabel && seeds[label] > 1;
  }
  for (int j = 0; j < counts.segments; ++j) {
    const bool apart = counts.objects == 0 || overlaps.col(j).maxCoeff() < kStray;
    counts.stray += apart && segments[j].pixels >= kMinStrayPixels;
  }
  return counts;
}

}  // namespace objectness::evaluation
