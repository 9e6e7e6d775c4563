// SPDX-License-Identifier: BSD-3-Clause
#include "needed_resolution.hpp"

namespace objectness {
namespace {

/// An image of the frame's size; `none` where a pixel has no block.
template <class T>
void spread(const std::vector<int>& blocks, const cv::Size& size, T none, cv::Mat_<T>& image) {
  if (image.empty()) return;
  cv::Mat_<T> fine(size, none);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (blocks[i] >= 0)
      fine(static_cast<int>(i) / size.width, static_cast<int>(i) % size.width) =
          image(blocks[i] / image.cols, blocks[i] % image.cols);
  }
  image = fine;
}

}  // namespace

void spreadOverPixels(const Frame& frame, const Frame& coarse, int factor, Segmentation& result) {
  const cv::Size size(frame.width(), frame.height());
  const std::vector<int> blocks = blocksOf(frame, coarse, factor);
  result.normals = {};
  spread(blocks, size, uchar(0), result.object_points.mask);
  spread(blocks, size, uchar(0), result.object_points.on_table);
  spread(blocks, size, uchar(0), result.edges.kinds);
  spread(blocks, size, 0, result.superpixels.label);
  if (!result.object_points.height_m.empty()) {
    const Eigen::Vector3f normal = result.table.normal.cast<float>();
    cv::Mat_<float> height_m(size);
    for (int i = 0; i < frame.size(); ++i) {
      height_m(i / size.width, i % size.width) = normal.dot(frame.points[i]) + static_cast<float>(result.table.d);
    }
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
