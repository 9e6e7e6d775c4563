// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/box_fits.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "common/angles.hpp"
#include "evaluation/box_overlap.hpp"
#include "evaluation/scores.hpp"
#include "evaluation/visible_boxes.hpp"
#include "segments/box_axes.hpp"

namespace objectness::evaluation {
namespace {

constexpr double kMillimetres = 1000;

/// The turn about the box's own z axis with most overlap, the first of equals. The box is the same after 180 degrees.
OrientedBox turnedToOverlap(const OrientedBox& truth, const OrientedBox& found) {
  constexpr double kCoarse_deg = 2, kFine_deg = 0.1;
  const auto turned = [&](double angle_deg) {
    OrientedBox box = truth;
    box.T_camera_box.rotate(Eigen::AngleAxisd(angle_deg * kDegree, Eigen::Vector3d::UnitZ()));
    return box;
  };
  double best_deg = 0, best = -1;
  const auto search = [&](double from_deg, double to_deg, double step_deg) {
    const int steps = static_cast<int>(std::lround((to_deg - from_deg) / step_deg));
    for (int i = 0; i <= steps; ++i) {
      const double angle_deg = from_deg + i * step_deg, overlap = boxOverlap(found, turned(angle_deg));
      if (overlap > best) best = overlap, best_deg = angle_deg;
    }
  };
  search(0, 180 - kCoarse_deg, kCoarse_deg);
  search(best_deg - kCoarse_deg, best_deg + kCoarse_deg, kFine_deg);
  return turned(best_deg);
}

/// The part about `axis` of a rotation.
double twist(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& axis) {
  const Eigen::Quaterniond q(rotation);
  return 2 * std::abs(std::atan(q.vec().dot(axis) / q.w()));
}

/// Upright, around the visible points of each segment, by its rank.
std::map<int, OrientedBox> pointsBoxes(const Frame& frame, const Segmentation& found) {
  cv::Mat_<int> owners(frame.height(), frame.width(), -1);
  for (std::size_t k = 0; k < found.segments.size(); ++k) {
    for (const int i : found.segments[k].pixels) owners(i / owners.cols, i % owners.cols) = static_cast<int>(k);
  }
  return visibleBoxes(frame, found.table, owners, BoxBase::kLowestPoint);
}

OrientedBox boxOf(int rank, const std::map<int, OrientedBox>& boxes) {
  const auto box = boxes.find(rank);
  return box == boxes.end() ? OrientedBox{} : box->second;
}

bool hasSize(const OrientedBox& box) { return box.size_m.minCoeff() > 0; }

}  // namespace

BoxErrors compareBoxes(const OrientedBox& found, const OrientedBox& truth, bool round, const Eigen::Vector3d& up) {
  const OrientedBox wanted = round ? turnedToOverlap(truth, found) : truth;
  const Eigen::Matrix3d axes = wanted.T_camera_box.linear();
  const OrientedBox named = namedAs(axes, found);
  BoxErrors errors;
  errors.overlap = boxOverlap(found, wanted);
  errors.centre_mm = kMillimetres * (found.T_camera_box.translation() - truth.T_camera_box.translation()).norm();
  if (!round) errors.yaw_deg = twist(named.T_camera_box.linear() * axes.transpose(), up) / kDegree;
  int height = 0;
  (axes.transpose() * up).cwiseAbs().maxCoeff(&height);
  int longer = (height + 1) % 3, shorter = (height + 2) % 3;
  if (wanted.size_m[shorter] > wanted.size_m[longer]) std::swap(longer, shorter);
  const Eigen::Vector3d off_mm = kMillimetres * (named.size_m - wanted.size_m);
  errors.sides_mm = {off_mm[longer], off_mm[shorter], off_mm[height]};
  return errors;
}

bool BoxFit::isSegmented() const { return dice > kFoundDice; }

std::vector<OrientedBox> segmentBoxes(const Frame& frame, const Segmentation& found) {
  std::vector<OrientedBox> boxes;
  for (const Segment& segment : found.segments) boxes.push_back(segment.box);
  if (std::all_of(boxes.begin(), boxes.end(), hasSize)) return boxes;
  const std::map<int, OrientedBox> visible = pointsBoxes(frame, found);
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    if (!hasSize(boxes[k])) boxes[k] = boxOf(static_cast<int>(k), visible);
  }
  return boxes;
}

std::vector<BoxFit> measureBoxFits(const Frame& frame, const Segmentation& found, const cv::Mat_<ushort>& true_labels,
                                   const std::vector<TrueBox>& truth) {
  std::vector<BoxFit> fits;
  std::map<int, ObjectPair> pair_of;
  for (const ObjectPair& pair : pairObjects(found.labels, truthAtLevel(true_labels, Level::kObject))) {
    pair_of[pair.object - kFirstObjectLabel] = pair;
  }
  const std::map<int, OrientedBox> visible = truth.empty() ? std::map<int, OrientedBox>{} : pointsBoxes(frame, found);
  const Eigen::Vector3d up = found.table.T_table_camera.linear().row(2).transpose();
  for (const TrueBox& object : truth) {
    BoxFit fit;
    fit.object = object.object;
    fit.kind = object.kind;
    const auto pair = pair_of.find(object.object);
    if (pair != pair_of.end()) {
      const int rank = pair->second.segment - kFirstObjectLabel;
      const OrientedBox points_box = boxOf(rank, visible), own = found.segments[rank].box;
      fit.dice = pair->second.dice;
      fit.errors = compareBoxes(hasSize(own) ? own : points_box, object.box, object.isRound(), up);
      fit.points_overlap = compareBoxes(points_box, object.box, object.isRound(), up).overlap;
    }
    fits.push_back(fit);
  }
  return fits;
}

}  // namespace objectness::evaluation
