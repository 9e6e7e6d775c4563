// SPDX-License-Identifier: BSD-3-Clause
#include "segments/leaning_slab.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "common/share_below.hpp"

namespace objectness {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kMinPoints = 30, kMinFacePoints = 20;
constexpr std::size_t kSeeds = 40;
constexpr double kMinTilt = 0.139, kMaxTilt = 0.906;  // sine of the normal over the table: 8 and 65 deg
constexpr double kMinToleranceM = 0.004, kToleranceSigmas = 2.5, kWider = 1.5;
constexpr float kSeedCosine = 0.95f;
constexpr double kMeanCosine = 0.93, kFaceCosine = 0.85;
constexpr double kMinSeedShare = 0.2, kMinShare = 0.35;
constexpr double kMinRoundness = 4;  // of the face: second over smallest variance of its points
constexpr double kTrimmed = 0.005, kTrimmedBehind = 0.02;
constexpr double kMinThicknessM = 0.01, kMaxThickness = 0.5;  // of the shorter side of the face

bool leans(double normal_z) { return std::abs(normal_z) > kMinTilt && std::abs(normal_z) < kMaxTilt; }

struct Face {
  Vector3d normal, centre;
  std::size_t points = 0;
};

/// The normal that most points agree with, with their places in one plane.
std::optional<Vector3d> seedNormal(const std::vector<SeenPoint>& points, std::size_t all, float tolerance_m) {
  std::size_t most = 0;
  Vector3d best;
  for (std::size_t i = 0; i < kSeeds; ++i) {
    const SeenPoint& seed = points[i * points.size() / kSeeds];
    if (!leans(seed.normal.z())) continue;
    std::size_t count = 0;
    for (const SeenPoint& q : points) {
      count += q.normal.dot(seed.normal) > kSeedCosine && std::abs(seed.normal.dot(q.place - seed.place)) < tolerance_m;
    }
    if (count > most) most = count, best = seed.normal.cast<double>();
  }
  if (static_cast<double>(most) < kMinSeedShare * static_cast<double>(all) || most == 0) return {};
  return best;
}

std::optional<Face> fitFace(const std::vector<SeenPoint>& points, const Vector3d& seed, double tolerance_m) {
  Face face;
  face.normal.setZero();
  for (const SeenPoint& q : points) {
    const Vector3d normal = q.normal.cast<double>();
    if (normal.dot(seed) > kMeanCosine) face.normal += normal;
  }
  face.normal.normalize();
  for (int round = 0; round < 2; ++round) {
    std::vector<float> offsets;
    for (const SeenPoint& q : points) {
      if (q.normal.cast<double>().dot(face.normal) > kFaceCosine) {
        offsets.push_back(static_cast<float>(face.normal.dot(q.place.cast<double>())));
      }
    }
    if (offsets.size() < kMinFacePoints) return {};
    const double offset = shareBelow(0.5, offsets);
    std::vector<Vector3d> on_face;
    face.centre.setZero();
    for (const SeenPoint& q : points) {
      const Vector3d p = q.place.cast<double>();
      if (q.normal.cast<double>().dot(face.normal) <= kFaceCosine) continue;
      if (std::abs(face.normal.dot(p) - offset) >= kWider * tolerance_m) continue;
      on_face.push_back(p);
      face.centre += p;
    }
    face.points = on_face.size();
    if (face.points < kMinFacePoints) return {};
    face.centre /= static_cast<double>(face.points);
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const Vector3d& p : on_face) scatter += (p - face.centre) * (p - face.centre).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(scatter);
    if (axes.eigenvalues()[1] < kMinRoundness * axes.eigenvalues()[0]) return {};
    const Vector3d normal = axes.eigenvectors().col(0);
    face.normal = normal.dot(face.normal) < 0 ? Vector3d(-normal) : normal;
  }
  return face;
}

}  // namespace

std::optional<OrientedBox> fitLeaningSlab(const SeenThing& thing) {
  std::vector<SeenPoint> points;
  for (const SeenPoint& q : thing.points) {
    if (q.has_normal) points.push_back(q);
  }
  if (points.size() < kMinPoints) return {};
  const double tolerance_m = std::max(kMinToleranceM, kToleranceSigmas * thing.sigma_m);
  const auto seed = seedNormal(points, thing.points.size(), static_cast<float>(tolerance_m));
  if (!seed) return {};
  const auto face = fitFace(points, *seed, tolerance_m);
  if (!face || !leans(face->normal.z())) return {};
  if (static_cast<double>(face->points) < kMinShare * static_cast<double>(thing.points.size())) return {};

  const Vector3d level = Vector3d::UnitZ().cross(face->normal).normalized();
  Eigen::Matrix3d axes;
  axes << level, -face->normal, level.cross(-face->normal);
  Vector3d low, high;
  std::vector<float> values(thing.points.size());
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3f direction = axes.col(axis).cast<float>();
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = direction.dot(thing.points[i].place);
    low[axis] = shareBelow(kTrimmed, values);
    high[axis] = shareBelow(axis == 1 ? 1 - kTrimmedBehind : 1 - kTrimmed, values);
  }
  low[1] = -face->normal.dot(face->centre);
  high[1] = std::max(high[1], low[1] + kMinThicknessM);
  const Vector3d size = high - low;
  if (size[1] > kMaxThickness * std::min(size[0], size[2])) return {};
  OrientedBox box;
  box.size_m = size;
  box.T_camera_box.linear() = axes;
  box.T_camera_box.translation() = axes * (0.5 * (low + high));
  return box;
}

}  // namespace objectness
