// SPDX-License-Identifier: BSD-3-Clause
#include "scene/surface_samples.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "common/row_bands.hpp"

namespace objectness {

SurfaceSamples sampleSurface(const Frame& frame, const Normals& normals, const DepthNoise& noise, int count,
                             int threads) {
  SurfaceSamples result;
  result.stride = std::max(1, static_cast<int>(std::ceil(std::sqrt(double(frame.size()) / count) - 1e-9)));
  result.width = (frame.width() + result.stride - 1) / result.stride;
  result.height = (frame.height() + result.stride - 1) / result.stride;
  result.samples.resize(static_cast<std::size_t>(result.width) * result.height);
  forRowBands(result.height, threads, [&](int first, int last) {
    for (int row = first; row < last; ++row) {
      SurfaceSamples::Sample* sample = result.samples.data() + std::size_t(row) * result.width;
      std::size_t i = std::size_t(row) * result.stride * frame.width();
      for (int column = 0; column < result.width; ++column, ++sample, i += result.stride) {
        *sample = {frame.points[i], normals.normal[i], static_cast<float>(noise.sigma(frame.points[i].z()))};
      }
    }
  });
  return result;
}

bool PlaneFitter::solve(Plane& plane) const {
  if (sums_.count < 3 || !(sums_.weight > 0)) return false;
  const Eigen::Vector3d mean = Eigen::Vector3d(sums_.x, sums_.y, sums_.z) / sums_.weight;
  Eigen::Matrix3d products;
  products << sums_.xx, sums_.yx, sums_.zx, sums_.yx, sums_.yy, sums_.zy, sums_.zx, sums_.zy, sums_.zz;
  const Eigen::Matrix3d covariance = products / sums_.weight - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  if (solver.info() != Eigen::Success || !(solver.eigenvalues()[1] > 1e-9)) return false;
  plane.normal = solver.eigenvectors().col(0).normalized();
  plane.d = -plane.normal.dot(mean);
  if (plane.d < 0) plane.normal = -plane.normal, plane.d = -plane.d;
  return true;
}

}  // namespace objectness
