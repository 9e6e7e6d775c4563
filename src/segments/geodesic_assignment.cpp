// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/segments/geodesic_assignment.hpp"

#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <vector>

namespace objectness {

void assignGeodesic(const Frame& frame, const cv::Mat_<uchar>& open, const GeodesicLimits& limits,
                    cv::Mat_<int>& owner) {
  const int width = frame.width(), height = frame.height();
  using Entry = std::tuple<float, int, int>;  // distance, owner, pixel: the order makes ties independent of the queue
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  std::vector<float> distance(frame.size(), std::numeric_limits<float>::infinity());

  const auto visitNeighbours = [&](int pixel, float so_far, int from) {
    const int u = pixel % width, v = pixel / width;
    for (int dv = -1; dv <= 1; ++dv) {
      for (int du = -1; du <= 1; ++du) {
        const int nu = u + du, nv = v + dv;
        if ((du == 0 && dv == 0) || nu < 0 || nv < 0 || nu >= width || nv >= height) continue;
        if (!open(nv, nu) || owner(nv, nu) >= 0) continue;
        const int neighbour = nv * width + nu;
        const float step = (frame.points[neighbour] - frame.points[pixel]).norm();
        const float reach = so_far + step;
        if (!(step <= limits.max_step_m) || reach > limits.max_reach_m || reach >= distance[neighbour]) continue;
        distance[neighbour] = reach;
        queue.emplace(reach, from, neighbour);
      }
    }
  };

  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      if (owner(v, u) >= 0) visitNeighbours(v * width + u, 0, owner(v, u));
    }
  }
  while (!queue.empty()) {
    const auto [so_far, from, pixel] = queue.top();
    queue.pop();
    int& mine = owner(pixel / width, pixel % width);
    if (mine >= 0) continue;
    mine = from;
    visitNeighbours(pixel, so_far, from);
  }
}

}  // namespace objectness
