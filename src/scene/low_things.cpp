// SPDX-License-Identifier: BSD-3-Clause
#include "low_things.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "mask_parts.hpp"
#include "objectness_segmentation/common/row_bands.hpp"

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

/// Heights by cell. All of the same size; NaN where none of a cell's pixels may belong to the table.
struct Cells {
  int px = 1;                ///< width of a cell
  cv::Mat_<float> height_m;  ///< mean
  cv::Mat_<float> weight;    ///< share of its pixels that have one
  cv::Mat_<uchar> of_table;  ///< 255 = most are within the noise of the table
};

Cells makeCells(const HeightMap& map, const cv::Mat_<uchar>& above, int threads) {
  Cells cells;
  const int width = above.cols, height = above.rows;
  cells.px = std::max(1, (width + kCellsAcross / 2) / kCellsAcross);
  const cv::Size size((width + cells.px - 1) / cells.px, (height + cells.px - 1) / cells.px);
  cells.height_m.create(size), cells.weight.create(size), cells.of_table.create(size);
  forRowBands(size.height, threads, [&](int first, int last) {
    for (int row = first; row < last; ++row) {
      for (int column = 0; column < size.width; ++column) {
        const int right = std::min(width, (column + 1) * cells.px), low = std::min(height, (row + 1) * cells.px);
        float sum = 0;
        int count = 0, level = 0, all = 0;
        for (int v = row * cells.px; v < low; ++v) {
          for (int u = column * cells.px; u < right; ++u) {
            ++all;
            const float h = map.height_m(v, u);
            if (above(v, u) || !map.inside(v, u) || !(std::abs(h) < kNearTableM)) continue;
            sum += h, ++count;
            level += std::abs(h) <= map.threshold_m(v, u);
          }
        }
        cells.height_m(row, column) = sum / std::max(1, count);
        cells.weight(row, column) = count / float(all);
        cells.of_table(row, column) = 2 * level > count ? 255 : 0;
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

/// The surface that the table has for the sensor, over the plane.
cv::Mat_<float> tableSurface(const Cells& cells) {
  const cv::Size size = cells.weight.size();
  const cv::Size coarse((size.width + kCoarse - 1) / kCoarse, (size.height + kCoarse - 1) / kCoarse);
  cv::Mat_<float> surface(size, 0.f);
  for (int round = 0; round < kRounds; ++round) {
    cv::Mat_<float> sums(coarse, 0.f), weights(coarse, 0.f);
    for (int v = 0; v < size.height; ++v) {
      for (int u = 0; u < size.width; ++u) {
        const float residual = cells.height_m(v, u) - surface(v, u), weight = cells.weight(v, u);
        if (!cells.of_table(v, u) || (round > 0 && std::abs(residual) > kOfTableM)) continue;
        sums(v / kCoarse, u / kCoarse) += weight * cells.height_m(v, u);
        weights(v / kCoarse, u / kCoarse) += weight;
      }
    }
    const double sigma = kSmoothCells / kCoarse;
    cv::GaussianBlur(sums, sums, {}, sigma, sigma, cv::BORDER_REPLICATE);
    cv::GaussianBlur(weights, weights, {}, sigma, sigma, cv::BORDER_REPLICATE);
    const cv::Mat_<float> mean = ratio(sums, weights, 1e-3f);
    cv::Mat_<float> large;
    cv::resize(mean, large, {coarse.width * kCoarse, coarse.height * kCoarse}, 0, 0, cv::INTER_LINEAR);
    large(cv::Rect({0, 0}, size)).copyTo(surface);
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
  const MaskParts parts = findParts(mask, Neighbours::kEight);
  std::vector<int> count(parts.count, 0);
  for (const Run& run : parts.runs) {
    for (int u = run.first; u < run.last; ++u) count[run.part] += seeds(run.row, u) != 0;
  }
  for (const Run& run : parts.runs) {
    if (count[run.part] < kMinSeedCells) std::fill(&mask(run.row, run.first), mask[run.row] + run.last, uchar(0));
  }
}

/// Noise of the patches around, told by those that lie under the surface, where nothing stands.
cv::Mat_<float> patchNoise(const Cells& cells, const cv::Mat_<float>& patches) {
  const cv::Size size = patches.size();
  const cv::Size coarse((size.width + kCoarse - 1) / kCoarse, (size.height + kCoarse - 1) / kCoarse);
  cv::Mat_<float> sums(coarse, 0.f), weights(coarse, 0.f);
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      if (!cells.of_table(v, u) || !(patches(v, u) < 0)) continue;
      sums(v / kCoarse, u / kCoarse) += patches(v, u) * patches(v, u);
      weights(v / kCoarse, u / kCoarse) += 1;
    }
  }
  const double sigma = kSmoothCells / kCoarse;
  cv::GaussianBlur(sums, sums, {}, sigma, sigma, cv::BORDER_REPLICATE);
  cv::GaussianBlur(weights, weights, {}, sigma, sigma, cv::BORDER_REPLICATE);
  cv::Mat_<float> noise;
  cv::sqrt(ratio(sums, weights, 1e-3f), noise);
  cv::resize(noise, noise, {coarse.width * kCoarse, coarse.height * kCoarse}, 0, 0, cv::INTER_LINEAR);
  return noise(cv::Rect({0, 0}, size));
}

/// Connected cells of patches that are high enough over the surface.
cv::Mat_<uchar> highPatches(const Cells& cells, const cv::Mat_<float>& patches, const ObjectPointsConfig& config) {
  const cv::Mat_<float> noise_m = patchNoise(cells, patches);
  const float sigmas = static_cast<float>(config.low_sigmas), least_m = static_cast<float>(config.low_min_height_m);
  cv::Mat_<uchar> low(patches.size(), uchar(0)), seeds(patches.size(), uchar(0));
  for (int v = 0; v < low.rows; ++v) {
    for (int u = 0; u < low.cols; ++u) {
      if (!(cells.weight(v, u) > 0)) continue;
      const float wanted_m = std::max(least_m, sigmas * noise_m(v, u));
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
      const uchar* of_row = low[v / cells.px];
      for (int u = 0; u < mask.cols; ++u) {
        const bool may_be = of_row[u / cells.px] && !above(v, u) && map.inside(v, u);
        if (may_be && std::abs(map.height_m(v, u)) < kNearTableM) mask(v, u) = 255;
      }
    }
  });
  return mask;
}

}  // namespace objectness
