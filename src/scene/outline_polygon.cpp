// SPDX-License-Identifier: BSD-3-Clause
#include "scene/outline_polygon.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstddef>

namespace objectness {
namespace {

constexpr double kToleranceM = 0.006, kInferredToleranceM = 0.012;  // of sides, from their points
constexpr std::size_t kMinRun = 4;                                  // fewer points of a kind in a row are noise
constexpr double kCornerM = 0.015;                                  // so near to the ends of a side it may be rounded
constexpr std::size_t kMinFitted = 5;
constexpr double kMaxShiftM = 0.03;                                             // of a corner, to where its sides meet
constexpr double kMinSine = 0.1;                                                // of the angle between sides that meet
constexpr double kMaxCutM = 0.05, kMaxCutShiftM = 0.025, kMinCornerSine = 0.3;  // of sides that cut off a corner
constexpr double kFlatM = 0.002;

using Places = std::vector<Eigen::Vector2d>;

/// Points in a row that are all measured or all not.
struct Run {
  Places places;
  bool measured = false;
};

/// Whether each point is among measured ones: runs of few points become what their surroundings are.
std::vector<char> kindsOf(const std::vector<OutlinePoint>& points) {
  const std::size_t count = points.size();
  std::vector<char> kinds(count);
  for (std::size_t i = 0; i < count; ++i) kinds[i] = points[i].measured;
  for (const char kind : {char(0), char(1)}) {  // first what is missing between measured points
    const std::vector<char> before = kinds;
    for (std::size_t i = 0; i < count; ++i) {
      if (before[i] != kind || before[(i + count - 1) % count] == kind) continue;
      std::size_t length = 1;
      while (length < count && before[(i + length) % count] == kind) ++length;
      for (std::size_t k = 0; length < kMinRun && k < length; ++k) kinds[(i + k) % count] = !kind;
    }
  }
  return kinds;
}

/// The outline in runs, without the points that are not of their run's kind. A single run is closed and ends with its
/// first point, one that is far from the others: a corner, if there are any.
std::vector<Run> runsOf(const std::vector<OutlinePoint>& points) {
  const std::vector<char> kinds = kindsOf(points);
  const std::size_t count = points.size();
  std::size_t start = 0;
  while (start < count && kinds[start] == kinds[(start + count - 1) % count]) ++start;
  const bool single = start == count;
  std::vector<Run> runs;
  for (std::size_t i = start; i < start + count; ++i) {
    const OutlinePoint& point = points[i % count];
    const bool measured = kinds[i % count] != 0;
    if (runs.empty() || (!single && measured != runs.back().measured)) runs.push_back({{}, measured});
    if (point.measured == measured) runs.back().places.push_back(point.place);
  }
  if (single) {
    Places& places = runs[0].places;
    const Eigen::Vector2d first = places[0];
    std::rotate(places.begin(),
                std::max_element(places.begin(), places.end(),
                                 [&](const auto& a, const auto& b) { return (a - first).norm() < (b - first).norm(); }),
                places.end());
    places.push_back(places[0]);
  }
  return runs;
}

double distanceToLine(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  const double length = along.norm();
  if (!(length > 0)) return (p - a).norm();
  return std::abs(along.x() * (p - a).y() - along.y() * (p - a).x()) / length;
}

/// Adds the places between first and last that Douglas and Peucker keep, in order.
void simplify(const Places& places, std::size_t first, std::size_t last, double tolerance,
              std::vector<std::size_t>& kept) {
  double farthest = tolerance;
  std::size_t split = first;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double distance = distanceToLine(places[i], places[first], places[last]);
    if (distance > farthest) farthest = distance, split = i;
  }
  if (split == first) return;
  simplify(places, first, split, tolerance, kept);
  kept.push_back(split);
  simplify(places, split, last, tolerance, kept);
}

struct Line {
  Eigen::Vector2d through, along;

  Eigen::Vector2d nearest(const Eigen::Vector2d& p) const { return through + along.dot(p - through) * along; }
};

Line fitLine(const Places& places) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const auto& p : places) mean += p / static_cast<double>(places.size());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const auto& p : places) spread += (p - mean) * (p - mean).transpose();
  return {mean, Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvectors().col(1)};
}

/// The line along a side: through its points, or its ends when they are few.
Line lineAlong(const Places& places, std::size_t first, std::size_t last) {
  Places inner;
  for (std::size_t i = first; i <= last; ++i) {
    const double to_end = std::min((places[i] - places[first]).norm(), (places[i] - places[last]).norm());
    if (to_end > kCornerM) inner.push_back(places[i]);
  }
  if (inner.size() >= kMinFitted) return fitLine(inner);
  if (last - first >= kMinFitted) return fitLine({places.begin() + first, places.begin() + last + 1});
  return {places[first], (places[last] - places[first]).normalized()};
}

struct Side {
  Line line;
  Eigen::Vector2d from, to;
};

/// Where two lines meet; false when that is farther than max_shift_m from a place, or they are as good as parallel.
bool meetNear(const Line& a, const Line& b, const Eigen::Vector2d& place, double max_shift_m, double min_sine,
              Eigen::Vector2d& result) {
  const double sine = a.along.x() * b.along.y() - a.along.y() * b.along.x();
  if (std::abs(sine) < min_sine) return false;
  const Eigen::Vector2d between = b.through - a.through;
  result = a.through + (between.x() * b.along.y() - between.y() * b.along.x()) / sine * a.along;
  return (result - place).norm() < max_shift_m;
}

/// The corner between two sides in a row.
Eigen::Vector2d cornerOf(const Side& a, const Side& b) {
  const Eigen::Vector2d about = 0.5 * (a.to + b.from);
  Eigen::Vector2d corner;
  if (meetNear(a.line, b.line, about, kMaxShiftM, kMinSine, corner)) return corner;
  return 0.5 * (a.line.nearest(about) + b.line.nearest(about));
}

/// Leaves out short sides across a corner, as the points next to it make them.
void sharpenCorners(bool closed, std::vector<Side>& sides) {
  for (std::size_t k = closed ? 0 : 1; sides.size() > 3 && k + !closed < sides.size();) {
    const Side &before = sides[(k + sides.size() - 1) % sides.size()], &after = sides[(k + 1) % sides.size()];
    const Side& side = sides[k];
    Eigen::Vector2d ignored;
    const bool is_cut =
        (side.to - side.from).norm() < kMaxCutM &&
        meetNear(before.line, after.line, 0.5 * (side.from + side.to), kMaxCutShiftM, kMinCornerSine, ignored);
    if (is_cut) {
      sides.erase(sides.begin() + k);
    } else {
      ++k;
    }
  }
}

/// The corners of a run; of a closed one the last is the first again.
Places cornersOf(const Run& run, bool closed) {
  const Places& places = run.places;
  const std::size_t last = places.size() - 1;
  std::vector<std::size_t> kept{0};
  simplify(places, 0, last, run.measured ? kToleranceM : kInferredToleranceM, kept);
  if (last > 0) kept.push_back(last);
  Places corners;
  if (!run.measured || last == 0) {
    for (const std::size_t k : kept) corners.push_back(places[k]);
    return corners;
  }
  std::vector<Side> sides;
  for (std::size_t k = 0; k + 1 < kept.size(); ++k) {
    sides.push_back({lineAlong(places, kept[k], kept[k + 1]), places[kept[k]], places[kept[k + 1]]});
  }
  sharpenCorners(closed, sides);
  corners.push_back(closed ? cornerOf(sides.back(), sides.front()) : sides.front().line.nearest(sides.front().from));
  for (std::size_t k = 0; k + 1 < sides.size(); ++k) corners.push_back(cornerOf(sides[k], sides[k + 1]));
  corners.push_back(closed ? corners.front() : sides.back().line.nearest(sides.back().to));
  return corners;
}

/// Whether a corner between two measured sides is as good as on the line between its neighbours.
bool isFlat(const OutlinePolygon& polygon, std::size_t corner) {
  const std::size_t count = polygon.corners.size(), before = (corner + count - 1) % count;
  if (count <= 3 || !polygon.measured[before] || !polygon.measured[corner]) return false;
  return distanceToLine(polygon.corners[corner], polygon.corners[before], polygon.corners[(corner + 1) % count]) <
         kFlatM;
}

}  // namespace

OutlinePolygon polygonThrough(const std::vector<OutlinePoint>& points) {
  OutlinePolygon polygon;
  if (points.size() < 3) return polygon;
  const std::vector<Run> runs = runsOf(points);
  const bool closed = runs.size() == 1;
  for (const Run& run : runs) {
    const Places corners = cornersOf(run, closed);
    for (std::size_t k = 0; k + closed < corners.size(); ++k) {
      polygon.corners.push_back(corners[k]);
      polygon.measured.push_back(run.measured && k + 1 < corners.size());
    }
  }
  for (std::size_t k = 0; k < polygon.corners.size();) {
    if (isFlat(polygon, k)) {
      polygon.corners.erase(polygon.corners.begin() + k);
      polygon.measured.erase(polygon.measured.begin() + k);
    } else {
      ++k;
    }
  }
  return polygon;
}

}  // namespace objectness
