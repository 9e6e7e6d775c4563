// SPDX-License-Identifier: BSD-3-Clause
#include "surface_samples.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace objectness {
namespace {

constexpr float kMinToleranceM = 0.006f;
constexpr float kToleranceSigmas = 3.0f;

}  // namespace

float SurfaceSamples::Sample::tolerance() const { return std::max(kMinToleranceM, kToleranceSigmas * sigma_m); }

SurfaceSamples sampleSurface(const Frame& frame, const Normals& normals, const DepthNoise& noise, int count) {
  SurfaceSamples result;
  result.stride = std::max(1, static_cast<int>(std::ceil(std::sqrt(double(frame.size()) / count) - 1e-9)));
  result.width = (frame.width() + result.stride - 1) / result.stride;
  result.height = (frame.height() + result.stride - 1) / result.stride;
  result.samples.reserve(static_cast<std::size_t>(result.width) * result.height);
  for (int v = 0; v < frame.height(); v += result.stride) {
    for (int u = 0; u < frame.width(); u += result.stride) {
      const std::size_t i = static_cast<std::size_t>(v) * frame.width() + u;
      const float z = frame.points[i].z();
      result.samples.push_back({frame.points[i], normals.normal[i], static_cast<float>(noise.sigma(z))});
    }
  }
  return result;
}

void PlaneFitter::add(const Eigen::Vector3f& point, double weight) {
  const Eigen::Vector3d p = point.cast<double>();
  ++count_;
  weight_ += weight;
  sum_ += weight * p;
  products_ += weight * p * p.transpose();
}

bool PlaneFitter::solve(Plane& plane) const {
  if (count_ < 3 || !(weight_ > 0)) return false;
  const Eigen::Vector3d mean = sum_ / weight_;
  const Eigen::Matrix3d covariance = products_ / weight_ - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  if (solver.info() != Eigen::Success || !(solver.eigenvalues()[1] > 1e-9)) return false;
  plane.normal = solver.eigenvectors().col(0).normalized();
  plane.d = -plane.normal.dot(mean);
  if (plane.d < 0) plane.normal = -plane.normal, plane.d = -plane.d;
  return true;
}

}  // namespace objectness
