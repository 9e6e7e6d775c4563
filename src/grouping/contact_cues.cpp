// SPDX-License-Identifier: BSD-3-Clause
#include "grouping/contact_cues.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace objectness {
namespace {

constexpr int kMaxSamples = 24;
constexpr float kSideReach_m = 0.03;  // the surface of either side is looked at this far from the border
constexpr int kSidePixels = 40;
constexpr int kMinSidePixels = 5;
constexpr float kBent_deg = 10;

/// The surface of one side near a contact sample.
struct Side {
  Eigen::Vector3f normal, point;
};

/// Mean normal and position of the nearest smooth pixels of `piece` around a pixel. Rough pixels at the border belong
/// to neither surface.
std::optional<Side> sideAt(const Frame& frame, const Normals& normals, const Superpixels& superpixels,
                           const Pieces& pieces, int piece, int pixel) {
  const Eigen::Vector3f centre = frame.points[pixel];
  const int radius = std::clamp(static_cast<int>(std::lround(kSideReach_m * frame.camera.focal() / centre.z())), 3, 40);
  const int stride = 1 + radius / 12;
  const int u0 = pixel % frame.width(), v0 = pixel / frame.width();
  const bool smooth_only = pieces.pieces[piece].smooth_pixels > 0;
  std::vector<std::pair<float, int>> near;
  for (int v = std::max(0, v0 - radius); v <= std::min(frame.height() - 1, v0 + radius); v += stride) {
    for (int u = std::max(0, u0 - radius); u <= std::min(frame.width() - 1, u0 + radius); u += stride) {
      const int i = v * frame.width() + u;
      if (pieces.label(i) != piece || normals.radius_px[i] == 0 || (smooth_only && superpixels.label(i) == 0)) continue;
      const float distance = (frame.points[i] - centre).squaredNorm();
      if (distance < kSideReach_m * kSideReach_m) near.emplace_back(distance, i);
    }
  }
  if (near.size() < kMinSidePixels) return std::nullopt;
  const std::size_t kept = std::min<std::size_t>(kSidePixels, near.size());
  std::nth_element(near.begin(), near.begin() + (kept - 1), near.end());
  Side side{Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero()};
  for (std::size_t k = 0; k < kept; ++k) {
    side.normal += normals.normal[near[k].second];
    side.point += frame.points[near[k].second];
  }
  side.normal.normalize();
  side.point /= static_cast<float>(kept);
  return side;
}

float percentile(std::vector<float>& values, double share) {
  const std::size_t k = static_cast<std::size_t>(std::lround(share * (values.size() - 1)));
  std::nth_element(values.begin(), values.begin() + k, values.end());
  return values[k];
}

float signedAngle(const Side& a, const Side& b) {
  const float angle = std::acos(std::clamp(a.normal.dot(b.normal), -1.f, 1.f)) * static_cast<float>(180 / M_PI);
  return (a.normal - b.normal).dot(a.point - b.point) > 0 ? angle : -angle;
}

}  // namespace

ContactCues findContactCues(const Frame& frame, const Normals& normals, const Table& table,
                            const Superpixels& superpixels, const Pieces& pieces, const Borders& borders, int first,
                            int second) {
  const PairBorder& border = borders.pairs.at({first, second});
  const Eigen::Vector3f up = table.normal.cast<float>();
  ContactCues cues;
  cues.contact_share = border.contact / border.total();
  cues.contact_of_outline =
      border.contact / std::min(borders.outlines[first].total(), borders.outlines[second].total());
  const float area_a = pieces.pieces[first].area_m2, area_b = pieces.pieces[second].area_m2;
  cues.size_ratio = std::min(area_a, area_b) / std::max(area_a, area_b);

  std::vector<float> angles;
  float step = 0, weight = 0, height = 0;
  Eigen::Vector2f upright = Eigen::Vector2f::Zero();
  const std::size_t count = std::min<std::size_t>(kMaxSamples, border.samples.size());
  for (std::size_t k = 0; k < count; ++k) {
    const ContactSample& sample = border.samples[k * border.samples.size() / count];
    const auto a = sideAt(frame, normals, superpixels, pieces, first, sample.first);
    const auto b = sideAt(frame, normals, superpixels, pieces, second, sample.second);
    if (!a || !b) continue;
    angles.push_back(signedAngle(*a, *b));
    const Eigen::Vector3f middle = 0.5f * (frame.points[sample.first] + frame.points[sample.second]);
    const float offset = a->normal.dot(middle - a->point) - b->normal.dot(middle - b->point);
    step += offset * offset;
    const float z = middle.z();
    weight += static_cast<float>(table.noise.sigma(z) * table.noise.sigma(z));
    height += (a->point - b->point).dot(up);
    upright += Eigen::Vector2f(a->normal.dot(up), b->normal.dot(up));
  }
  if (angles.empty()) {  // nothing smooth near the border: what the pieces look like as a whole
    const Side a{pieces.pieces[first].mean_normal.normalized(), pieces.pieces[first].centroid};
    const Side b{pieces.pieces[second].mean_normal.normalized(), pieces.pieces[second].centroid};
    angles.push_back(signedAngle(a, b));
    height = (a.point - b.point).dot(up);
    upright = {a.normal.dot(up), b.normal.dot(up)};
  }
  const float samples = static_cast<float>(angles.size());
  cues.step = weight > 0 ? std::sqrt(step / weight) : 0;
  cues.upper_upright = (height > 0 ? upright[0] : upright[1]) / samples;
  cues.lower_upright = (height > 0 ? upright[1] : upright[0]) / samples;
  for (const float angle : angles) {
    cues.concave_share += (angle < -kBent_deg) / samples;
    cues.convex_share += (angle > kBent_deg) / samples;
  }
  cues.angle_median_deg = percentile(angles, 0.5);
  cues.angle_low_deg = percentile(angles, 0.2);
  cues.angle_high_deg = percentile(angles, 0.8);
  return cues;
}

}  // namespace objectness
