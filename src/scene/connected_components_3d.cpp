// SPDX-License-Identifier: BSD-3-Clause
#include "scene/connected_components_3d.hpp"

#include <algorithm>

#include "common/disjoint_sets.hpp"
#include "common/row_bands.hpp"

namespace objectness {
namespace {

constexpr int kRowsPerBand = 60;

/// Labels the rows of a mask, band by band: each band has labels 1, 2, ... of its own.
class PointConnector {
 public:
  PointConnector(const std::vector<Eigen::Vector3f>& points, const cv::Mat_<uchar>& mask, const Gap& gap)
      : points_(points), mask_(mask), gap_(gap), labels_(mask.rows, mask.cols) {}

  cv::Mat_<int> run(int threads, int& count) {
    std::vector<DisjointSets> bands((mask_.rows + kRowsPerBand - 1) / kRowsPerBand);
    forRows(threads, [&](int first, int last) { labelBand(first, last, bands[first / kRowsPerBand]); });

    // One label space for all bands, and the sets that meet at their borders.
    std::vector<int> offset;
    DisjointSets all;
    all.create();  // 0: none
    for (DisjointSets& band : bands) {
      offset.push_back(all.size() - 1);
      for (int k = 1; k < band.size(); ++k) all.create();
      for (int k = 1; k < band.size(); ++k) all.join(offset.back() + k, offset.back() + band.root(k));
    }
    for (std::size_t b = 1; b < bands.size(); ++b) joinAcross(static_cast<int>(b), offset, all);
    const std::vector<int> number = all.numbers(count);
    --count;
    forRows(threads, [&](int first, int last) {
      const int* final_label = number.data() + offset[first / kRowsPerBand];
      for (int* label = labels_[first]; label != labels_[first] + (last - first) * mask_.cols; ++label) {
        if (*label > 0) *label = final_label[*label];
      }
    });
    return labels_;
  }

 private:
  template <class Work>
  void forRows(int threads, Work&& work) const {
    forRowBands(mask_.rows, threads, work, kRowsPerBand);
  }

  bool near(int pixel, int other, float reach) const {
    return !((points_[other] - points_[pixel]).squaredNorm() > reach * reach);
  }

  void labelBand(int first, int last, DisjointSets& unions) {
    unions.create();  // 0: none
    const int width = mask_.cols;
    const int offsets[4] = {-1, -width - 1, -width, -width + 1};
    int* labels = labels_[0];
    for (int v = first, i = first * width; v < last; ++v) {
      for (int u = 0; u < width; ++u, ++i) {
        labels[i] = 0;
        if (mask_.data[i] == 0) continue;
        const float reach = gap_.at(points_[i].z());
        const bool has_above = v > first;
        const bool exists[4] = {u > 0, u > 0 && has_above, has_above, u + 1 < width && has_above};
        for (int k = 0; k < 4; ++k) {
          if (!exists[k]) continue;
          const int other = labels[i + offsets[k]];
          if (other == 0 || other == labels[i] || !near(i, i + offsets[k], reach)) continue;
          labels[i] = labels[i] == 0 ? other : unions.join(labels[i], other);
        }
        if (labels[i] == 0) labels[i] = unions.create();
      }
    }
  }

  /// Joins what the first row of a band has in common with the row above it.
  void joinAcross(int band, const std::vector<int>& offset, DisjointSets& all) const {
    const int width = mask_.cols, v = band * kRowsPerBand;
    const int* labels = labels_[0];
    for (int u = 0; u < width; ++u) {
      const int i = v * width + u;
      if (labels[i] == 0) continue;
      const float reach = gap_.at(points_[i].z());
      for (int x = std::max(0, u - 1); x <= std::min(width - 1, u + 1); ++x) {
        const int other = (v - 1) * width + x;
        if (labels[other] == 0 || !near(i, other, reach)) continue;
        all.join(offset[band] + labels[i], offset[band - 1] + labels[other]);
      }
    }
  }

  const std::vector<Eigen::Vector3f>& points_;
  const cv::Mat_<uchar>& mask_;
  const Gap gap_;
  cv::Mat_<int> labels_;
};

}  // namespace

float Gap::at(float z) const {
  return std::max({constant_m, per_depth * z, sigmas * static_cast<float>(noise.sigma(z))});
}

cv::Mat_<int> connectPoints(const std::vector<Eigen::Vector3f>& points, const cv::Mat_<uchar>& mask, const Gap& gap,
                            int& count, int threads) {
  return PointConnector(points, mask, gap).run(threads, count);
}

}  // namespace objectness
