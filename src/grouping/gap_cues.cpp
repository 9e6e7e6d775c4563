// SPDX-License-Identifier: BSD-3-Clause
#include "grouping/gap_cues.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "common/parallel.hpp"

namespace objectness {
namespace {

constexpr int kSegments = 14;
constexpr int kSamples = 13;             // on each segment
constexpr float kOccluder_m = 0.012;     // a surface this much nearer hides a sample
constexpr float kSeenThrough_m = 0.015;  // one this much farther shows that nothing is there

struct Segment3 {
  float distance;
  int first, second;
};

using Coordinates = Eigen::Array<float, Eigen::Dynamic, 3>;

Coordinates coordinatesOf(const Frame& frame, const std::vector<int>& pixels) {
  Coordinates points(pixels.size(), 3);
  for (std::size_t i = 0; i < pixels.size(); ++i) points.row(i) = frame.points[pixels[i]].transpose().array();
  return points;
}

/// The nearest pairs of outline points, each point in one segment only, so that they spread along the gap.
std::vector<Segment3> nearestSegments(const Frame& frame, const std::vector<int>& first,
                                      const std::vector<int>& second) {
  if (second.empty()) return {};
  const Coordinates others = coordinatesOf(frame, second);
  Eigen::ArrayXf distances(others.rows());
  std::vector<Segment3> all;
  all.reserve(first.size());
  for (const int a : first) {
    const Eigen::Vector3f& p = frame.points[a];
    distances =
        (others.col(0) - p.x()).square() + ((others.col(1) - p.y()).square() + (others.col(2) - p.z()).square());
    const float least = distances.minCoeff();
    const auto nearest = std::find(distances.data(), distances.data() + distances.size(), least) - distances.data();
    all.push_back({least, a, second[nearest]});
  }
  const std::size_t kept = std::min<std::size_t>(kSegments, all.size());
  std::partial_sort(all.begin(), all.begin() + kept, all.end(), [](const Segment3& x, const Segment3& y) {
    return std::tie(x.distance, x.first) < std::tie(y.distance, y.first);
  });
  all.resize(kept);
  for (Segment3& segment : all) segment.distance = std::sqrt(segment.distance);
  return all;
}

struct Counts {
  int occluded = 0, free = 0, surface = 0;
};

Counts lookAlong(const Frame& frame, const cv::Mat_<uchar>& on_table, const Eigen::Vector3f& from,
                 const Eigen::Vector3f& to) {
  Counts counts;
  for (int k = 1; k <= kSamples; ++k) {
    const Eigen::Vector3f p = from + (to - from) * (static_cast<float>(k) / (kSamples + 1));
    const Eigen::Vector2d pixel = frame.camera.project(p.cast<double>());
    const int u = static_cast<int>(std::lround(pixel.x())), v = static_cast<int>(std::lround(pixel.y()));
    if (u < 0 || v < 0 || u >= frame.width() || v >= frame.height()) continue;
    const float z = frame.points[v * frame.width() + u].z();
    if (std::isnan(z)) continue;
    if (z < p.z() - kOccluder_m)
      ++counts.occluded;
    else if (z > p.z() + kSeenThrough_m || on_table(v, u))  // low things lie hardly over the table that is seen
      ++counts.free;
    else
      ++counts.surface;
  }
  return counts;
}

}  // namespace

std::vector<std::vector<int>> outlinePixels(const Pieces& pieces, int most, int threads) {
  std::vector<std::vector<int>> outlines(pieces.count());
  const int width = pieces.label.cols, height = pieces.label.rows;
  parallelFor(pieces.count(), threads, [&](int k) {
    std::vector<int> all;
    for (const int pixel : pieces.pieces[k].pixels) {
      const int u = pixel % width, v = pixel / width;
      const bool inner = u > 0 && v > 0 && u + 1 < width && v + 1 < height && pieces.label(pixel - 1) == k &&
                         pieces.label(pixel + 1) == k && pieces.label(pixel - width) == k &&
                         pieces.label(pixel + width) == k;
      if (!inner) all.push_back(pixel);
    }
    const std::size_t kept = std::min<std::size_t>(most, all.size());
    for (std::size_t i = 0; i < kept; ++i) outlines[k].push_back(all[i * all.size() / kept]);
  });
  return outlines;
}

std::optional<GapCues> findGapCues(const Frame& frame, const Table& table, const ObjectPoints& object_points,
                                   const Pieces& pieces, const std::vector<std::vector<int>>& outlines, int first,
                                   int second, double max_distance_m) {
  const std::vector<Segment3> segments = nearestSegments(frame, outlines[first], outlines[second]);
  if (segments.empty() || segments.front().distance > max_distance_m) return std::nullopt;
  const Piece& a = pieces.pieces[first];
  const Piece& b = pieces.pieces[second];
  GapCues cues;
  const float samples = static_cast<float>(kSamples * segments.size());
  const Eigen::Vector3f n_a = a.mean_normal.normalized(), n_b = b.mean_normal.normalized();
  for (const Segment3& s : segments) {
    const Counts counts = lookAlong(frame, object_points.on_table, frame.points[s.first], frame.points[s.second]);
    cues.occluded_share += counts.occluded / samples;
    cues.free_share += counts.free / samples;
    cues.surface_share += counts.surface / samples;
    cues.best_occluded = std::max(cues.best_occluded, counts.occluded / static_cast<float>(kSamples));
    cues.most_free = std::max(cues.most_free, counts.free / static_cast<float>(kSamples));
    const Eigen::Vector3f between = frame.points[s.second] - frame.points[s.first];
    const float noise = static_cast<float>(table.noise.sigma(frame.points[s.first].z()));
    cues.flush += std::max(std::abs(n_a.dot(between)), std::abs(n_b.dot(between))) / (noise * segments.size());
  }
  const Eigen::Vector3f apart = b.centroid - a.centroid;
  cues.cosine = n_a.dot(n_b);
  cues.plane_offset = std::max(std::abs(n_a.dot(apart)), std::abs(n_b.dot(apart))) / apart.norm();
  cues.distance = segments.front().distance / std::sqrt(std::min(a.area_m2, b.area_m2));
  cues.size_ratio = std::min(a.area_m2, b.area_m2) / std::max(a.area_m2, b.area_m2);
  return cues;
}

}  // namespace objectness
