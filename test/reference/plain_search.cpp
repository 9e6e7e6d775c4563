// SPDX-License-Identifier: BSD-3-Clause
#include "reference/plain_search.hpp"

#include <algorithm>

#include "search/ranking.hpp"

namespace objectness {

SearchResult searchPlain(const CueVolumes& volumes, int angle, const SearchTask& task) {
  const Sampling& s = task.sampling;
  const Grid& grid = volumes.grid;
  SearchResult result;
  Box box;
  box.angle = angle;
  for (box.x0 = 0; box.x0 + s.min_size <= grid.nx; box.x0 += s.corner_step) {
    for (box.y0 = 0; box.y0 + s.min_size <= grid.ny; box.y0 += s.corner_step) {
      for (box.x1 = box.x0 + s.min_size; box.x1 <= std::min(box.x0 + s.max_size, grid.nx); box.x1 += s.size_step_xy) {
        for (box.y1 = box.y0 + s.min_size; box.y1 <= std::min(box.y0 + s.max_size, grid.ny); box.y1 += s.size_step_xy) {
          for (box.height = s.min_size; box.height <= std::min(s.max_size, grid.nz); box.height += s.size_step_z) {
            ++result.sampled;
            ++result.scored;
            const auto scored = scoreBox(volumes, box, task.ring, task.objectness);
            if (scored && scored->objectness >= task.threshold) result.boxes.push_back(*scored);
          }
        }
      }
    }
  }
  sortBestFirst(result.boxes);
  return result;
}

}  // namespace objectness
