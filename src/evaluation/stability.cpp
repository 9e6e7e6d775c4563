// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/stability.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>

#include "common/assignment.hpp"
#include "evaluation/box_fits.hpp"
#include "evaluation/table_text.hpp"
#include "io/file_access.hpp"
#include "io/png_file.hpp"
#include "segments/box_axes.hpp"
#include "segments/segments.hpp"

namespace objectness::evaluation {
namespace fs = std::filesystem;
namespace {

constexpr double kSameThing = 0.5, kMillimetres = 1000;

/// Intersection over union of the pixels of segments: rows of one frame, columns of the other.
Eigen::MatrixXd overlaps(const StillFrame& a, const StillFrame& b) {
  Eigen::MatrixXd shared = Eigen::MatrixXd::Zero(a.boxes.size(), b.boxes.size());
  Eigen::VectorXd sizes_a = Eigen::VectorXd::Zero(a.boxes.size()), sizes_b = Eigen::VectorXd::Zero(b.boxes.size());
  auto label_b = b.labels.begin();
  for (const ushort label_a : a.labels) {
    const int i = label_a - kFirstObjectLabel, j = *label_b++ - kFirstObjectLabel;
    if (i >= 0) ++sizes_a[i];
    if (j >= 0) ++sizes_b[j];
    if (i >= 0 && j >= 0) ++shared(i, j);
  }
  for (int i = 0; i < shared.rows(); ++i) {
    for (int j = 0; j < shared.cols(); ++j) {
      if (shared(i, j) > 0) shared(i, j) /= sizes_a[i] + sizes_b[j] - shared(i, j);
    }
  }
  return shared;
}

double rootMeanSquare(const std::vector<double>& squares) {
  double sum = 0;
  for (const double square : squares) sum += square;
  return squares.empty() ? 0 : std::sqrt(sum / static_cast<double>(squares.size()));
}

/// Adds the squared distances of vectors from their mean.
void addSpread(const std::vector<Eigen::Vector3d>& vectors, std::vector<double>& squares) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& v : vectors) mean += v / static_cast<double>(vectors.size());
  for (const Eigen::Vector3d& v : vectors) squares.push_back((v - mean).squaredNorm());
}

/// The boxes of one thing over the frames; sides in the order of the first one's axes.
struct Identity {
  std::vector<Eigen::Vector3d> centres_mm, sides_mm;
  OrientedBox last;
};

class Sequence {
 public:
  explicit Sequence(const std::vector<StillFrame>& frames) : frames_(frames) {
    for (std::size_t k = 0; k < frames.size(); ++k) addFrame(k);
  }

  Metrics columns() const {
    std::vector<double> centres, sides;
    for (const Identity& identity : identities_) {
      addSpread(identity.centres_mm, centres);
      std::vector<double> of_three;
      addSpread(identity.sides_mm, of_three);
      for (const double square : of_three) sides.push_back(square / 3);
    }
    double mean_count = 0, square = 0, overlap = 0;
    const double frames = static_cast<double>(frames_.size());
    for (const StillFrame& frame : frames_) mean_count += static_cast<double>(frame.boxes.size()) / frames;
    for (const StillFrame& frame : frames_) square += std::pow(frame.boxes.size() - mean_count, 2) / frames;
    for (const double one : overlaps_) overlap += one / static_cast<double>(overlaps_.size());
    return {{"frames", frames},
            {"count", mean_count},
            {"count_spread", std::sqrt(square)},
            {"switches", lost_ / (frames - 1)},
            {"segment_IoU", overlap},
            {"turn_median_deg", turns_deg_.empty() ? 0 : median(turns_deg_)},
            {"turn_max_deg", turns_deg_.empty() ? 0 : *std::max_element(turns_deg_.begin(), turns_deg_.end())},
            {"centre_spread_mm", rootMeanSquare(centres)},
            {"side_spread_mm", rootMeanSquare(sides)}};
  }

 private:
  void addFrame(std::size_t k) {
    const StillFrame& frame = frames_[k];
    std::vector<int> identity(frame.boxes.size(), -1);
    int partners = 0;
    if (k > 0) {
      const Eigen::MatrixXd overlap = overlaps(frames_[k - 1], frame);
      for (const auto& [i, j] : assignMaximum(overlap)) {
        if (overlap(i, j) < kSameThing) continue;
        ++partners;
        identity[j] = identity_of_last_[i];
        overlaps_.push_back(overlap(i, j));
        follow(identities_[identity[j]], frame.boxes[j], frame.up);
      }
      lost_ += static_cast<double>(identity_of_last_.size()) - partners;
    }
    for (std::size_t j = 0; j < identity.size(); ++j) {
      if (identity[j] >= 0) continue;
      identity[j] = static_cast<int>(identities_.size());
      const OrientedBox& box = frame.boxes[j];
      identities_.push_back({{kMillimetres * box.T_camera_box.translation()}, {kMillimetres * box.size_m}, box});
    }
    identity_of_last_ = identity;
  }

  void follow(Identity& identity, const OrientedBox& box, const Eigen::Vector3d& up) {
    const OrientedBox named = namedAs(identity.last.T_camera_box.linear(), box);
    turns_deg_.push_back(compareBoxes(box, identity.last, false, up).yaw_deg.value_or(0));
    identity.centres_mm.push_back(kMillimetres * box.T_camera_box.translation());
    identity.sides_mm.push_back(kMillimetres * named.size_m);
    identity.last = named;
  }

  const std::vector<StillFrame>& frames_;
  std::vector<Identity> identities_;
  std::vector<int> identity_of_last_;  ///< of the last frame's segments
  std::vector<double> overlaps_, turns_deg_;
  double lost_ = 0;
};

constexpr const char* kCounted = "frames";

}  // namespace

Metrics measureStability(const std::vector<StillFrame>& frames) {
  return frames.size() < 2 ? Metrics{} : Sequence(frames).columns();
}

Result<std::vector<StabilityRow>> summarizeStability(const std::string& report, const Run& run,
                                                     const std::vector<SceneResult>& results) {
  std::map<std::string, std::string> camera_of;
  for (const auto& scene : run.scenes) camera_of[scene.name] = scene.camera;
  Result<std::vector<StabilityRow>> rows;
  for (const auto& method : run.methods) {
    std::map<std::string, std::vector<const SceneResult*>> sequences;
    for (const SceneResult& result : results) {
      if (result.method == method.name) sequences[camera_of.at(result.scene)].push_back(&result);
    }
    for (const auto& [name, sequence] : sequences) {
      std::vector<StillFrame> frames;
      for (const SceneResult* result : sequence) {
        if (result->state != SceneResult::State::kDone) break;
        const std::string path = (fs::path(resultPath(report, method.name, result->scene)) / "labels.png").string();
        const Result<cv::Mat> labels = readPng(path, PngKind::kLabels);
        if (!labels.ok()) return Result<std::vector<StabilityRow>>::error(about(path, labels.status));
        frames.push_back({labels.value, result->segment_boxes, result->up});
      }
      if (frames.size() != sequence.size() || frames.size() < 2) continue;
      rows.value.push_back({method.name, name, measureStability(frames)});
    }
  }
  return rows;
}

std::string toText(const std::vector<StabilityRow>& rows) {
  if (rows.empty()) return "";
  constexpr std::size_t kName = 10, kSequence = 18;
  std::ostringstream text;
  text << "\nStability (data sets as sequences of a still scene)\n";
  writeCell(text, "method", kName, true);
  writeCell(text, "sequence", kSequence, true);
  for (const auto& column : rows.front().columns) text << column.first << ' ';
  text << '\n';
  for (const StabilityRow& row : rows) {
    writeCell(text, row.method, kName, true);
    writeCell(text, row.sequence, kSequence, true);
    for (const auto& [name, value] : row.columns)
      writeCell(text, fixedText(value, name == kCounted ? 0 : 3), name.size(), false);
    text << '\n';
  }
  return text.str();
}

Status writeStability(const std::string& report, const std::vector<StabilityRow>& rows) {
  std::ostringstream csv;
  csv << "method,sequence";
  for (const auto& column : measureStability(std::vector<StillFrame>(2))) csv << ',' << column.first;
  csv << '\n';
  for (const StabilityRow& row : rows) {
    csv << row.method << ',' << csvCell(row.sequence);
    for (const auto& [name, value] : row.columns) csv << ',' << fixedText(value, name == kCounted ? 0 : 5);
    csv << '\n';
  }
  return writeFile((fs::path(report) / "stability.csv").string(), csv.str());
}

}  // namespace objectness::evaluation
