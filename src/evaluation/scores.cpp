// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/scores.hpp"

#include <Eigen/Core>
#include <map>

#include "common/assignment.hpp"
#include "common/true_labels.hpp"
#include "evaluation/boundary.hpp"
#include "segments/segments.hpp"

namespace objectness::evaluation {
namespace {

double harmonic(double p, double r) { return p + r > 0 ? 2 * p * r / (p + r) : 0; }

/// Labels of objects to 0, 1, ... in ascending order.
std::map<ushort, int> ranks(const cv::Mat_<ushort>& labels) {
  std::map<ushort, int> ranks;
  for (const ushort label : labels) {
    if (label >= kFirstObjectLabel) ranks.emplace(label, 0);
  }
  int next = 0;
  for (auto& entry : ranks) entry.second = next++;
  return ranks;
}

/// Pixel counts of objects (rows) and segments (columns).
struct Overlaps {
  Eigen::MatrixXd shared;
  Eigen::VectorXd objects, segments;

  double dice(int i, int j) const { return 2 * shared(i, j) / (objects[i] + segments[j]); }
  double iou(int i, int j) const { return shared(i, j) / (objects[i] + segments[j] - shared(i, j)); }
};

Overlaps countOverlaps(const cv::Mat_<ushort>& labels, const std::map<ushort, int>& segments,
                       const cv::Mat_<ushort>& truth, const std::map<ushort, int>& objects) {
  Overlaps counts{Eigen::MatrixXd::Zero(objects.size(), segments.size()), Eigen::VectorXd::Zero(objects.size()),
                  Eigen::VectorXd::Zero(segments.size())};
  auto truth_pixel = truth.begin();
  for (const ushort label : labels) {
    const auto object = objects.find(*truth_pixel++);
    const auto segment = segments.find(label);
    if (object != objects.end()) ++counts.objects[object->second];
    if (segment != segments.end()) ++counts.segments[segment->second];
    if (object != objects.end() && segment != segments.end()) ++counts.shared(object->second, segment->second);
  }
  return counts;
}

std::vector<std::pair<int, int>> pairByDice(const Overlaps& counts) {
  Eigen::MatrixXd dice(counts.shared.rows(), counts.shared.cols());
  for (int i = 0; i < dice.rows(); ++i) {
    for (int j = 0; j < dice.cols(); ++j) dice(i, j) = counts.dice(i, j);
  }
  return assignMaximum(dice);
}

void scoreEachObject(const Overlaps& counts, Scores& scores) {
  const int n = static_cast<int>(counts.objects.size()), m = static_cast<int>(counts.segments.size());
  scores.over_segmentation = 0;
  for (int i = 0; i < n; ++i) {
    int best = 0;  // the first of equals
    double best_iou = 0;
    for (int j = 0; j < m; ++j) {
      if (counts.shared(i, j) > counts.shared(i, best)) best = j;
      best_iou = std::max(best_iou, counts.iou(i, j));
    }
    const double shared = counts.shared(i, best);
    scores.precision += shared / counts.segments[best] / n;
    scores.recall += shared / counts.objects[i] / n;
    scores.over_segmentation += (1 - shared / counts.objects[i]) / n;
    if (shared > 0) scores.under_segmentation += (counts.segments[best] - shared) / counts.objects[i] / n;
    scores.weighted_overlap += best_iou * counts.objects[i] / counts.objects.sum();
  }
}

void scorePairs(const Overlaps& counts, const std::vector<std::pair<int, int>>& pairs, Scores& scores) {
  double shared = 0, paired = 0, found = 0;
  for (const auto& [i, j] : pairs) {
    shared += counts.shared(i, j);
    paired += counts.shared(i, j) > 0;
    found += counts.dice(i, j) > kFoundDice;
  }
  scores.overlap_precision = shared / counts.segments.sum();
  scores.overlap_recall = shared / counts.objects.sum();
  scores.overlap_f = harmonic(scores.overlap_precision, scores.overlap_recall);
  scores.found_75 = found / static_cast<double>(counts.objects.size());
  scores.extra = static_cast<double>(counts.segments.size()) - paired;
}

}  // namespace

const char* toString(Level level) { return level == Level::kObject ? "object" : "part"; }

cv::Mat_<ushort> truthAtLevel(const cv::Mat_<ushort>& annotation, Level level) {
  cv::Mat_<ushort> truth = annotation.clone();
  for (ushort& label : truth) {
    if (label == 0) continue;
    if (label < kFirstTrueLabel) {
      label = 1;
    } else if (level == Level::kObject) {
      label = static_cast<ushort>(kFirstObjectLabel + trueObject(label));
    }
  }
  return truth;
}

std::vector<ObjectPair> pairObjects(const cv::Mat_<ushort>& labels, const cv::Mat_<ushort>& truth) {
  cv::Mat_<ushort> counted = labels.clone();
  counted.setTo(0, truth == 0);
  const std::map<ushort, int> objects = ranks(truth), segments = ranks(counted);
  if (objects.empty() || segments.empty()) return {};
  const Overlaps counts = countOverlaps(counted, segments, truth, objects);
  std::vector<ushort> object_labels, segment_labels;
  for (const auto& object : objects) object_labels.push_back(object.first);
  for (const auto& segment : segments) segment_labels.push_back(segment.first);
  std::vector<ObjectPair> pairs;
  for (const auto& [i, j] : pairByDice(counts)) {
    if (counts.shared(i, j) > 0) pairs.push_back({object_labels[i], segment_labels[j], counts.dice(i, j)});
  }
  return pairs;
}

std::optional<Scores> scoreLabels(const cv::Mat_<ushort>& labels, const cv::Mat_<ushort>& truth) {
  cv::Mat_<ushort> counted = labels.clone();
  counted.setTo(0, truth == 0);
  const std::map<ushort, int> objects = ranks(truth), segments = ranks(counted);
  if (objects.empty()) return {};
  Scores scores;
  if (segments.empty()) return scores;

  const Overlaps counts = countOverlaps(counted, segments, truth, objects);
  const auto pairs = pairByDice(counts);
  scoreEachObject(counts, scores);
  scorePairs(counts, pairs, scores);

  std::vector<cv::Mat_<uchar>> object_lines, segment_lines;
  for (const auto& object : objects) object_lines.push_back(outline(truth == object.first));
  for (const auto& segment : segments) segment_lines.push_back(outline(counted == segment.first));
  const BoundaryFit fit = compareBoundaries(object_lines, segment_lines, pairs);
  scores.boundary_precision = fit.precision;
  scores.boundary_recall = fit.recall;
  scores.boundary_f = harmonic(fit.precision, fit.recall);
  return scores;
}

}  // namespace objectness::evaluation
