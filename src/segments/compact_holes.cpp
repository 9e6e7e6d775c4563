// SPDX-License-Identifier: BSD-3-Clause
#include "segments/compact_holes.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "common/share_below.hpp"
#include "scene/connected_components_2d.hpp"

namespace objectness {
namespace {

constexpr double kNoiseShare = 0.9;      // of the frame's own holes
constexpr std::size_t kPriorHoles = 20;  // of a pixel: where there are few, things must not count as noise
constexpr double kRough = 0.9;           // of a radius: what chamfer distances of 3 x 3 pixels make of it, at least
constexpr double kOpening = 0.5;         // of the circle that fits: smaller ones leave the corners

/// A connected part of the pixels without depth.
struct Part {
  cv::Rect box;
  int level_ends = 0, ends = 0;  // of its runs: on the table, all
  std::vector<Run> runs;         // of those that are wide enough to matter
  float radius_px = 1;

  bool isInTable() const { return 2 * level_ends > ends; }
  bool isBesideTable() const { return 4 * level_ends < ends; }
  bool isSpeck() const { return std::min(box.width, box.height) < 3; }
};

/// By part; those that the picture's end cuts are left out.
std::vector<Part> holesWithin(const cv::Mat_<uchar>& no_depth, const cv::Mat_<uchar>& on_table) {
  const MaskComponents parts = findComponents(no_depth, Neighbours::kFour);
  std::vector<Part> holes(parts.count);
  for (const Run& run : parts.runs) {
    Part& part = holes[run.part];
    part.box |= cv::Rect(run.first, run.row, run.last - run.first, 1);
    const uchar* level = on_table[run.row];
    part.level_ends += (run.first > 0 && level[run.first - 1]) + (run.last < no_depth.cols && level[run.last]);
    part.ends += 2;
  }
  const cv::Rect within(1, 1, no_depth.cols - 2, no_depth.rows - 2);
  const auto counts = [&](const Part& part) { return (part.box & within) == part.box; };
  for (const Run& run : parts.runs) {
    Part& part = holes[run.part];
    if (!part.isSpeck() && counts(part)) part.runs.push_back(run);
  }
  holes.erase(std::remove_if(holes.begin(), holes.end(), [&](const Part& part) { return !counts(part); }), holes.end());
  return holes;
}

cv::Rect around(const cv::Rect& box) { return {box.x - 1, box.y - 1, box.width + 2, box.height + 2}; }

cv::Mat_<uchar> paint(const Part& part) {
  const cv::Rect area = around(part.box);
  cv::Mat_<uchar> mask(area.size(), uchar(0));
  for (const Run& run : part.runs) {
    uchar* row = mask[run.row - area.y];
    std::fill(row + run.first - area.x, row + run.last - area.x, uchar(255));
  }
  return mask;
}

/// By pixel of the mask, how far the nearest one is that is 0.
cv::Mat_<float> distanceToZero(const cv::Mat_<uchar>& mask) {
  cv::Mat_<float> distance;
  cv::distanceTransform(mask, distance, cv::DIST_L2, cv::DIST_MASK_5);
  return distance;
}

/// Radius of the largest circle by chamfer distances, which are quick: there are many holes.
float roughRadius(const Part& part) {
  if (part.isSpeck()) return 1;
  cv::Mat_<float> distance;
  cv::distanceTransform(paint(part), distance, cv::DIST_L2, cv::DIST_MASK_3);
  float most = 1;
  for (int v = 0; v < distance.rows; ++v)
    most = std::max(most, *std::max_element(distance[v], distance[v] + distance.cols));
  return most;
}

/// Radius that nine of ten of the frame's own holes in the table do not reach.
float noiseRadius(const std::vector<Part>& holes) {
  std::vector<float> radii(kPriorHoles, 1.0f);
  for (const Part& part : holes) {
    if (part.isInTable()) radii.push_back(part.radius_px);
  }
  return shareBelow(kNoiseShare, radii);
}

/// Pixels that half the wanted width spans at the part's middle; 0 where the table is not seen.
double wantedRadius(const PinholeCamera& camera, const Plane& table, const cv::Rect& box, double width_m) {
  const Eigen::Vector3d ray = camera.ray(box.x + 0.5 * (box.width - 1), box.y + 0.5 * (box.height - 1));
  const double towards = -table.normal.dot(ray);
  return towards > 0 ? 0.5 * width_m * camera.focal() * towards / table.d : 0;
}

/// What circles of the radius cover within the mask.
cv::Mat_<uchar> opened(const cv::Mat_<uchar>& mask, const cv::Mat_<float>& distance, double radius_px) {
  const cv::Mat_<float> to_centre = distanceToZero(distance < radius_px);
  return (to_centre < radius_px) & mask;
}

/// Adds the connected parts of what circles of the radius cover.
void addCores(const cv::Mat_<uchar>& mask, const cv::Mat_<float>& distance, const cv::Point& corner, double radius_px,
              std::vector<CompactHole>& cores) {
  const MaskComponents parts = findComponents(opened(mask, distance, radius_px), Neighbours::kFour);
  const std::size_t before = cores.size();
  cores.resize(before + parts.count);
  for (const Run& run : parts.runs) {
    CompactHole& core = cores[before + run.part];
    core.area |= cv::Rect(run.first, run.row, run.last - run.first, 1);
    core.pixels += run.last - run.first;
  }
  for (auto core = cores.begin() + before; core != cores.end(); ++core) {
    core->area = around(core->area);
    core->mask = cv::Mat_<uchar>(core->area.size(), uchar(0));
  }
  for (const Run& run : parts.runs) {
    CompactHole& core = cores[before + run.part];
    uchar* row = core.mask[run.row - core.area.y];
    std::fill(row + run.first - core.area.x, row + run.last - core.area.x, uchar(255));
    const float* distances = distance[run.row];
    core.radius_px = std::max(core.radius_px, *std::max_element(distances + run.first, distances + run.last));
  }
  for (auto core = cores.begin() + before; core != cores.end(); ++core) core->area += corner;
}

}  // namespace

std::vector<CompactHole> compactHoles(const PinholeCamera& camera, const Plane& table, const cv::Mat_<uchar>& no_depth,
                                      const cv::Mat_<uchar>& on_table, const UnmeasuredConfig& config) {
  std::vector<Part> holes = holesWithin(no_depth, on_table);
  for (Part& part : holes) part.radius_px = roughRadius(part);
  const float noise_px = noiseRadius(holes);
  std::vector<CompactHole> cores;
  for (const Part& part : holes) {
    const double seen_px = wantedRadius(camera, table, part.box, config.min_width_m);
    const double least_px = std::max(seen_px, config.noise_factor * noise_px);
    if (part.isSpeck() || part.isBesideTable() || seen_px == 0 || part.radius_px < kRough * least_px) continue;
    const cv::Mat_<uchar> mask = paint(part);
    const std::size_t before = cores.size();
    addCores(mask, distanceToZero(mask), around(part.box).tl(), std::max(noise_px + 1.0, kOpening * least_px), cores);
    cores.erase(std::remove_if(cores.begin() + before, cores.end(),
                               [&](const CompactHole& core) { return core.radius_px < least_px; }),
                cores.end());
    for (auto core = cores.begin() + before; core != cores.end(); ++core) core->noise_radius_px = noise_px;
  }
  return cores;
}

}  // namespace objectness
