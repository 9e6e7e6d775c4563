// SPDX-License-Identifier: BSD-3-Clause
#include "scene/support_layer.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace objectness {
namespace {

constexpr float kLayersM = 0.03f;            // layers farther apart than this are hypotheses of their own
constexpr float kMinNormalCosine = 0.9063f;  // 25 deg
constexpr int kMinPerCell = 3;
constexpr int kRounds = 4;
constexpr float kMinStepM = 0.004f;      // between layers that can be told apart
constexpr double kMinLayerShare = 0.12;  // of the cells; less is a dent or an edge
constexpr double kMaxValley = 0.5;       // cells between two layers, per cell of the smaller layer
constexpr float kBinM = 0.001f;

/// A point for each cell of a grid on the plane: less noisy than the samples, and every part of the table counts alike.
struct Patch {
  Eigen::Vector3f point;
  float sigma_m;
};

std::vector<Patch> patchesNear(const SurfaceSamples& view, const Plane& plane, const SeenPlane& seen) {
  struct Member {
    int cell;
    float height;
    const SurfaceSamples::Sample* sample;
  };
  if (seen.grid.empty()) return {};
  const FastPlane fast(plane);
  const Eigen::Matrix<float, 2, 3> axes = seen.grid.T_table_camera.linear().topRows<2>().cast<float>();
  std::vector<Member> found;
  found.reserve(view.samples.size());
  std::vector<int> first(seen.core.total() + 1, 0);  // of the members of each cell, once they are in order
  cv::Point at;
  for (const auto& sample : view.samples) {
    if (!sample.valid() || !sample.hasNormal() || sample.normal.dot(fast.normal) < kMinNormalCosine) continue;
    const float height = fast.height(sample.point);
    if (std::abs(height) > std::max(kLayersM, sample.tolerance())) continue;
    const Eigen::Vector2f foot = axes * sample.point;
    if (!seen.grid.cell(foot.x(), foot.y(), at) || seen.core(at) == 0) continue;
    found.push_back({at.y * seen.core.cols + at.x, height, &sample});
    ++first[found.back().cell + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Member> members(found.size());
  std::vector<int> next(first.begin(), first.end() - 1);
  for (const Member& member : found) members[next[member.cell]++] = member;

  std::vector<Patch> patches;
  for (std::size_t cell = 0; cell + 1 < first.size(); ++cell) {
    const auto begin = members.begin() + first[cell], end = members.begin() + first[cell + 1];
    if (end - begin < kMinPerCell) continue;
    // The median by height: a cell at the edge of a thing must not land between the layers.
    const auto middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end, [](const Member& a, const Member& b) {
      return a.height != b.height ? a.height < b.height : a.sample < b.sample;
    });
    patches.push_back({middle->sample->point, middle->sample->sigma_m});
  }
  return patches;
}

/// Fits to the patches whose height over the plane is within `band` of `centre`, a few times over.
Plane fitLayer(const std::vector<Patch>& patches, Plane plane, float centre, float band) {
  for (int round = 0; round < kRounds; ++round) {
    PlaneFitter fitter;
    const FastPlane fast(plane);
    for (const Patch& patch : patches) {
      const float limit = std::max(band, 1.5f * patch.sigma_m);
      if (std::abs(fast.height(patch.point) - centre) <= limit) {
        fitter.add(patch.point, 1.0 / (double(patch.sigma_m) * patch.sigma_m));
      }
    }
    if (!fitter.solve(plane)) break;
    centre = 0;
  }
  return plane;
}

/// Height of a layer that lies distinctly under the main one, or 0.
float lowerLayer(const std::vector<Patch>& patches, const Plane& plane) {
  const int bins = 2 * static_cast<int>(kLayersM / kBinM) + 1, zero = bins / 2;
  std::vector<double> raw(bins, 0.0), histogram(bins, 0.0);
  const FastPlane fast(plane);
  for (const Patch& patch : patches) {
    const int bin = zero + static_cast<int>(std::lround(fast.height(patch.point) / kBinM));
    if (bin >= 0 && bin < bins) raw[bin] += 1;
  }
  for (int i = 1; i + 1 < bins; ++i) histogram[i] = (raw[i - 1] + raw[i] + raw[i + 1]) / 3;

  const int step = static_cast<int>(kMinStepM / kBinM);
  for (int i = 1; i <= zero - step / 2; ++i) {  // from below: the lowest layer of enough cells
    if (histogram[i] < histogram[i - 1] || histogram[i] < histogram[i + 1]) continue;
    double cells = 0;
    for (int k = std::max(0, i - step / 2); k <= i + step / 2; ++k) cells += raw[k];
    if (cells < kMinLayerShare * patches.size()) continue;
    const auto next = std::max_element(histogram.begin() + i + step, histogram.end());
    const double valley = *std::min_element(histogram.begin() + i, next);
    if (valley < kMaxValley * std::min(histogram[i], *next)) return (i - zero) * kBinM;
  }
  return 0;
}

}  // namespace

Plane settleOnSupportLayer(const SurfaceSamples& view, const Plane& plane, const SeenPlane& seen) {
  const std::vector<Patch> patches = patchesNear(view, plane, seen);
  const Plane fitted = fitLayer(patches, plane, 0, 0.006f);
  const float lower = lowerLayer(patches, fitted);
  return lower < 0 ? fitLayer(patches, fitted, lower, 0.5f * kMinStepM) : fitted;
}

}  // namespace objectness
