// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/proposals.hpp"

#include <algorithm>
#include <map>

#include "common/true_labels.hpp"
#include "evaluation/box_overlap.hpp"

namespace objectness::evaluation {
namespace {

bool holds(const OrientedBox& box, const Eigen::Isometry3d& T_box_camera, const Eigen::Vector3f& p, double margin_m) {
  const Eigen::Vector3d q = (T_box_camera * p.cast<double>()).cwiseAbs();
  return (q.array() <= 0.5 * box.size_m.array() + margin_m).all();
}

void measureBestBox(const Frame& frame, const Segmentation& result, const cv::Mat_<ushort>& labels, double margin_m,
                    ProposalMetrics& metrics) {
  if (result.proposals.empty()) return;
  const OrientedBox& box = result.proposals.front().box;
  const Eigen::Isometry3d T_box_camera = box.T_camera_box.inverse();
  int inside = 0;
  std::map<int, int> shared, size;
  for (int i = 0; i < frame.size(); ++i) {
    const int v = i / frame.width(), u = i % frame.width();
    const int object = trueObject(labels(v, u));
    if (object >= 0) ++size[object];
    if (labels(v, u) == 0 || !result.object_points.mask(v, u)) continue;
    if (!holds(box, T_box_camera, frame.points[i], margin_m)) continue;
    ++inside;
    if (object >= 0) ++shared[object];
  }
  int most = 0;
  for (const auto& [object, count] : shared) {
    if (count <= most) continue;
    most = count;
    metrics.best_box_precision = static_cast<double>(count) / inside;
    metrics.best_box_recall = static_cast<double>(count) / size[object];
  }
}

}  // namespace

BoxRecall boxRecall(const std::vector<OrientedBox>& boxes, const std::vector<TrueBox>& truth) {
  BoxRecall recall;
  const std::size_t most = std::min<std::size_t>(boxes.size(), kKeptBoxes.back());
  for (const TrueBox& object : truth) {
    double best = 0;
    std::size_t next = 0;
    for (std::size_t k = 0; k < kKeptBoxes.size(); ++k) {
      for (; next < std::min<std::size_t>(most, kKeptBoxes[k]); ++next) {
        best = std::max(best, boxOverlap(object.box, boxes[next]));
      }
      recall.at_50[k] += best >= 0.5 ? 1.0 / truth.size() : 0;
      recall.at_70[k] += best >= 0.7 ? 1.0 / truth.size() : 0;
    }
  }
  return recall;
}

Footprint footprintOf(const Frame& frame, const Table& table, const ObjectPoints& object_points) {
  Footprint footprint;
  bool first = true;
  for (int i = 0; i < frame.size(); ++i) {
    if (!object_points.mask(i / frame.width(), i % frame.width())) continue;
    const Eigen::Vector2d p = (table.T_table_camera * frame.points[i].cast<double>()).head<2>();
    footprint.low = first ? p : footprint.low.cwiseMin(p);
    footprint.high = first ? p : footprint.high.cwiseMax(p);
    first = false;
  }
  return footprint;
}

ProposalMetrics measureProposals(const Frame& frame, const Segmentation& result, const cv::Mat_<ushort>& labels,
                                 const std::vector<TrueBox>& truth, double margin_m) {
  ProposalMetrics metrics;
  metrics.objects = static_cast<int>(truth.size());
  metrics.proposals = static_cast<int>(result.proposals.size());
  if (!result.status.ok()) return metrics;
  std::vector<OrientedBox> proposed;
  for (const RankedBox& ranked : result.proposals) proposed.push_back(ranked.box);
  metrics.objectness = boxRecall(proposed, truth);
  const Footprint footprint = footprintOf(frame, result.table, result.object_points);
  metrics.fixed = boxRecall(fixedBoxes(result.table, footprint, kKeptBoxes.back()), truth);
  measureBestBox(frame, result, labels, margin_m, metrics);
  return metrics;
}

}  // namespace objectness::evaluation
