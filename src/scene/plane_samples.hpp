// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "scene/plane_inlier_kernel.hpp"
#include "scene/surface_samples.hpp"

namespace objectness {

/// Samples that have a point and a normal, column by column.
class PlaneSamples {
 public:
  void reserve(std::size_t count) {
    for (auto* column : {&x_, &y_, &z_, &normal_x_, &normal_y_, &normal_z_, &tolerance_m_}) column->reserve(count);
    weight_.reserve(count);
  }
  void add(const SurfaceSamples::Sample& sample) {
    push(sample.point, sample.normal, sample.tolerance(), 1.0 / (double(sample.sigma_m) * sample.sigma_m));
  }
  void add(const PlaneSamples& other, std::size_t i) {
    push(other.point(i), other.normal(i), other.tolerance_m_[i], other.weight_[i]);
  }
  /// Removes the `count` samples where `which` is set; the others stay in their order.
  void remove(const std::vector<uchar>& which, std::size_t count) {
    const std::size_t left = size() - count;
    const auto pack = [&](auto& column) {
      // Always written, and over what is no longer needed: no branch that depends on the samples.
      for (std::size_t i = 0, to = 0; to < left; ++i) {
        column[to] = column[i];
        to += which[i] == 0;
      }
      column.resize(left);
    };
    for (auto* column : {&x_, &y_, &z_, &normal_x_, &normal_y_, &normal_z_, &tolerance_m_}) pack(*column);
    pack(weight_);
  }
  std::size_t size() const { return x_.size(); }
  Eigen::Vector3f point(std::size_t i) const { return {x_[i], y_[i], z_[i]}; }
  Eigen::Vector3f normal(std::size_t i) const { return {normal_x_[i], normal_y_[i], normal_z_[i]}; }
  float tolerance_m(std::size_t i) const { return tolerance_m_[i]; }
  SampleColumns columns() const {
    return {x_.data(),        y_.data(),           z_.data(),      normal_x_.data(),        normal_y_.data(),
            normal_z_.data(), tolerance_m_.data(), weight_.data(), static_cast<int>(size())};
  }

 private:
  void push(const Eigen::Vector3f& point, const Eigen::Vector3f& normal, float tolerance_m, double weight) {
    x_.push_back(point.x()), y_.push_back(point.y()), z_.push_back(point.z());
    normal_x_.push_back(normal.x()), normal_y_.push_back(normal.y()), normal_z_.push_back(normal.z());
    tolerance_m_.push_back(tolerance_m);
    weight_.push_back(weight);
  }

  std::vector<float> x_, y_, z_, normal_x_, normal_y_, normal_z_, tolerance_m_;
  std::vector<double> weight_;
};

}  // namespace objectness
