// SPDX-License-Identifier: BSD-3-Clause
#include "scene/resolution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/row_bands.hpp"
#include "common/upper_median.hpp"

namespace objectness {
namespace {

constexpr int kSampleStep = 7;  // of the pixels whose size is looked at
constexpr float kJump = 0.01f;  // of the depth: pixels of a block farther apart are not of one surface

PinholeCamera coarser(PinholeCamera camera, int factor) {
  camera.fx /= factor, camera.fy /= factor;
  // The centre of a block of pixels 0..factor-1 is at (factor - 1) / 2.
  camera.cx = (camera.cx - 0.5 * (factor - 1)) / factor, camera.cy = (camera.cy - 0.5 * (factor - 1)) / factor;
  camera.width = (camera.width + factor - 1) / factor, camera.height = (camera.height + factor - 1) / factor;
  return camera;
}

/// Mean depth of one surface among the depths of a block, NaN where there is none. depths: reordered.
float blockDepth(std::vector<float>& depths, int pixels) {
  if (depths.empty() || 2 * static_cast<int>(depths.size()) < pixels) return std::numeric_limits<float>::quiet_NaN();
  std::sort(depths.begin(), depths.end());
  const auto beyond = [&](std::size_t first) {
    std::size_t end = first + 1;
    while (end < depths.size() && depths[end] - depths[end - 1] <= kJump * depths[end - 1]) ++end;
    return end;
  };
  std::size_t first = 0, end = beyond(0);
  while (end < depths.size() && 2 * (end - first) < depths.size()) first = end, end = beyond(first);
  double sum = 0;
  for (std::size_t k = first; k < end; ++k) sum += depths[k];
  return static_cast<float>(sum / static_cast<double>(end - first));
}

/// See blocksOf().
int blockOf(const Frame& frame, const Frame& coarse, int factor, int u, int v) {
  const float z = frame.points[static_cast<std::size_t>(v) * frame.width() + u].z();
  if (!(z > 0)) return -1;
  const int own = v / factor * coarse.width() + u / factor;
  if (std::abs(coarse.points[own].z() - z) <= kJump * z) return own;
  int block = -1;
  float nearest = std::numeric_limits<float>::infinity();
  for (int row = std::max(0, v / factor - 1); row <= std::min(coarse.height() - 1, v / factor + 1); ++row) {
    for (int column = std::max(0, u / factor - 1); column <= std::min(coarse.width() - 1, u / factor + 1); ++column) {
      const int other = row * coarse.width() + column;
      const float distance = std::abs(coarse.points[other].z() - z);
      if (distance < nearest) nearest = distance, block = other;
    }
  }
  return nearest > 2 * kJump * z ? -1 : block;
}

}  // namespace

int averagedPixels(const Frame& frame, const ResolutionConfig& config) {
  std::vector<float> depths;
  for (std::size_t i = 0; i < frame.points.size(); i += kSampleStep) {
    if (frame.points[i].z() > 0) depths.push_back(frame.points[i].z());
  }
  if (depths.empty()) return 1;
  const double pixel_m = upperMedian(depths) / frame.camera.focal();
  if (pixel_m >= config.finest_pixel_m) return 1;
  const double widest = frame.width() / static_cast<double>(config.min_width_px);
  return std::max(1, static_cast<int>(std::min(2 * config.finest_pixel_m / pixel_m, widest)));
}

Frame averageBlocks(const Frame& frame, int factor, int threads) {
  Frame coarse;
  coarse.camera = coarser(frame.camera, factor);
  coarse.remarks = frame.remarks;
  coarse.rectified = frame.rectified;
  coarse.points.assign(coarse.size(), Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  if (!frame.color.empty()) coarse.color.create(coarse.height(), coarse.width());
  std::vector<char> bridged(frame.bridged.empty() ? 0 : frame.size(), 0);
  for (const int pixel : frame.bridged) bridged[pixel] = 1;
  std::vector<char> only_bridged(bridged.empty() ? 0 : coarse.size(), 0);

  forRowBands(coarse.height(), threads, [&](int first_row, int last_row) {
    std::vector<float> depths;
    for (int row = first_row; row < last_row; ++row) {
      for (int column = 0; column < coarse.width(); ++column) {
        const int last_u = std::min(frame.width(), (column + 1) * factor);
        const int last_v = std::min(frame.height(), (row + 1) * factor);
        depths.clear();
        int pixels = 0, filled = 0;
        cv::Vec3i color(0, 0, 0);
        for (int v = row * factor; v < last_v; ++v) {
          for (int u = column * factor; u < last_u; ++u) {
            const int i = v * frame.width() + u;
            ++pixels;
            if (!frame.color.empty()) color += cv::Vec3i(frame.color(v, u));
            if (!(frame.points[i].z() > 0)) continue;
            depths.push_back(frame.points[i].z());
            filled += !bridged.empty() && bridged[i];
          }
        }
        const int i = row * coarse.width() + column;
        if (!frame.color.empty()) coarse.color(row, column) = color / pixels;
        const int measured = static_cast<int>(depths.size()) - filled;
        const float z = blockDepth(depths, pixels);
        if (!(z > 0)) continue;
        coarse.points[i] = z * coarse.camera.ray(column, row).cast<float>();
        if (measured == 0) only_bridged[i] = 1;
      }
    }
  });
  for (std::size_t i = 0; i < only_bridged.size(); ++i) {
    if (only_bridged[i]) coarse.bridged.push_back(static_cast<int>(i));
  }
  return coarse;
}

std::vector<int> blocksOf(const Frame& frame, const Frame& coarse, int factor, int threads) {
  std::vector<int> blocks(frame.points.size());
  forRowBands(frame.height(), threads, [&](int first, int last) {
    for (int v = first, i = first * frame.width(); v < last; ++v) {
      for (int u = 0; u < frame.width(); ++u, ++i) blocks[i] = blockOf(frame, coarse, factor, u, v);
    }
  });
  return blocks;
}

cv::Mat_<ushort> labelsOfBlocks(const cv::Mat_<ushort>& labels, int factor) {
  if (factor == 1) return labels;
  cv::Mat_<ushort> of_blocks((labels.rows + factor - 1) / factor, (labels.cols + factor - 1) / factor);
  for (int v = 0; v < of_blocks.rows; ++v) {
    const int row = std::min(labels.rows - 1, v * factor + factor / 2);
    for (int u = 0; u < of_blocks.cols; ++u) {
      of_blocks(v, u) = labels(row, std::min(labels.cols - 1, u * factor + factor / 2));
    }
  }
  return of_blocks;
}

}  // namespace objectness
