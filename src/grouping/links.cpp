// SPDX-License-Identifier: BSD-3-Clause
#include "grouping/links.hpp"

#include <algorithm>
#include <cmath>

#include "common/parallel.hpp"
#include "grouping/ball.hpp"
#include "objectness_segmentation/learning/cue_list.hpp"

namespace objectness {
namespace {

constexpr int kOutlinePixels = 64;  // of a piece: gaps are wide, their cues are shares

std::vector<Ball> ballsAround(const Frame& frame, const std::vector<std::vector<int>>& outlines) {
  std::vector<Ball> balls;
  for (const std::vector<int>& outline : outlines) {
    std::vector<Eigen::Vector3f> points;
    for (const int pixel : outline) points.push_back(frame.points[pixel]);
    balls.push_back(ballAround(points));
  }
  return balls;
}

}  // namespace

std::vector<PairEvidence> findPairEvidence(const Frame& frame, const Normals& normals, const Table& table,
                                           const ObjectPoints& object_points, const Superpixels& superpixels,
                                           const Pieces& pieces, const Borders& borders, const LinksConfig& config,
                                           int threads) {
  const std::vector<std::vector<int>> outlines = outlinePixels(pieces, kOutlinePixels, threads);
  const std::vector<Ball> balls = ballsAround(frame, outlines);
  const auto evidenceOf = [&](int first, int second) -> std::optional<PairEvidence> {
    const auto border = borders.pairs.find({first, second});
    if (border != borders.pairs.end() && !border->second.samples.empty()) {
      const ContactCues cues = findContactCues(frame, normals, table, superpixels, pieces, borders, first, second);
      return PairEvidence{first, second, config.contact_cues(cues)};
    }
    if (!config.gaps || balls[first].distance(balls[second]) > config.max_gap_m) return std::nullopt;
    const auto gap = findGapCues(frame, table, object_points, pieces, outlines, first, second, config.max_gap_m);
    if (!gap) return std::nullopt;
    return PairEvidence{first, second, config.gap_cues(*gap)};
  };
  std::vector<std::vector<PairEvidence>> by_first(pieces.count());
  parallelFor(pieces.count(), threads, [&](int first) {
    for (int second = first + 1; second < pieces.count(); ++second) {
      if (const auto pair = evidenceOf(first, second)) by_first[first].push_back(*pair);
    }
  });
  std::vector<PairEvidence> evidence;
  for (const auto& pairs : by_first) evidence.insert(evidence.end(), pairs.begin(), pairs.end());
  return evidence;
}

std::vector<Link> judgePairs(const std::vector<PairEvidence>& evidence, const Borders& borders,
                             const LearnedObjectness& model, int threads) {
  std::vector<Link> links(evidence.size());
  parallelFor(static_cast<int>(evidence.size()), threads, [&](int i) {
    const PairEvidence& pair = evidence[i];
    if (const auto* contact = std::get_if<ContactCues>(&pair.cues)) {
      const float length = borders.pairs.at({pair.first, pair.second}).contact;
      links[i] = {pair.first, pair.second, true, model.contact.predict(cueValues(*contact)), contact->angle_median_deg,
                  length};
    } else {
      links[i] = {pair.first, pair.second, false, model.gap.predict(cueValues(std::get<GapCues>(pair.cues)))};
    }
  });
  return links;
}

float logOdds(float probability) {
  const float p = std::clamp(probability, 0.02f, 0.98f);
  return std::log(p / (1 - p));
}

}  // namespace objectness
