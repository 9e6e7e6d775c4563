// SPDX-License-Identifier: BSD-3-Clause
#include "grouping/rule_based_scores.hpp"

#include <algorithm>
#include <cmath>

namespace objectness {
namespace {

constexpr float kConcave_deg = -35;  // things that touch; rounded handles and rims seem to bend less
constexpr float kParallel = 0.97f, kCoplanar_m = 0.01f;
constexpr float kHidden = 0.4f, kFree = 0.1f;

bool sameObject(const GapCues& gap, float centroids_apart_m) {
  return gap.cosine > kParallel && gap.plane_offset * centroids_apart_m < kCoplanar_m && gap.free_share < kFree &&
         gap.occluded_share > kHidden;
}

/// a(b) of the faces the camera sees, and of three whatever it sees; square metres.
struct Areas {
  explicit Areas(const OrientedBox& box) {
    const Eigen::Vector3d eye = box.T_camera_box.inverse().translation();
    for (int axis = 0; axis < 3; ++axis) {
      const double face = box.size_m[(axis + 1) % 3] * box.size_m[(axis + 2) % 3];
      three += face;
      if (std::abs(eye[axis]) > 0.5 * box.size_m[axis]) visible += face;
    }
  }
  double visible = 0, three = 0;
};

}  // namespace

std::vector<Link> scorePairsByRule(const std::vector<PairEvidence>& evidence, const Pieces& pieces,
                                   const Borders& borders) {
  std::vector<Link> links;
  for (const PairEvidence& pair : evidence) {
    if (const auto* contact = std::get_if<ContactCues>(&pair.cues)) {
      const float length = borders.pairs.at({pair.first, pair.second}).contact;
      const float probability = contact->angle_median_deg > kConcave_deg ? 1.f : 0.f;
      links.push_back({pair.first, pair.second, true, probability, contact->angle_median_deg, length});
    } else {
      const float apart_m = (pieces.pieces[pair.first].centroid - pieces.pieces[pair.second].centroid).norm();
      if (sameObject(std::get<GapCues>(pair.cues), apart_m)) links.push_back({pair.first, pair.second, false, 1.f});
    }
  }
  return links;
}

CueValues paperCues(const GroupHypothesis& group, const ObjectnessConfig& config, double voxel_m) {
  const Areas area(group.box);
  const double counted = std::max(1e-6, config.three_face_area ? area.three : area.visible);
  const double edges_m = group.cues.edge_density * std::sqrt(std::max(1e-6, area.visible));
  const double free_m3 = group.cues.free * group.box.size_m.prod();
  CueValues cues;
  // An edge of one voxel's length fills one voxel: edges_m / voxel_m of them on counted / voxel_m^2 squares.
  cues.edge_density = static_cast<float>(std::min(edges_m * voxel_m / counted, config.max_edge_density));
  cues.outer_edges = group.cues.outer_edges;
  cues.straddling = group.cues.straddling;
  cues.free_space = static_cast<float>(free_m3 / (counted * voxel_m));
  cues.free_voxels = static_cast<int>(std::lround(free_m3 / (voxel_m * voxel_m * voxel_m)));
  return cues;
}

void scoreGroupsByRule(const ObjectnessConfig& config, double voxel_m, double shift,
                       std::vector<GroupHypothesis>& groups) {
  for (GroupHypothesis& group : groups) {
    const double delta = objectness(paperCues(group, config, voxel_m), config);  // Eq. 6
    group.objectness = static_cast<float>(std::clamp(delta + shift, 0.0, 1.0));
  }
}

}  // namespace objectness
