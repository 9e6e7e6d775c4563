// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/cues/edges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "cues/cue_steps.hpp"
#include "cues/depth_edges.hpp"
#include "cues/pcl_edges.hpp"
#include "scene/connected_components_2d.hpp"

namespace objectness {
namespace {

/// Height over the table that noise does not reach, as for object points. Noise is along the ray: on a plane seen at a
/// grazing angle it moves points little in height.
double tableClearance(const Frame& frame, const Table& table, int u, int v) {
  const ObjectPointsConfig defaults;
  const Eigen::Vector3d point = frame.points[v * frame.width() + u].cast<double>();
  const double foreshortening = std::abs(table.normal.dot(point)) / point.z();
  return std::clamp(defaults.noise_sigmas * table.noise.sigma(point.z()) * foreshortening, defaults.min_threshold_m,
                    defaults.max_threshold_m);
}

cv::Mat_<uchar> grown(const cv::Mat_<uchar>& mask, int radius) {
  cv::Mat_<uchar> result;
  cv::dilate(mask, result, cv::getStructuringElement(cv::MORPH_RECT, {2 * radius + 1, 2 * radius + 1}));
  return result;
}

/// The widest normal window on an object: how far from the objects' points a crease between object and table can lie.
int widestWindow(const Normals& normals, const ObjectPoints& object_points) {
  int radius = 1;
  for (int i = 0; i < static_cast<int>(normals.radius_px.size()); ++i) {
    if (object_points.mask(i)) radius = std::max<int>(radius, normals.radius_px[i]);
  }
  return radius;
}

cv::Mat_<uchar> findMetricEdges(const Frame& frame, const Normals& normals, const Table& table,
                                const ObjectPoints& object_points, const EdgeRegion& region, const BendMap& bends,
                                const EdgesConfig& config, int threads) {
  // Which edges are kept depends on the pixels beside them, too.
  const cv::Point first(std::max(0, region.box.x - 1), std::max(0, region.box.y - 1));
  cv::Mat_<uchar> kinds = findDepthEdges(frame, normals, table.noise, config, threads, first);
  const cv::Mat_<uchar> creases = thinCreases(bends, normals, region.near, config.crease_deg, threads);
  // Outside the objects' mask only where one meets the table: a concave crease.
  const cv::Rect& box = region.box;
  cv::Mat_<uchar> in_box = kinds(box);
  in_box.setTo(kHighCurvature,
               creases(box) & (in_box == 0) & (object_points.mask(box) | (bends.concave(box) > bends.convex(box))));
  return kinds;
}

bool besideOccluded(const cv::Mat_<uchar>& kinds, int u, int v) {
  for (int y = std::max(0, v - 1); y <= std::min(kinds.rows - 1, v + 1); ++y) {
    for (int x = std::max(0, u - 1); x <= std::min(kinds.cols - 1, u + 1); ++x) {
      if (kinds(y, x) & kOccluded) return true;
    }
  }
  return false;
}

/// Keeps the edges of objects: shadows' outlines on the table, its rim, and creases that are the foot of a jump go.
cv::Mat_<uchar> cleaned(const cv::Mat_<uchar>& kinds, const Frame& frame, const Table& table,
                        const ObjectPoints& object_points, const EdgeRegion& region) {
  cv::Mat_<uchar> kept = cv::Mat_<uchar>::zeros(kinds.size());
  for (int v = region.box.y; v < region.box.br().y; ++v) {
    for (int u = region.box.x; u < region.box.br().x; ++u) {
      const uchar found = kinds(v, u);
      if (found == 0 || !region.near(v, u)) continue;
      const double clearance = tableClearance(frame, table, u, v);
      const double height = object_points.height_m(v, u);
      if (height < -clearance || ((found & kOccluded) && height < 2 * clearance)) continue;
      uchar kind = found;
      if (!object_points.mask(v, u)) kind &= kHighCurvature;  // where an object meets the table lies outside its mask
      if ((kind & kHighCurvature) && besideOccluded(kinds, u, v)) kind &= ~kHighCurvature;
      kept(v, u) = kind;
    }
  }
  return kept;
}

/// Drops connected edges that span less than min_length_m: noise around holes and at the rim of what depth is measured.
void dropSpecks(const Frame& frame, double min_length_m, cv::Mat_<uchar>& kinds) {
  const MaskComponents parts = findComponents(kinds, Neighbours::kEight);
  std::vector<cv::Rect> boxes(parts.count);
  std::vector<double> nearest(parts.count, std::numeric_limits<double>::max());
  for (const Run& run : parts.runs) {
    boxes[run.part] |= cv::Rect(run.first, run.row, run.last - run.first, 1);
    for (int u = run.first; u < run.last; ++u) {
      nearest[run.part] = std::min<double>(nearest[run.part], frame.points[run.row * frame.width() + u].z());
    }
  }
  for (const Run& run : parts.runs) {
    const int length_px = std::max(boxes[run.part].width, boxes[run.part].height);
    if (length_px * nearest[run.part] >= min_length_m * frame.camera.focal()) continue;
    std::fill(kinds[run.row] + run.first, kinds[run.row] + run.last, uchar(0));
  }
}

}  // namespace

EdgeRegion edgeRegion(const Normals& normals, const ObjectPoints& object_points) {
  const int window = widestWindow(normals, object_points);
  const cv::Mat_<uchar> near = grown(object_points.mask, window);
  return {near, grown(near, window), cv::boundingRect(near)};
}

EdgeMap findEdges(const Frame& frame, const Normals& normals, const Table& table, const ObjectPoints& object_points,
                  const EdgeRegion& region, const BendMap& bends, const EdgesConfig& config, int threads) {
  if (region.box.empty()) return {cv::Mat_<uchar>(object_points.mask.size(), uchar(0))};
  const cv::Mat_<uchar> found =
      config.pcl ? findPclEdges(frame, normals)
                 : findMetricEdges(frame, normals, table, object_points, region, bends, config, threads);
  cv::Mat_<uchar> kinds = cleaned(found, frame, table, object_points, region);
  dropSpecks(frame, config.min_length_m, kinds);
  return {kinds};
}

EdgeMap findEdges(const Frame& frame, const Normals& normals, const Table& table, const ObjectPoints& object_points,
                  const EdgesConfig& config, int threads) {
  const EdgeRegion region = edgeRegion(normals, object_points);
  const BendMap bends = config.pcl ? BendMap() : findBends(frame, normals, region.around, threads);
  return findEdges(frame, normals, table, object_points, region, bends, config, threads);
}

}  // namespace objectness
