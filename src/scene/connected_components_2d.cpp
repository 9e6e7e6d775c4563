// SPDX-License-Identifier: BSD-3-Clause
#include "scene/connected_components_2d.hpp"

#include <cstdint>
#include <cstring>

#include "common/disjoint_sets.hpp"

namespace objectness {
namespace {

/// The first column from `u` on whose being set is `wanted`, or the width.
int seek(const uchar* row, int u, int width, bool wanted) {
  while (u < width) {
    std::uint64_t eight;
    if (u + 8 <= width && (std::memcpy(&eight, row + u, 8), eight == (wanted ? 0 : ~std::uint64_t(0)))) {
      u += 8;
    } else if ((row[u] != 0) == wanted) {
      break;
    } else {
      ++u;
    }
  }
  return u;
}

}  // namespace

MaskComponents findComponents(const cv::Mat_<uchar>& mask, Neighbours neighbours) {
  MaskComponents parts;
  DisjointSets unions;
  const int diagonal = neighbours == Neighbours::kEight ? 1 : 0;
  std::size_t above = 0, above_end = 0;  // the runs of the row before
  for (int v = 0; v < mask.rows; ++v) {
    const std::size_t row_begin = parts.runs.size();
    std::size_t touched = above;
    for (int u = seek(mask.ptr(v), 0, mask.cols, true); u < mask.cols;) {
      const int end = seek(mask.ptr(v), u, mask.cols, false);
      Run run{v, u, end, -1};
      while (touched < above_end && parts.runs[touched].last + diagonal <= u) ++touched;
      for (std::size_t k = touched; k < above_end && parts.runs[k].first < end + diagonal; ++k) {
        run.part = run.part < 0 ? unions.root(parts.runs[k].part) : unions.join(run.part, parts.runs[k].part);
      }
      if (run.part < 0) run.part = unions.create();
      parts.runs.push_back(run);
      u = seek(mask.ptr(v), end, mask.cols, true);
    }
    above = row_begin;
    above_end = parts.runs.size();
  }
  const std::vector<int> number = unions.numbers(parts.count);
  for (Run& run : parts.runs) run.part = number[run.part];
  return parts;
}

}  // namespace objectness
