// SPDX-License-Identifier: BSD-3-Clause
#include "scene/moved_view.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "common/upper_median.hpp"

namespace objectness {
namespace {

constexpr std::size_t kSamples = 5000;
constexpr std::size_t kMinSamples = 50;
constexpr double kMaxMedianResidualPx = 0.5;

struct Sample {
  Eigen::Vector4d point;  ///< homogeneous
  Eigen::Vector2d pixel;
};

/// Scales that give all coordinates about the same size, without which the equations are ill-conditioned.
struct Scaling {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double spread = 1;
};

Scaling scalingOf(const RawCloud& cloud, std::size_t step) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double squares = 0, count = 0;
  for (std::size_t i = 0; i < cloud.points.size(); i += step) {
    if (!cloud.points[i].allFinite()) continue;
    sum += cloud.points[i].cast<double>();
    squares += cloud.points[i].cast<double>().squaredNorm();
    ++count;
  }
  Scaling scaling;
  if (count == 0) return scaling;
  scaling.centre = sum / count;
  scaling.spread = std::sqrt(std::max(1e-12, squares / count - scaling.centre.squaredNorm()));
  return scaling;
}

std::vector<Sample> samplesOf(const RawCloud& cloud) {
  const std::size_t step = 1 + cloud.points.size() / kSamples;
  const Scaling scaling = scalingOf(cloud, step);
  const double side = std::max(cloud.width, cloud.height);
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < cloud.points.size(); i += step) {
    if (!cloud.points[i].allFinite()) continue;
    const Eigen::Vector3d p = (cloud.points[i].cast<double>() - scaling.centre) / scaling.spread;
    samples.push_back({p.homogeneous(), Eigen::Vector2d(i % cloud.width, i / cloud.width) / side});
  }
  return samples;
}

}  // namespace

bool isMovedView(const RawCloud& cloud) {
  const std::vector<Sample> samples = samplesOf(cloud);
  if (samples.size() < kMinSamples) return false;
  // The direct linear transform: the 3 x 4 projection of least algebraic error.
  using Matrix12d = Eigen::Matrix<double, 12, 12>;
  using Vector12d = Eigen::Matrix<double, 12, 1>;
  Matrix12d normal = Matrix12d::Zero();
  for (const Sample& sample : samples) {
    for (int axis = 0; axis < 2; ++axis) {
      Vector12d row = Vector12d::Zero();
      row.segment<4>(4 * axis) = sample.point;
      row.tail<4>() = -sample.pixel[axis] * sample.point;
      normal += row * row.transpose();
    }
  }
  const Eigen::SelfAdjointEigenSolver<Matrix12d> solver(normal);
  if (solver.info() != Eigen::Success) return false;
  const Vector12d best = solver.eigenvectors().col(0);
  Eigen::Matrix<double, 3, 4> projection;
  for (int row = 0; row < 3; ++row) projection.row(row) = best.segment<4>(4 * row);

  const double side = std::max(cloud.width, cloud.height);
  std::vector<double> residuals;
  int in_front = 0;
  for (const Sample& sample : samples) {
    const Eigen::Vector3d seen = projection * sample.point;
    in_front += seen.z() > 0;
    const double residual = side * (seen.head<2>() / seen.z() - sample.pixel).norm();
    residuals.push_back(std::isfinite(residual) ? residual : std::numeric_limits<double>::max());
  }
  const double median = upperMedian(residuals);
  // The sign of the projection is open; a camera has all it sees on one side of it.
  const auto count = static_cast<int>(samples.size());
  return median <= kMaxMedianResidualPx && (in_front == 0 || in_front == count);
}

}  // namespace objectness
