// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>

#include "fixtures/leaf_model.hpp"
#include "fixtures/small_scene.hpp"
#include "grouping/rule_based_scores.hpp"
#include "objectness_segmentation/pipeline.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

constexpr double kVoxel_m = 0.01;

PairEvidence contactOf(float angle_median_deg) {
  ContactCues cues;
  cues.angle_median_deg = angle_median_deg;
  return {0, 1, cues};
}

/// Piece 1 is 20 cm from piece 0; 5 cm off its plane where plane_offset is 0.25.
Pieces twoPieces() {
  Pieces pieces;
  pieces.pieces.resize(2);
  pieces.pieces[1].centroid = {0.12f, 0.16f, 0};
  return pieces;
}

/// A gap that the rule joins.
GapCues hiddenAndCoplanar() {
  GapCues cues;
  cues.cosine = 0.98f;
  cues.plane_offset = 0.04f;
  cues.occluded_share = 0.5f;
  cues.free_share = 0.05f;
  return cues;
}

/// A group with a box of a known pose and random cues.
GroupHypothesis randomGroup(std::mt19937& random) {
  const auto uniform = [&](double low, double high) { return low + (high - low) * (random() / 4294967296.0); };
  GroupHypothesis group;
  group.box.size_m = {uniform(0.03, 0.3), uniform(0.03, 0.3), uniform(0.03, 0.3)};
  group.box.T_camera_box = Eigen::Translation3d(uniform(-0.3, 0.3), uniform(-0.3, 0.3), uniform(0.2, 1.5)) *
                           Eigen::Quaterniond(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), 1).normalized();
  group.cues.edge_density = static_cast<float>(uniform(0, 12));
  group.cues.outer_edges = static_cast<float>(uniform(0, 1));
  group.cues.straddling = static_cast<float>(uniform(0, 1));
  group.cues.free = static_cast<float>(uniform(0, 1));
  return group;
}

/// Square centimetres of the faces whose outer side the camera is on; all = true: half of all faces.
double areaByCorners(const OrientedBox& box, bool all) {
  double area = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-0.5, 0.5}) {
      const Eigen::Vector3d outwards = side * 2 * box.T_camera_box.linear().col(axis);
      const Eigen::Vector3d centre = box.T_camera_box * (side * box.size_m[axis] * Eigen::Vector3d::Unit(axis));
      const double face = 1e4 * box.size_m[(axis + 1) % 3] * box.size_m[(axis + 2) % 3];
      if (all) area += face / 2;
      if (!all && outwards.dot(-centre) > 0) area += face;
    }
  }
  return area;
}

}  // namespace

TEST(HandSet, ContactsAreLinksWhereTheyAreNotClearlyConcave) {
  Borders borders;
  borders.pairs[{0, 1}].contact = 0.12f;
  for (const auto& [angle, probability] : {std::make_pair(-90.f, 0.f), {-35.5f, 0.f}, {-34.5f, 1.f}, {80.f, 1.f}}) {
    const std::vector<Link> links = scorePairsByRule({contactOf(angle)}, twoPieces(), borders);
    ASSERT_EQ(links.size(), 1u);
    EXPECT_TRUE(links[0].contact);
    EXPECT_EQ(links[0].probability, probability) << angle;
    EXPECT_EQ(links[0].angle_deg, angle);
    EXPECT_EQ(links[0].contact_length_m, 0.12f);
  }
}

TEST(HandSet, GapsAreLinksWhereAllSpeaksForIt) {
  const auto linked = [](const GapCues& cues) { return scorePairsByRule({{0, 1, cues}}, twoPieces(), {}); };
  const std::vector<Link> links = linked(hiddenAndCoplanar());
  ASSERT_EQ(links.size(), 1u);
  EXPECT_FALSE(links[0].contact);
  EXPECT_EQ(links[0].probability, 1);

  for (const auto change : {+[](GapCues& c) { c.cosine = 0.96f; }, +[](GapCues& c) { c.cosine = -1; },
                            +[](GapCues& c) { c.plane_offset = 0.051f; }, +[](GapCues& c) { c.occluded_share = 0.39f; },
                            +[](GapCues& c) { c.free_share = 0.11f; }}) {
    GapCues cues = hiddenAndCoplanar();
    change(cues);
    EXPECT_TRUE(linked(cues).empty());
  }
  GapCues cues = hiddenAndCoplanar();
  cues.plane_offset = 0.049f;  // 9.8 mm
  EXPECT_EQ(linked(cues).size(), 1u);
}

TEST(HandSet, GroupsAreWorthEquation6OfTheirBox) {
  std::mt19937 random(3);
  ObjectnessConfig config;
  config.weight_edges = 0.4, config.weight_outer = 0.55, config.weight_free = -0.05, config.constant = 0.3;
  int inner = 0;
  for (int i = 0; i < 300; ++i) {
    config.three_face_area = i % 2 == 1;
    std::vector<GroupHypothesis> groups = {randomGroup(random)};
    const GroupCues& cues = groups[0].cues;
    const OrientedBox& box = groups[0].box;
    const double seen_cm2 = areaByCorners(box, false);
    if (seen_cm2 == 0) continue;  // the camera is in the box
    const double area_cm2 = config.three_face_area ? areaByCorners(box, true) : seen_cm2;
    const double edges_cm = cues.edge_density * std::sqrt(seen_cm2), free_cm3 = cues.free * 1e6 * box.size_m.prod();
    const double density = std::min(1.0, edges_cm / area_cm2), free_space = free_cm3 / area_cm2;
    const double delta = 0.3 - 0.2 + 0.4 * density + 0.55 * cues.outer_edges * cues.straddling - 0.05 * free_space;

    const CueValues values = paperCues(groups[0], config, kVoxel_m);
    EXPECT_NEAR(values.edge_density, density, 1e-4);
    EXPECT_NEAR(values.free_space, free_space, 1e-4);
    EXPECT_NEAR(values.free_voxels, free_cm3, 0.51);
    scoreGroupsByRule(config, kVoxel_m, -0.2, groups);
    EXPECT_NEAR(groups[0].objectness, std::min(1.0, std::max(0.0, delta)), 1e-4);
    inner += delta > 0 && delta < 1;
  }
  EXPECT_GT(inner, 100) << "most are not clamped";
}

TEST(HandSet, NothingLearnedIsUsed) {
  const sim::Scene scene = smallScene();
  const SceneImages images = sim::takePicture(scene.bodies, scene.T_world_camera, smallSensor(), 1);
  const Frame frame = makeFrame(images.depth_mm, images.color, images.camera, {}).value;
  Config config;
  config.grouping.learned = false;
  const Segmentation built_in = segment(frame, config), other = segment(frame, config, leafModel(0, 0, 0));
  ASSERT_TRUE(built_in.status.ok()) << built_in.status.message;
  EXPECT_EQ(built_in.segments.size(), 2u);
  EXPECT_EQ(cv::countNonZero(built_in.labels != other.labels), 0);
  ASSERT_EQ(built_in.proposals.size(), other.proposals.size());
  for (std::size_t i = 0; i < other.proposals.size(); ++i) {
    EXPECT_EQ(built_in.proposals[i].objectness, other.proposals[i].objectness);
  }
  config.grouping.learned = true;
  EXPECT_EQ(segment(frame, config, leafModel(0, 0, 0)).segments.size(), 0u) << "what it would be with that model";
}
