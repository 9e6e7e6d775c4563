// SPDX-License-Identifier: BSD-3-Clause
#include "scene/low_things.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "common/row_bands.hpp"
#include "scene/connected_components_2d.hpp"

namespace objectness {
namespace {

constexpr int kCellsAcross = 320;     // the picture is looked at in cells of so many across
constexpr float kNearTableM = 0.03f;  // heights of what may belong to the table
constexpr float kClipM = 0.012f;      // one outlier does not lift a patch
constexpr float kOfTableM = 0.005f;   // residuals of the table's surface
constexpr int kCoarse = 4;            // cells of the smooth surface are so many times as large
constexpr double kSmoothCells = 24;   // sigma of its smoothing
constexpr int kRounds = 3;            // of leaving out what lies over it
constexpr int kPatchCells = 5;
constexpr float kMinPatchShare = 0.3f;  // of its pixels that have a height
constexpr float kLowShare = 0.5f;       // of what is wanted, for patches that hang together with such
constexpr int kMinSeedCells = 8;

/// Heights by cell, all of the same size.
struct Cells {
  int px = 1;                ///< width of a cell
  cv::Mat_<float> height_m;  ///< mean of the pixels that may belong to the table or to something low; 0 without such
  cv::Mat_<float> weight;    ///< share of such pixels
  cv::Mat_<uchar> of_table;  ///< 255 = most are within the noise of the table
};

Cells makeCells(const HeightMap& map, const cv::Mat_<uchar>& above, int threads) {
  Cells cells;
  const int width = above.cols, height = above.rows;
  cells.px = std::max(1, (width + kCellsAcross / 2) / kCellsAcross);
  const cv::Size size((width + cells.px - 1) / cells.px, (height + cells.px - 1) / cells.px);
  cells.height_m.create(size), cells.weight.create(size), cells.of_table.create(size);
  forRowBands(size.height, threads, [&](int first, int last) {
    std::vector<float> sum(size.width);
    std::vector<int> count(size.width), level(size.width);
    for (int row = first; row < last; ++row) {
      std::fill(sum.begin(), sum.end(), 0.f);
      std::fill(count.begin(), count.end(), 0);
      std::fill(level.begin(), level.end(), 0);
      const int low = std::min(height, (row + 1) * cells.px);
      for (int v = row * cells.px; v < low; ++v) {
        const float *heights = map.height_m[v], *threshold = map.threshold_m[v];
        const uchar *inside = map.inside[v], *tall = above[v];
        for (int u = 0, column = 0, next = cells.px; u < width; ++u) {
          if (u == next) ++column, next += cells.px;
          const float h = heights[u];
          if (tall[u] || !inside[u] || !(std::abs(h) < kNearTableM)) continue;
          sum[column] += h;
          ++count[column];
          level[column] += std::abs(h) <= threshold[u];
        }
      }
      for (int column = 0; column < size.width; ++column) {
        const int columns = std::min(width, (column + 1) * cells.px) - column * cells.px;
        const int all = columns * (low - row * cells.px);
        cells.height_m(row, column) = sum[column] / std::max(1, count[column]);
        cells.weight(row, column) = count[column] / float(all);
        cells.of_table(row, column) = 2 * level[column] > count[column] ? 255 : 0;
      }
    }
  });
  return cells;
}

/// Mean of values by their weights, where there are weights around; otherwise 0.
cv::Mat_<float> ratio(const cv::Mat_<float>& sums, const cv::Mat_<float>& weights, float least) {
  cv::Mat_<float> mean(sums.size(), 0.f);
  for (int v = 0; v < sums.rows; ++v) {
    for (int u = 0; u < sums.cols; ++u) {
      if (weights(v, u) > least) mean(v, u) = sums(v, u) / weights(v, u);
    }
  }
  return mean;
}

/// Smooth mean of what some of the cells say.
class SmoothMean {
 public:
  explicit SmoothMean(const cv::Size& cells)
      : cells_(cells),
        sums_((cells.height + kCoarse - 1) / kCoarse, (cells.width + kCoarse - 1) / kCoarse, 0.f),
        weights_(sums_.size(), 0.f) {}

  void add(int row, int column, float value, float weight) {
    sums_(row / kCoarse, column / kCoarse) += weight * value;
    weights_(row / kCoarse, column / kCoarse) += weight;
  }
  /// By cell. 0 far from all that was added.
  cv::Mat_<float> byCell() const {
    const double sigma = kSmoothCells / kCoarse;
    cv::Mat_<float> sums, weights, mean;
    cv::GaussianBlur(sums_, sums, {}, sigma, sigma, cv::BORDER_REPLICATE);
    cv::GaussianBlur(weights_, weights, {}, sigma, sigma, cv::BORDER_REPLICATE);
    const cv::Size whole(sums.cols * kCoarse, sums.rows * kCoarse);
    cv::resize(ratio(sums, weights, 1e-3f), mean, whole, 0, 0, cv::INTER_LINEAR);
    return mean(cv::Rect({0, 0}, cells_));
  }

 private:
  cv::Size cells_;
  cv::Mat_<float> sums_, weights_;
};

/// The surface that the table has for the sensor, over the plane.
cv::Mat_<float> tableSurface(const Cells& cells) {
  const cv::Size size = cells.weight.size();
  cv::Mat_<float> surface(size, 0.f);
  for (int round = 0; round < kRounds; ++round) {
    SmoothMean mean(size);
    for (int v = 0; v < size.height; ++v) {
      for (int u = 0; u < size.width; ++u) {
        const bool off = round > 0 && std::abs(cells.height_m(v, u) - surface(v, u)) > kOfTableM;
        if (cells.of_table(v, u) && !off) mean.add(v, u, cells.height_m(v, u), cells.weight(v, u));
      }
    }
    surface = mean.byCell();
  }
  return surface;
}

/// Mean residual of the patch around each cell.
cv::Mat_<float> patchHeights(const Cells& cells, const cv::Mat_<float>& surface) {
  cv::Mat_<float> sums(surface.size()), weights;
  for (int v = 0; v < surface.rows; ++v) {
    for (int u = 0; u < surface.cols; ++u) {
      const float residual = cells.height_m(v, u) - surface(v, u);
      sums(v, u) = cells.weight(v, u) * std::max(-kClipM, std::min(kClipM, residual));
    }
  }
  const cv::Size patch(kPatchCells, kPatchCells);
  cv::boxFilter(sums, sums, -1, patch, {-1, -1}, true, cv::BORDER_REPLICATE);
  cv::boxFilter(cells.weight, weights, -1, patch, {-1, -1}, true, cv::BORDER_REPLICATE);
  return ratio(sums, weights, kMinPatchShare);
}

/// Takes away the connected parts that have few cells of `seeds`.
void keepSeeded(const cv::Mat_<uchar>& seeds, cv::Mat_<uchar>& mask) {
  const MaskComponents parts = findComponents(mask, Neighbours::kEight);
  std::vector<int> count(parts.count, 0);
  for (const Run& run : parts.runs) {
    for (int u = run.first; u < run.last; ++u) count[run.part] += seeds(run.row, u) != 0;
  }
  for (const Run& run : parts.runs) {
    if (count[run.part] < kMinSeedCells) std::fill(&mask(run.row, run.first), mask[run.row] + run.last, uchar(0));
  }
}

/// Variance of the patches around, told by those that lie under the surface, where nothing stands. Square metres.
cv::Mat_<float> patchVariance(const Cells& cells, const cv::Mat_<float>& patches) {
  SmoothMean mean(patches.size());
  for (int v = 0; v < patches.rows; ++v) {
    for (int u = 0; u < patches.cols; ++u) {
      const float height_m = patches(v, u);
      if (cells.of_table(v, u) && height_m < 0) mean.add(v, u, height_m * height_m, 1);
    }
  }
  return mean.byCell();
}

/// Connected cells of patches that are high enough over the surface.
cv::Mat_<uchar> highPatches(const Cells& cells, const cv::Mat_<float>& patches, const ObjectPointsConfig& config) {
  const cv::Mat_<float> variance = patchVariance(cells, patches);
  const float sigmas = static_cast<float>(config.low_sigmas), least_m = static_cast<float>(config.low_min_height_m);
  cv::Mat_<uchar> low(patches.size(), uchar(0)), seeds(patches.size(), uchar(0));
  for (int v = 0; v < low.rows; ++v) {
    for (int u = 0; u < low.cols; ++u) {
      if (!(cells.weight(v, u) > 0)) continue;
      const float wanted_m = std::max(least_m, sigmas * std::sqrt(variance(v, u)));
      if (patches(v, u) > kLowShare * wanted_m) low(v, u) = 255;
      if (patches(v, u) > wanted_m) seeds(v, u) = 255;
    }
  }
  cv::morphologyEx(low, low, cv::MORPH_OPEN, cv::Mat::ones(3, 3, CV_8U));
  keepSeeded(seeds, low);
  return low;
}

}  // namespace

cv::Mat_<uchar> lowThings(const HeightMap& map, const ObjectPointsConfig& config, const cv::Mat_<uchar>& above,
                          int threads) {
  const Cells cells = makeCells(map, above, threads);
  const cv::Mat_<float> patches = patchHeights(cells, tableSurface(cells));
  const cv::Mat_<uchar> low = highPatches(cells, patches, config);
  cv::Mat_<uchar> mask(above.size(), uchar(0));
  forRowBands(mask.rows, threads, [&](int first, int last) {
    for (int v = first; v < last; ++v) {
      const uchar *of_row = low[v / cells.px], *inside = map.inside[v], *tall = above[v];
      const float* heights = map.height_m[v];
      for (int u = 0, column = 0, next = cells.px; u < mask.cols; ++u) {
        if (u == next) ++column, next += cells.px;
        const bool may_be = of_row[column] && !tall[u] && inside[u] && std::abs(heights[u]) < kNearTableM;
        if (may_be) mask(v, u) = 255;
      }
    }
  });
  return mask;
}

}  // namespace objectness
