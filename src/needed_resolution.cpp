// SPDX-License-Identifier: BSD-3-Clause
#include "needed_resolution.hpp"

#include "common/row_bands.hpp"
#include "segments/segments.hpp"

namespace objectness {
namespace {

/// An image of the frame's size; `none` where a pixel has no block.
template <class T>
void spread(const std::vector<int>& blocks, const cv::Size& size, T none, int threads, cv::Mat_<T>& image) {
  if (image.empty()) return;
  cv::Mat_<T> fine(size);
  const T* coarse = image.template ptr<T>();  // continuous: the stages make it
  forRowBands(size.height, threads, [&](int first, int last) {
    for (int v = first; v < last; ++v) {
      const int* block = blocks.data() + static_cast<std::size_t>(v) * size.width;
      T* row = fine[v];
      for (int u = 0; u < size.width; ++u) row[u] = block[u] >= 0 ? coarse[block[u]] : none;
    }
  });
  image = fine;
}

}  // namespace

void spreadOverPixels(const Frame& frame, const Frame& coarse, int factor, int threads, Segmentation& result) {
  const cv::Size size(frame.width(), frame.height());
  const std::vector<int> blocks = blocksOf(frame, coarse, factor, threads);
  result.normals = {};
  spread(blocks, size, uchar(0), threads, result.object_points.mask);
  spread(blocks, size, uchar(0), threads, result.object_points.on_table);
  spread(blocks, size, uchar(0), threads, result.object_points.container);
  spread(blocks, size, uchar(0), threads, result.edges.kinds);
  spread(blocks, size, 0, threads, result.superpixels.label);
  if (!result.object_points.height_m.empty()) {
    const Eigen::Vector3f normal = result.table.normal.cast<float>();
    const float d = static_cast<float>(result.table.d);
    cv::Mat_<float> height_m(size);
    forRowBands(size.height, threads, [&](int first, int last) {
      for (int v = first, i = first * size.width; v < last; ++v) {
        for (int u = 0; u < size.width; ++u, ++i) height_m(v, u) = normal.dot(frame.points[i]) + d;
      }
    });
    result.object_points.height_m = height_m;
  }

  std::vector<int> segment_of(coarse.points.size(), -1);
  for (std::size_t k = 0; k < result.segments.size(); ++k) {
    for (const int block : result.segments[k].pixels) segment_of[block] = static_cast<int>(k);
    result.segments[k].pixels.clear();
  }
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (blocks[i] < 0 || segment_of[blocks[i]] < 0) continue;
    result.segments[segment_of[blocks[i]]].pixels.push_back(static_cast<int>(i));
  }
  for (Unmeasured& thing : result.unmeasured) thing.pixels *= factor * factor;
  keepMeasured(frame.bridged, result.segments);
  dropEmpty(result.segments);
  const bool labelled = !result.object_points.on_table.empty() && result.status.ok();
  result.labels = labelled ? labelImage(result.object_points.on_table, frame.bridged, result.segments)
                           : cv::Mat_<ushort>(size, static_cast<ushort>(0));
}

}  // namespace objectness
