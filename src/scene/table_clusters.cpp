// SPDX-License-Identifier: BSD-3-Clause
#include "scene/table_clusters.hpp"

#include <algorithm>
#include <cmath>

#include "common/row_bands.hpp"
#include "scene/connected_components_3d.hpp"
#include "scene/picture_margin.hpp"

namespace objectness {
namespace {

constexpr float kGapM = 0.01f;
constexpr double kGapPixels = 3.0;  // of z / f
constexpr float kGapSigmas = 4.0f;
constexpr int kMinPixels = 200;  // when the area is too small
constexpr double kMaxShareOverCeiling = 0.1;
constexpr double kTallestStack = 2.0;  // times the ceiling
constexpr int kRowsPerBand = 60;
constexpr int kManyParts = 10000;      // above this, sums per band cost more memory than they save time
constexpr double kWhollyInside = 0.9;  // a share of the points; the rest is noise at the outline

struct Cluster {
  int pixels = 0, inside = 0, beyond = 0, too_high = 0, far_too_high = 0;
  bool at_border = false;    ///< of the picture
  bool near_border = false;  ///< within its margin
  double area_m2 = 0;

  void add(const Cluster& part) {
    pixels += part.pixels, inside += part.inside, beyond += part.beyond, too_high += part.too_high,
        far_too_high += part.far_too_high;
    at_border = at_border || part.at_border;
    near_border = near_border || part.near_border;
    area_m2 += part.area_m2;
  }
};

/// Points on the table. Beyond what is seen of it, things count that are wholly in the picture: an arm, a chair or a
/// shelf that comes from out of it need not stand on the table at all.
int onTable(const Cluster& cluster) { return cluster.inside + (cluster.near_border ? 0 : cluster.beyond); }

/// A tall stack: no arm or wall that comes from beside the table or from out of the picture.
bool isTallStack(const Cluster& cluster) {
  return !cluster.at_border && cluster.inside >= kWhollyInside * cluster.pixels &&
         cluster.far_too_high <= kMaxShareOverCeiling * cluster.pixels;
}

}  // namespace

TableClusters findTableClusters(const Frame& frame, const Table& table, const HeightMap& map,
                                const ObjectPointsConfig& config, const cv::Mat_<uchar>& mask, int threads) {
  const double focal = frame.camera.focal();
  const Gap gap{kGapM, static_cast<float>(kGapPixels / focal), kGapSigmas, table.noise};
  int parts = 0;
  cv::Mat_<int> label = connectPoints(frame.points, mask, gap, parts, threads);
  int* labels = label.ptr<int>();

  const auto measure = [&](int first, int last, std::vector<Cluster>& clusters) {
    for (int v = first, i = first * mask.cols; v < last; ++v) {
      for (int u = 0; u < mask.cols; ++u, ++i) {
        if (labels[i] == 0) continue;
        Cluster& cluster = clusters[labels[i]];
        const double z = frame.points[i].z();
        ++cluster.pixels;
        const int to_border = pixelsToBorder(u, v, mask.size());
        cluster.at_border = cluster.at_border || to_border == 0;
        cluster.near_border = cluster.near_border || to_border < kPictureMarginPx;
        cluster.inside += map.inside(v, u) != 0;
        if (!map.beyond.empty()) cluster.beyond += map.beyond(v, u) != 0;
        cluster.too_high += map.height_m(v, u) > config.max_height_m;
        cluster.far_too_high += map.height_m(v, u) > kTallestStack * config.max_height_m;
        cluster.area_m2 += z * z / (focal * focal);
      }
    }
  };
  // Fixed bands: a float sum must not depend on the number of threads.
  const int rows_per_band = parts > kManyParts ? mask.rows : kRowsPerBand;
  std::vector<std::vector<Cluster>> in_band((mask.rows + rows_per_band - 1) / rows_per_band);
  forRowBands(
      mask.rows, threads,
      [&](int first, int last) {
        in_band[first / rows_per_band].resize(parts + 1);
        measure(first, last, in_band[first / rows_per_band]);
      },
      rows_per_band);
  std::vector<Cluster> clusters(parts + 1);
  for (const std::vector<Cluster>& band : in_band) {
    for (std::size_t k = 1; k < clusters.size(); ++k) clusters[k].add(band[k]);
  }
  TableClusters result{label, 0};
  std::vector<int> final_label(clusters.size(), 0);
  for (std::size_t k = 1; k < clusters.size(); ++k) {
    const Cluster& cluster = clusters[k];
    const bool stands = (cluster.area_m2 >= config.min_area_m2 || cluster.pixels >= kMinPixels) &&
                        onTable(cluster) >= config.min_inside_share * cluster.pixels &&
                        (cluster.too_high <= kMaxShareOverCeiling * cluster.pixels || isTallStack(cluster));
    if (stands) final_label[k] = ++result.count;
  }
  forRowBands(mask.rows, threads, [&](int first, int last) {
    for (int i = first * mask.cols; i < last * mask.cols; ++i) {
      if (labels[i] > 0) labels[i] = final_label[labels[i]];
    }
  });
  return result;
}

}  // namespace objectness
