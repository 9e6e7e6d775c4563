// SPDX-License-Identifier: BSD-3-Clause
#include "segments/supports.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "common/convex_area.hpp"
#include "common/share_below.hpp"
#include "scene/connected_components_2d.hpp"

namespace objectness {
namespace {

constexpr std::size_t kPoints = 1200;  // of a thing; as many tell its top to a millimetre
constexpr int kMinLeftPixels = 60;     // of a part of no segment that may carry something
constexpr std::size_t kMinPoints = 8;
constexpr double kFew = 0.03;                          // share of a thing's points that may belong to what is under it
constexpr float kMinToleranceM = 0.005f, kSigmas = 3;  // a top may lie this far over the lowest points of what is on it
constexpr float kNearM = 0.02f;                        // the top of a thing is seen this near to what stands on it
constexpr float kFlushM = 0.006f;                      // faces of things on one another that are flush
constexpr float kSlackM = 0.002f;
constexpr int kGrid = 10;                             // places of the footprint that are tried, each way
constexpr double kMinCarried = 0.3, kMinUnder = 0.5;  // see Thing::isUnder()
constexpr float kLevelCosine = 0.94f;                 // 20 deg
constexpr float kLayerM = 0.004f;                     // of one level surface, with kSigmas
constexpr double kTop = 0.95;                         // share of the level points that are not over the top
constexpr double kMaxOver = 0.2;                      // of a thing's points, above the foot of what is on it
constexpr float kMaxOverhangM = 0.015f;  // of heights: a thing is seen nearly up to what stands flush on it
constexpr double kMinHeightM = 0.005;
constexpr float kRoundingM = 1e-6f;

using Outline = std::vector<cv::Point2f>;

/// Some points of a thing in the table frame.
struct Thing {
  std::vector<Eigen::Vector3f> points;
  std::vector<char> level;  ///< by point: the surface is level there
  ConvexArea plan;          ///< their convex hull seen from above
  cv::Rect2f bounds;        ///< of the plan
  float tolerance_m = 0;    ///< of heights

  float lowest() const {
    std::vector<float> heights;
    for (const auto& p : points) heights.push_back(p.z());
    return heights.empty() ? 0 : shareBelow(kFew, heights);
  }
};

Thing describe(const Frame& frame, const Normals& normals, const Table& table, const std::vector<int>& pixels) {
  Thing thing;
  const Eigen::Isometry3f T_table_camera = table.T_table_camera.cast<float>();
  const Eigen::Vector3f up = table.normal.cast<float>();
  double depths = 0;
  for (std::size_t i = 0; i < pixels.size(); i += 1 + pixels.size() / kPoints) {
    const Eigen::Vector3f& p = frame.points[pixels[i]];
    if (!(p.z() > 0)) continue;
    thing.points.push_back(T_table_camera * p);
    thing.level.push_back(normals.radius_px[pixels[i]] > 0 && normals.normal[pixels[i]].dot(up) > kLevelCosine);
    depths += p.z();
  }
  if (thing.points.empty()) return thing;
  Outline places, hull;
  for (const auto& p : thing.points) places.emplace_back(p.x(), p.y());
  cv::convexHull(places, hull);
  thing.plan = ConvexArea(hull);
  cv::Point2f low = places[0], high = places[0];
  for (const auto& p : hull) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const cv::Point2f margin(kSlackM, kSlackM);  // a face that is seen along the table has no width
  thing.bounds = {low - margin, high + margin};
  thing.tolerance_m =
      std::max(kMinToleranceM, kSigmas * static_cast<float>(table.noise.sigma(depths / thing.points.size())));
  return thing;
}

/// The segments, in their order, and the connected parts of what is in none of them.
std::vector<Thing> describeAll(const Frame& frame, const Normals& normals, const Table& table,
                               const ObjectPoints& above, const std::vector<Segment>& segments) {
  std::vector<Thing> things;
  cv::Mat_<uchar> left = above.mask.clone();
  if (!above.container.empty()) left |= above.container;
  for (const Segment& segment : segments) {
    things.push_back(describe(frame, normals, table, segment.pixels));
    for (const int pixel : segment.pixels) left(pixel) = 0;
  }
  const MaskComponents parts = findComponents(left, Neighbours::kEight);
  std::vector<std::vector<int>> pixels(parts.count);
  for (const Run& run : parts.runs) {
    for (int u = run.first; u < run.last; ++u) pixels[run.part].push_back(run.row * left.cols + u);
  }
  for (const auto& part : pixels) {
    if (part.size() >= kMinLeftPixels) things.push_back(describe(frame, normals, table, part));
  }
  return things;
}

/// A box in the table frame, and where it stands.
struct Footprint {
  Outline corners;        ///< of its lower face seen from above, in order
  ConvexArea area;        ///< within them
  cv::Rect2f bounds;      ///< of these and what is near
  float lowest_corner_m;  ///< height

  Footprint(const Eigen::Isometry3d& T_table_box, const Eigen::Vector3d& size) : lowest_corner_m(1e9f) {
    Outline near;
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      const Eigen::Vector3f p = (T_table_box * (0.5 * size.cwiseProduct(Eigen::Vector3d(x, y, -1)))).cast<float>();
      corners.emplace_back(p.x(), p.y());
      lowest_corner_m = std::min(lowest_corner_m, p.z());
    }
    cv::Point2f low = corners[0], high = corners[0];
    for (const auto& p : corners) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const cv::Point2f margin(kNearM, kNearM);
    bounds = {low - margin, high + margin};
    area = ConvexArea(corners);
  }
};

/// Whether a thing lies under the footprint: under a good part of it, or with a good part of itself. Of two things that
/// stand side by side neither does.
bool isUnder(const Thing& thing, const Footprint& foot) {
  int carried = 0;
  for (int i = 0; i < kGrid * kGrid; ++i) {
    const float a = (i % kGrid + 0.5f) / kGrid, b = (i / kGrid + 0.5f) / kGrid;
    const cv::Point2f place =
        foot.corners[0] + a * (foot.corners[1] - foot.corners[0]) + b * (foot.corners[3] - foot.corners[0]);
    // Outside of the bounds with their margins the distance is larger, and need not be known.
    carried += thing.bounds.contains(place) && thing.plan.contains(place, kSlackM);
  }
  if (carried >= kMinCarried * kGrid * kGrid) return true;
  std::size_t under = 0;
  for (const auto& p : thing.points) {
    under += foot.bounds.contains({p.x(), p.y()}) && foot.area.contains({p.x(), p.y()}, kFlushM);
  }
  return under >= kMinUnder * thing.points.size();
}

/// Height of the surface that carries the footprint of what is seen from the height `lowest_m` on; 0: none.
float topUnder(const Thing& thing, const Footprint& foot, float lowest_m) {
  const float limit_m = lowest_m + thing.tolerance_m;
  std::vector<float> level, all, level_anywhere;
  std::size_t over = 0;
  for (std::size_t i = 0; i < thing.points.size(); ++i) {
    const Eigen::Vector3f& p = thing.points[i];
    const bool near = foot.bounds.contains({p.x(), p.y()}) && foot.area.contains({p.x(), p.y()}, kNearM);
    if (p.z() > limit_m) {
      over += near;
      continue;
    }
    if (thing.level[i]) level_anywhere.push_back(p.z());
    if (near && thing.level[i]) level.push_back(p.z());
    if (near) all.push_back(p.z());
  }
  if (all.size() + over < kMinPoints) level = std::move(level_anywhere);  // others hide what is near
  const float sides = all.empty() ? 0 : shareBelow(1 - kFew, all);
  if (level.size() >= kMinPoints) {
    const float top = shareBelow(kTop, level), bottom = top - std::max(kLayerM, 2 * thing.tolerance_m);
    level.erase(std::remove_if(level.begin(), level.end(), [&](float z) { return z < bottom; }), level.end());
    if (top > sides - kMaxOverhangM) return shareBelow(0.5, level);
  }
  // Its top is hidden: then its sides end under what is on it.
  if (all.size() < kMinPoints || over > kMaxOver * (all.size() + over)) return 0;
  return sides < lowest_m - kMaxOverhangM ? foot.lowest_corner_m : sides;  // what juts out over it hides the rest
}

/// Whether `thing` rests on `on`, directly or by way of others.
bool restsOn(std::size_t thing, std::size_t on, const std::vector<Support>& supports) {
  for (int at = static_cast<int>(thing); at >= 0 && static_cast<std::size_t>(at) < supports.size();) {
    if (static_cast<std::size_t>(at) == on) return true;
    at = supports[at].kind == SupportKind::kSegment ? supports[at].segment : -1;
  }
  return false;
}

/// What the thing of the footprint stands on: the highest of what is under it, other than what stands on itself.
Support supportOf(std::size_t own, const Footprint& foot, const std::vector<Thing>& things,
                  const std::vector<Support>& known) {
  const float lowest = things[own].lowest();
  Support support;
  for (std::size_t k = 0; k < things.size(); ++k) {
    const Thing& thing = things[k];
    if (k == own || thing.points.empty() || (thing.bounds & foot.bounds).empty()) continue;
    if (!isUnder(thing, foot)) continue;
    const float top = topUnder(thing, foot, lowest);
    if (top <= support.height_m || restsOn(k, own, known)) continue;
    const bool segment = k < known.size();
    support = {segment ? SupportKind::kSegment : SupportKind::kOther, segment ? static_cast<int>(k) : -1, top};
  }
  return support;
}

/// Moves the lower face along the box's z axis, downwards by that much.
void lengthen(double by_m, OrientedBox& box) {
  box.T_camera_box.translate(Eigen::Vector3d(0, 0, -0.5 * by_m));
  box.size_m.z() += by_m;
}

}  // namespace

std::vector<Support> findSupports(const Frame& frame, const Normals& normals, const Table& table,
                                  const ObjectPoints& above, const std::vector<Segment>& segments) {
  const std::vector<Thing> things = describeAll(frame, normals, table, above, segments);
  std::vector<Support> supports(segments.size());
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const OrientedBox& box = segments[k].box;
    const Footprint foot(table.T_table_camera * box.T_camera_box, box.size_m);
    supports[k] = supportOf(k, foot, things, supports);
  }
  return supports;
}

void restBox(const Table& table, double support_m, OrientedBox& box) {
  const Eigen::Isometry3d T_table_box = table.T_table_camera * box.T_camera_box;
  const Footprint foot(T_table_box, box.size_m);
  const double upright = T_table_box.linear()(2, 2);
  const double to_support = (foot.lowest_corner_m - support_m) / upright;
  const bool tilted = upright < 1 - 1e-6;
  if (std::abs(to_support) < kRoundingM) return;  // the paper's boxes begin on the table
  if (tilted ? to_support < 0 : box.size_m.z() + to_support < kMinHeightM) return;
  lengthen(to_support, box);
}

}  // namespace objectness
