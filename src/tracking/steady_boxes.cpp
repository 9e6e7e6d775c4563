// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/steady_boxes.hpp"

#include <algorithm>

#include "common/share_below.hpp"
#include "segments/box_axes.hpp"

namespace objectness {
namespace {

constexpr double kMovedM = 0.008;  // of the centre of what is seen
constexpr int kMaxMissed = 5;
constexpr double kMostly = 0.7;  // of the looks

Eigen::Vector3d centreOf(const Frame& frame, const std::vector<int>& pixels) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const int i : pixels) sum += frame.points[i].cast<double>();
  return sum / static_cast<double>(std::max<std::size_t>(1, pixels.size()));
}

/// Of each coordinate. vectors: not empty.
Eigen::Vector3d medianOf(const std::vector<Eigen::Vector3d>& vectors) {
  Eigen::Vector3d median;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const Eigen::Vector3d& v : vectors) values.push_back(v[axis]);
    median[axis] = shareBelow(0.5, values);
  }
  return median;
}

/// boxes: not empty; axes named alike.
OrientedBox medianOf(const std::vector<OrientedBox>& boxes) {
  const Eigen::Matrix3d first = boxes.front().T_camera_box.linear();
  std::vector<Eigen::Vector3d> centres, sizes, turns;
  for (const OrientedBox& box : boxes) {
    const Eigen::AngleAxisd turn(Eigen::Matrix3d(first.transpose() * box.T_camera_box.linear()));
    centres.push_back(box.T_camera_box.translation());
    sizes.push_back(box.size_m);
    turns.push_back(turn.angle() * turn.axis());
  }
  const Eigen::Vector3d turn = medianOf(turns);
  OrientedBox median;
  median.size_m = medianOf(sizes);
  median.T_camera_box.translation() = medianOf(centres);
  median.T_camera_box.linear() = first * Eigen::AngleAxisd(turn.norm(), turn.stableNormalized()).toRotationMatrix();
  return median;
}

}  // namespace

void SteadyBoxes::settle(const Frame& frame, const std::vector<Identity>& identities,
                         const Eigen::Isometry3d& T_fixed_camera, int frames, std::vector<Segment>& segments) {
  if (frames <= 1) return clear();
  for (auto& object : objects_) ++object.second.missed;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    Segment& segment = segments[k];
    Object& object = objects_[identities[k].id];
    object.missed = 0;
    const Eigen::Vector3d centre = T_fixed_camera * centreOf(frame, segment.pixels);
    if (object.looks.empty() || (centre - object.seen_centre).norm() > kMovedM) {
      object.looks.clear();
      object.seen_centre = centre;
    }
    Look look{{T_fixed_camera * segment.box.T_camera_box, segment.box.size_m}, segment.round};
    if (!object.looks.empty()) look.box = namedAs(object.looks.front().box.T_camera_box.linear(), look.box);
    object.looks.push_back(look);
    while (object.looks.size() > static_cast<std::size_t>(frames)) object.looks.pop_front();

    // Boxes of round things are not to be mixed with others: those of what it was go on until most looks say other.
    const auto rounds = std::count_if(object.looks.begin(), object.looks.end(), [](const Look& l) { return l.round; });
    const double share = static_cast<double>(rounds) / static_cast<double>(object.looks.size());
    object.round = object.looks.size() == 1 ? look.round : object.round ? share >= 1 - kMostly : share > kMostly;
    segment.round = object.round;
    std::vector<OrientedBox> boxes;
    for (const Look& l : object.looks) {
      if (l.round == segment.round) boxes.push_back(l.box);
    }
    const OrientedBox settled = medianOf(boxes);
    segment.box = {T_fixed_camera.inverse() * settled.T_camera_box, settled.size_m};
  }
  for (auto object = objects_.begin(); object != objects_.end();) {
    object = object->second.missed > kMaxMissed ? objects_.erase(object) : std::next(object);
  }
}

}  // namespace objectness
