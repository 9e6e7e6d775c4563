// SPDX-License-Identifier: BSD-3-Clause
#include "grouping/standing_groups.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "common/disjoint_sets.hpp"
#include "common/share_below.hpp"
#include "scene/foot_height.hpp"

namespace objectness {
namespace {

constexpr double kMinAreaM2 = 0.0012;
constexpr double kSigmas = 1.9;      // of a single pixel, for the median of hundreds
constexpr double kSigmasRagged = 5;  // what noise leaves is ragged
constexpr double kMinSolid = 0.75;   // share of the convex hull in the picture; less is ragged
constexpr double kLowest = 0.05;     // share of its points
constexpr int kBesidePx = 3;
constexpr double kMinOnSupport = 0.7;  // share of table, or of a tray, in what is seen beside it

/// Whether connected pieces stand alone on the table.
class StandingParts {
 public:
  StandingParts(const Frame& frame, const Table& table, const ObjectPoints& above, const Pieces& pieces)
      : frame_(frame), table_(table), above_(above), pieces_(pieces) {}

  bool stands(const std::vector<int>& members) const {
    double area_m2 = 0, depths = 0;
    std::vector<float> heights;
    std::vector<cv::Point> pixels, hull;
    int beside = 0, on_support = 0;
    bool in_container = false;  // whose floor may lie higher
    for (const int k : members) {
      area_m2 += pieces_.pieces[k].area_m2;
      for (const int pixel : pieces_.pieces[k].pixels) {
        const cv::Point at(pixel % above_.mask.cols, pixel / above_.mask.cols);
        pixels.push_back(at);
        for (const cv::Point& step : {cv::Point(kBesidePx, 0), {-kBesidePx, 0}, {0, kBesidePx}, {0, -kBesidePx}}) {
          if (!isBeside(at + step, members)) continue;
          ++beside;
          const bool container = above_.container(at + step) != 0;
          in_container = in_container || container;
          on_support += container || above_.on_table(at + step) != 0;
        }
        if (!std::isfinite(above_.height_m(at))) continue;  // its gap was bridged
        heights.push_back(above_.height_m(at));
        depths += frame_.points[pixel].z();
      }
    }
    if (area_m2 < kMinAreaM2 || heights.empty() || on_support < kMinOnSupport * beside) return false;
    if (!in_container && shareBelow(kLowest, heights) > kFootHeightM) return false;  // it hangs
    const double sigmas = shareBelow(0.5, heights) / table_.noise.sigma(depths / static_cast<double>(heights.size()));
    cv::convexHull(pixels, hull);
    const bool solid = static_cast<double>(pixels.size()) >= kMinSolid * cv::contourArea(hull);
    return sigmas > (solid ? kSigmas : kSigmasRagged);
  }

 private:
  /// Whether something is seen there that is none of the pieces.
  bool isBeside(const cv::Point& at, const std::vector<int>& members) const {
    if (!cv::Rect({}, above_.mask.size()).contains(at) || !std::isfinite(above_.height_m(at))) return false;
    const int piece = pieces_.label(at);
    return piece < 0 || !std::binary_search(members.begin(), members.end(), piece);
  }

  const Frame& frame_;
  const Table& table_;
  const ObjectPoints& above_;
  const Pieces& pieces_;
};

}  // namespace

std::vector<int> standingGroups(const Frame& frame, const Table& table, const ObjectPoints& above, const Pieces& pieces,
                                const std::vector<Link>& links, const std::vector<GroupHypothesis>& groups,
                                const std::vector<int>& chosen, const GroupingConfig& config, unsigned seed) {
  if (!config.standing) return {};
  std::vector<char> taken(pieces.count(), false);
  for (const int k : chosen) {
    for (const int piece : groups[k].pieces) taken[piece] = true;
  }
  DisjointSets parts;
  while (parts.size() < pieces.count()) parts.create();
  std::vector<char> touches(pieces.count(), false);
  for (const Link& link : links) {
    if (!link.contact) continue;
    if (!taken[link.first] && !taken[link.second]) parts.join(link.first, link.second);
    if (taken[link.first] != taken[link.second]) touches[taken[link.first] ? link.second : link.first] = true;
  }
  std::vector<std::vector<int>> members(pieces.count());
  std::vector<char> attached(pieces.count(), false);
  for (int k = 0; k < pieces.count(); ++k) {
    if (taken[k]) continue;
    members[parts.root(k)].push_back(k);
    if (touches[k]) attached[parts.root(k)] = true;
  }
  const StandingParts parts_seen(frame, table, above, pieces);
  std::vector<char> standing(pieces.count(), false);
  for (std::size_t part = 0; part < members.size(); ++part) {
    if (members[part].empty() || attached[part] || !parts_seen.stands(members[part])) continue;
    for (const int k : members[part]) standing[k] = true;
  }
  std::vector<int> candidates;
  std::vector<GroupHypothesis> left;
  for (std::size_t k = 0; k < groups.size(); ++k) {
    const auto& of_group = groups[k].pieces;
    if (!std::all_of(of_group.begin(), of_group.end(), [&](int piece) { return standing[piece] != 0; })) continue;
    candidates.push_back(static_cast<int>(k));
    left.push_back(groups[k]);
  }
  if (left.empty()) return {};
  GroupingConfig any = config;
  any.least_objectness = 0;
  std::vector<int> found;
  for (const int k : selectGroups(packingProblem(pieces.count(), links, left, any), any, seed).chosen)
    found.push_back(candidates[k]);
  return found;
}

}  // namespace objectness
