// SPDX-License-Identifier: BSD-3-Clause
#include "grouping/box_cues.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "grouping/pixel_kernel.hpp"

namespace objectness {
namespace {

constexpr float kInside_m = 0.003;                  // a point this far outside a face is still in the box
constexpr float kFace_m = 0.012;                    // a point this near to a face lies on it
const Eigen::Array3f kRing_m(0.02f, 0.02f, 0.04f);  // b_eps of Eq. 2
constexpr float kClear_m = 0.01;                    // farther in depth than this is apart
constexpr int kCells = 9;                           // of the volume, per side

/// The box as the camera stands to it.
struct View {
  View(const OrientedBox& box, const Eigen::Vector3f& eye_table)
      : T_box_table(box.T_camera_box.inverse().cast<float>()),
        half(0.5f * box.size_m.cast<float>()),
        eye(T_box_table * eye_table) {}

  bool sees(int axis) const { return std::abs(eye[axis]) > half[axis]; }
  float faceArea(int axis) const { return 4 * half[(axis + 1) % 3] * half[(axis + 2) % 3]; }
  /// Whether any point of a ball may be in the box with `margin` around it.
  bool reaches(const Ball& ball, const Eigen::Array3f& margin) const {
    const Eigen::Array3f q = (T_box_table * ball.centre).array().abs();
    return (q <= half.array() + margin + (ball.radius + Ball::kRounding_m)).all();
  }
  bool onVisibleFace(const Eigen::Vector3f& q) const {
    for (int axis = 0; axis < 3; ++axis) {
      if (sees(axis) && std::abs(q[axis] - std::copysign(half[axis], eye[axis])) < kFace_m) return true;
    }
    return false;
  }

  Eigen::Isometry3f T_box_table;
  Eigen::Vector3f half, eye;
};

/// Points of all pieces in the box: own and others', and how the box cuts through pieces (Eq. 3, 4).
void addPointCues(const GroupParts& parts, const Members& group, const View& view, GroupCues& cues) {
  int own = 0, others = 0, on_face = 0;
  float straddling = 0, held = 0;
  for (std::size_t k = 0; k < parts.points.size(); ++k) {
    if (!view.reaches(parts.points_ball[k], Eigen::Array3f::Constant(kInside_m))) continue;
    float inside = 0;
    for (const Eigen::Vector3f& p : parts.points[k]) {
      const Eigen::Vector3f q = view.T_box_table * p;
      if ((q.array().abs() > view.half.array() + kInside_m).any()) continue;
      ++inside;
      if (group.inside[k]) on_face += view.onVisibleFace(q);
    }
    (group.inside[k] ? own : others) += static_cast<int>(inside);
    if (inside > 0) straddling += inside * inside / static_cast<float>(parts.points[k].size());
    held += inside;
  }
  cues.straddling = held > 0 ? straddling / held : 0;
  cues.face_share = own > 0 ? on_face / static_cast<float>(own) : 0;
  cues.other_points = others / static_cast<float>(std::max(1, own + others));
}

void addEdgeCues(const GroupParts& parts, const View& view, float pixel_m, GroupCues& cues) {
  float inside = 0, near = 0, visible = 0;
  for (std::size_t k = 0; k < parts.edges.size(); ++k) {
    if (!view.reaches(parts.edges_ball[k], kRing_m)) continue;
    for (const Eigen::Vector3f& p : parts.edges[k]) {
      const Eigen::Array3f q = (view.T_box_table * p).array().abs();
      inside += (q <= view.half.array() + kInside_m).all();
      near += (q <= view.half.array() + kRing_m).all();
    }
  }
  for (int axis = 0; axis < 3; ++axis) visible += view.sees(axis) ? view.faceArea(axis) : 0;
  cues.edge_density = parts.edge_stride * inside * pixel_m / std::sqrt(std::max(1e-6f, visible));
  cues.outer_edges = near > 0 ? inside / near : 0;
}

}  // namespace

void addBoxCues(const GroupParts& parts, const Members& group, const OrientedBox& box, GroupCues& cues) {
  const View view(box, parts.eye);
  addPointCues(parts, group, view, cues);

  float area = 0, low = 1e9f, high = -1e9f;
  std::size_t pixels = 0;
  std::vector<cv::Point> hulls, hull;
  for (const int k : group.list) {
    area += parts.evidence.pieces.pieces[k].area_m2;
    pixels += parts.evidence.pieces.pieces[k].pixels.size();
    hulls.insert(hulls.end(), parts.hull[k].begin(), parts.hull[k].end());
    for (const Eigen::Vector3f& p : parts.points[k]) low = std::min(low, p.z()), high = std::max(high, p.z());
  }
  addEdgeCues(parts, view, std::sqrt(area / static_cast<float>(pixels)), cues);
  float silhouette = 0;
  const Eigen::Vector3f towards = view.eye.normalized();
  for (int axis = 0; axis < 3; ++axis)
    silhouette += view.sees(axis) ? view.faceArea(axis) * std::abs(towards[axis]) : 0;
  cues.box_fill = area / std::max(1e-6f, silhouette);
  cv::convexHull(hulls, hull);  // the hull of all outlines
  cues.hull_fill = static_cast<float>(pixels / std::max(1.0, cv::contourArea(hull)));

  Eigen::Vector3d size = box.size_m;
  std::sort(size.data(), size.data() + 3);
  cues.elongation = static_cast<float>(size[1] / size[2]);
  cues.flatness = static_cast<float>(size[0] / size[1]);
  cues.upright = static_cast<float>(box.T_camera_box.linear().row(2).cwiseAbs().maxCoeff());
  cues.base_height = low / std::max(kClear_m, high);
}

void addVolumeCues(const GroupParts& parts, const Members& group, const OrientedBox& box, GroupCues& cues) {
  const Frame& frame = parts.evidence.frame;
  const Eigen::Isometry3f T_camera_box = parts.T_camera_table * box.T_camera_box.cast<float>();
  const Eigen::Vector3f cell = box.size_m.cast<float>() / kCells;
  // What each axis adds to a cell's centre.
  std::array<Eigen::Vector3f, kCells> along[3];
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < kCells; ++i) {
      along[axis][i] = T_camera_box.linear().col(axis) * (cell[axis] * (i - 0.5f * (kCells - 1)));
    }
  }
  constexpr int kAll = kCells * kCells * kCells;
  float x[kAll], y[kAll], z[kAll];
  int cells = 0;
  for (const Eigen::Vector3f& on_z : along[2]) {
    for (const Eigen::Vector3f& on_y : along[1]) {
      for (const Eigen::Vector3f& on_x : along[0]) {
        const Eigen::Vector3f p = (on_x + (on_y + on_z)) + T_camera_box.translation();
        x[cells] = p.x(), y[cells] = p.y(), z[cells] = p.z();
        ++cells;
      }
    }
  }
  int pixels[kAll];
  const PinholeCamera& camera = frame.camera;
  findPixels({static_cast<float>(camera.fx), static_cast<float>(camera.fy), static_cast<float>(camera.cx),
              static_cast<float>(camera.cy), frame.width(), frame.height()},
             x, y, z, kAll, pixels);
  int free = 0, own = 0, other = 0, unseen = 0;
  for (int i = 0; i < kAll; ++i) {
    const float seen = pixels[i] < 0 ? std::numeric_limits<float>::quiet_NaN() : frame.points[pixels[i]].z();
    if (std::isnan(seen)) {
      ++unseen;
    } else if (seen > z[i] + kClear_m) {
      ++free;
    } else {
      const int piece = parts.evidence.pieces.label(pixels[i]);
      if (piece >= 0 && group.inside[piece]) {
        ++own;
      } else {
        other += piece >= 0 && seen < z[i] - kClear_m;
      }
    }
  }
  constexpr float kShare = kAll;
  cues.free = free / kShare;
  cues.behind_own = own / kShare;
  cues.behind_other = other / kShare;
  cues.unseen = unseen / kShare;
}

}  // namespace objectness
