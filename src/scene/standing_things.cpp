// SPDX-License-Identifier: BSD-3-Clause
#include "standing_things.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace objectness {
namespace {

constexpr float kGapM = 0.01f;
constexpr float kGapPixels = 3.0f;   // of z / f
constexpr float kGapSigmas = 4.0f;
constexpr int kMinPixels = 200;      // when the area is too small
constexpr double kMaxShareOverCeiling = 0.1;

/// Labels that turn out to be the same.
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

struct Thing {
  int pixels = 0, inside = 0, too_high = 0;
  double area_m2 = 0;
};

}  // namespace

Things findThings(const Frame& frame, const Table& table, const HeightMap& map, const ObjectPointsConfig& config,
                  const cv::Mat_<uchar>& mask) {
  const int width = frame.width(), height = frame.height();
  const float pixel = kGapPixels / static_cast<float>(frame.camera.focal());
  cv::Mat_<int> label(height, width, 0);
  Unions unions;
  const int offsets[4] = {-1, -width - 1, -width, -width + 1};
  int* labels = label.ptr<int>();
  for (int v = 0, i = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u, ++i) {
      if (mask.data[i] == 0) continue;
      const Eigen::Vector3f& p = frame.points[i];
      const float z = p.z();
      const float gap = std::max({kGapM, pixel * z, kGapSigmas * static_cast<float>(table.noise.sigma(z))});
      const bool exists[4] = {u > 0, u > 0 && v > 0, v > 0, u + 1 < width && v > 0};
      for (int k = 0; k < 4; ++k) {
        if (!exists[k]) continue;
        const int other = labels[i + offsets[k]];
        if (other == 0 || (frame.points[i + offsets[k]] - p).squaredNorm() > gap * gap) continue;
        labels[i] = labels[i] == 0 ? unions.root(other) : unions.join(labels[i], other);
      }
      if (labels[i] == 0) labels[i] = unions.create();
    }
  }

  std::vector<Thing> things(unions.size());
  const double focal = frame.camera.focal();
  for (int i = 0; i < frame.size(); ++i) {
    if (labels[i] == 0) continue;
    labels[i] = unions.root(labels[i]);
    Thing& thing = things[labels[i]];
    const double z = frame.points[i].z();
    ++thing.pixels;
    thing.inside += map.inside.data[i] != 0;
    thing.too_high += reinterpret_cast<const float*>(map.height_m.data)[i] > config.max_height_m;
    thing.area_m2 += z * z / (focal * focal);
  }
  Things result{label, 0};
  std::vector<int> final_label(things.size(), 0);
  for (std::size_t k = 1; k < things.size(); ++k) {
    const Thing& thing = things[k];
    const bool stands = thing.pixels > 0 && (thing.area_m2 >= config.min_area_m2 || thing.pixels >= kMinPixels) &&
                        thing.inside >= config.min_inside_share * thing.pixels &&
                        thing.too_high <= kMaxShareOverCeiling * thing.pixels;
    if (stands) final_label[k] = ++result.count;
  }
  for (int i = 0; i < frame.size(); ++i) labels[i] = final_label[labels[i]];
  return result;
}

}  // namespace objectness
