// SPDX-License-Identifier: BSD-3-Clause
#include "connected_points.hpp"

#include <algorithm>

namespace objectness {
namespace {

/// Labels that turn out to be the same; the root of a set is its smallest label.
class Unions {
 public:
  int create() {
    parent_.push_back(static_cast<int>(parent_.size()));
    return parent_.back();
  }
  int root(int label) {
    while (parent_[label] != label) label = parent_[label] = parent_[parent_[label]];
    return label;
  }
  int join(int a, int b) {
    a = root(a), b = root(b);
    return parent_[std::max(a, b)] = std::min(a, b);
  }
  int size() const { return static_cast<int>(parent_.size()); }

 private:
  std::vector<int> parent_{0};  // label 0 = none
};

}  // namespace

float Gap::at(float z) const {
  return std::max({constant_m, per_depth * z, sigmas * static_cast<float>(noise.sigma(z))});
}

cv::Mat_<int> connectPoints(const std::vector<Eigen::Vector3f>& points, const cv::Mat_<uchar>& mask, const Gap& gap,
                            int& count) {
  const int width = mask.cols, height = mask.rows;
  cv::Mat_<int> label(height, width, 0);
  int* labels = label.ptr<int>();
  Unions unions;
  const int offsets[4] = {-1, -width - 1, -width, -width + 1};
  for (int v = 0, i = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u, ++i) {
      if (mask.data[i] == 0) continue;
      const Eigen::Vector3f& p = points[i];
      const float reach = gap.at(p.z());
      const bool exists[4] = {u > 0, u > 0 && v > 0, v > 0, u + 1 < width && v > 0};
      for (int k = 0; k < 4; ++k) {
        if (!exists[k]) continue;
        const int other = labels[i + offsets[k]];
        if (other == 0 || other == labels[i]) continue;
        if ((points[i + offsets[k]] - p).squaredNorm() > reach * reach) continue;
        labels[i] = labels[i] == 0 ? other : unions.join(labels[i], other);
      }
      if (labels[i] == 0) labels[i] = unions.create();
    }
  }
  std::vector<int> final_label(unions.size(), 0);
  count = 0;
  for (int k = 1; k < unions.size(); ++k) final_label[k] = unions.root(k) == k ? ++count : final_label[unions.root(k)];
  for (int i = 0; i < width * height; ++i) labels[i] = final_label[labels[i]];
  return label;
}

}  // namespace objectness
