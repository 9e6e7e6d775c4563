// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>

#include "fixtures/piece_view.hpp"
#include "grouping/group_cues.hpp"
#include "objectness_segmentation/cues/edges.hpp"
#include "objectness_segmentation/learning/cue_list.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

using Group = std::vector<int>;

Scene smallView(std::vector<Surface> surfaces) {
  Scene scene = sceneOf(std::move(surfaces));
  scene.camera = {262.5, 262.5, 159.5, 119.5, 320, 240};
  return scene;
}

/// A view with all that groups are described from.
struct GroupView : PieceView {
  GroupView(const Scene& scene, const Labelling& labelling) : PieceView(scene, labelling) {
    edges = findEdges(frame, normals, table, points, {});
  }
  std::vector<GroupHypothesis> describe(const std::vector<Group>& groups, int threads = 1) const {
    return describeGroups({frame, table, edges, pieces, borders, links}, groups, threads);
  }
  GroupCues cuesOf(const Group& group) const { return describe({group}).at(0).cues; }

  EdgeMap edges;
  std::vector<Link> links;
};

/// Two boxes side by side, each front and top a piece, a ball in front of the right one.
GroupView fivePieces() {
  const Scene scene = smallView({kTable, box({-0.2, 0, 0}, {-0.02, 0.1, 0.12}), box({-0.02, 0, 0}, {0.12, 0.1, 0.08}),
                                 sphere({0.08, -0.05, 0.04}, 0.04)});
  return GroupView(scene, [](int surface, const Eigen::Vector3d& p) {
    const bool top = p.z() > (surface == 1 ? 0.119 : 0.079);
    return surface == 3 ? 5 : 2 * surface - (top ? 0 : 1);
  });
}

std::vector<Link> randomLinks(int pieces, std::mt19937& random) {
  std::vector<Link> links;
  for (int a = 0; a < pieces; ++a) {
    for (int b = a + 1; b < pieces; ++b) {
      if (random() % 4 == 0) continue;
      const float p = static_cast<float>(random() % 11) / 10;  // certainties and ties among them
      const float angle = static_cast<float>(random() % 181) - 90;
      links.push_back({a, b, random() % 2 == 0, p, angle, 0.01f});
    }
  }
  return links;
}

/// The best of the weakest links of all spanning trees of a group, each tried; 0 when there is none.
float bestWeakestLink(const std::vector<Link>& links, const Group& group) {
  if (group.size() == 1) return 1;
  float best = 0;
  for (unsigned subset = 1; subset < 1u << links.size(); ++subset) {
    Group reached = {group[0]};
    float weakest = 1;
    std::size_t count = 0;
    for (std::size_t i = 0; i < links.size(); ++i) {
      if (subset >> i & 1) ++count, weakest = std::min(weakest, links[i].probability);
    }
    if (count + 1 != group.size()) continue;
    for (std::size_t at = 0; at < reached.size(); ++at) {
      for (std::size_t i = 0; i < links.size(); ++i) {
        if (!(subset >> i & 1) || (links[i].first != reached[at] && links[i].second != reached[at])) continue;
        const int other = links[i].first + links[i].second - reached[at];
        if (std::find(reached.begin(), reached.end(), other) == reached.end()) reached.push_back(other);
      }
    }
    if (reached.size() == group.size()) best = std::max(best, weakest);
  }
  return best;
}

double logit(float probability) {
  const double p = std::min(0.98, std::max(0.02, static_cast<double>(probability)));
  return std::log(p / (1 - p));
}

const std::vector<Group> kGroups = {{0}, {4}, {0, 1}, {2, 3}, {0, 1, 2, 3}, {1, 4}, {0, 2, 4}, {0, 1, 2, 3, 4}};

}  // namespace

TEST(GroupCues, OfLinksEqualTheirDefinitions) {
  GroupView view = fivePieces();
  ASSERT_EQ(view.pieces.count(), 5);
  std::mt19937 random(8);
  for (int round = 0; round < 15; ++round) {
    view.links = randomLinks(5, random);
    for (const Group& group : kGroups) {
      SCOPED_TRACE(testing::PrintToString(group));
      const GroupCues cues = view.cuesOf(group);
      const auto has = [&](int k) { return std::binary_search(group.begin(), group.end(), k); };
      std::vector<Link> within;
      double sum = 0, outside = 0, best_outside = 0, weakest = 1;
      for (const Link& link : view.links) {
        if (has(link.first) && has(link.second)) within.push_back(link), sum += logit(link.probability);
        if (has(link.first) == has(link.second)) continue;
        outside += std::max(0.0, logit(link.probability));
        best_outside = std::max<double>(best_outside, link.probability);
      }
      for (const int k : group) {
        double strongest = group.size() == 1 ? 1 : 0;
        for (const Link& link : within) {
          if (link.first == k || link.second == k) strongest = std::max<double>(strongest, link.probability);
        }
        weakest = std::min(weakest, strongest);
      }
      const double count = static_cast<double>(group.size());
      EXPECT_EQ(cues.pieces, count);
      EXPECT_NEAR(cues.mean_logit, within.empty() ? 0 : sum / within.size(), 1e-4);
      EXPECT_NEAR(cues.logit_per_piece, sum / count, 1e-4);
      EXPECT_NEAR(cues.outside_logit, outside / count, 1e-4);
      EXPECT_NEAR(cues.best_outside, best_outside, 1e-6);
      EXPECT_NEAR(cues.weakest_piece, weakest, 1e-6);
      EXPECT_EQ(cues.bottleneck, bestWeakestLink(within, group));
    }
  }
}

TEST(GroupCues, SharesOfTheOutlineAddUpToOne) {
  GroupView view = fivePieces();
  for (const Group& group : kGroups) {
    SCOPED_TRACE(testing::PrintToString(group));
    const GroupCues cues = view.cuesOf(group);
    EXPECT_NEAR(cues.table + cues.front + cues.behind + cues.unknown + cues.image_border + cues.contact + cues.hidden +
                    cues.hides,
                1, 1e-4);
  }
  const GroupCues left = view.cuesOf({0, 1}), right = view.cuesOf({2, 3}), ball = view.cuesOf({4});
  const GroupCues all = view.cuesOf({0, 1, 2, 3, 4});
  EXPECT_GT(left.contact, 0.05);
  EXPECT_GT(left.hides, 0.01) << "its edge over the lower box";
  EXPECT_GT(right.hidden, 0.1) << "behind the ball too";
  EXPECT_GT(ball.hides, 0.1);
  EXPECT_EQ(ball.hidden, 0);
  EXPECT_EQ(all.contact + all.hidden + all.hides, 0) << "nothing else is there";
  EXPECT_GT(all.table, 0.1);
  EXPECT_GT(all.front, 0.3);
}

TEST(GroupCues, ContactsCountByTheirAngle) {
  GroupView view = fivePieces();
  view.links = {{0, 1, true, 0.9f, 90, 0.18f},
                {2, 3, true, 0.9f, 15, 0.14f},
                {0, 2, true, 0.5f, -60, 0.08f},
                {1, 3, true, 0.5f, -15, 0.1f},
                {0, 4, false, 0.5f, -90, 0}};
  const GroupCues left = view.cuesOf({0, 1}), both = view.cuesOf({0, 1, 2, 3});
  EXPECT_GT(left.convex_inside, 0);
  EXPECT_EQ(left.convex_outside + left.concave_inside, 0);
  EXPECT_NEAR(left.concave_outside / left.convex_inside, 0.08 / 0.18, 1e-4) << "-15 degrees are neither";
  EXPECT_NEAR(both.concave_inside / both.convex_inside, 0.08 / 0.32, 1e-4);
  EXPECT_EQ(both.concave_outside + both.convex_outside, 0);
}

TEST(GroupCues, OfTheVolumeAgreeWithADenseSampling) {
  const GroupView view = fivePieces();
  const Eigen::Vector3d eye = view.scene.T_world_camera.translation();
  for (const Group& group : kGroups) {
    SCOPED_TRACE(testing::PrintToString(group));
    const GroupHypothesis hypothesis = view.describe({group}).at(0);
    // Rays through 40 points a side: what lies in front of each, what is behind it.
    constexpr int kSide = 40;
    double free = 0, own = 0, other = 0;
    for (int i = 0; i < kSide * kSide * kSide; ++i) {
      const Eigen::Vector3d index(i % kSide, i / kSide % kSide, i / (kSide * kSide));
      const Eigen::Vector3d in_box = ((index.array() + 0.5) / kSide - 0.5).matrix().cwiseProduct(hypothesis.box.size_m);
      const Eigen::Vector3d camera = hypothesis.box.T_camera_box * in_box;
      const Eigen::Vector3d ray = view.scene.T_world_camera.linear() * (camera / camera.z());
      double nearest = kMiss;
      std::size_t surface = 0;
      for (std::size_t k = 0; k < view.scene.surfaces.size(); ++k) {
        const double z = view.scene.surfaces[k](eye, ray);
        if (z < nearest) nearest = z, surface = k;
      }
      const Eigen::Vector3d hit = eye + nearest * ray;
      const bool top = surface > 0 && hit.z() > (surface == 1 ? 0.119 : 0.079);
      const int piece = surface == 3 ? 4 : surface == 0 ? -1 : 2 * static_cast<int>(surface) - (top ? 1 : 2);
      const bool is_own = std::binary_search(group.begin(), group.end(), piece);
      if (nearest > camera.z() + 0.01)
        ++free;
      else if (is_own)
        ++own;
      else if (piece >= 0 && nearest < camera.z() - 0.01)
        ++other;
    }
    constexpr double kAll = kSide * kSide * kSide;
    constexpr double kTolerance = 0.07;  // of nine cells a side
    EXPECT_NEAR(hypothesis.cues.free, free / kAll, kTolerance);
    EXPECT_NEAR(hypothesis.cues.behind_own, own / kAll, kTolerance);
    EXPECT_NEAR(hypothesis.cues.behind_other, other / kAll, kTolerance);
    EXPECT_EQ(hypothesis.cues.unseen, 0);
  }
}

TEST(GroupCues, AirBeforeNothingIsUnseenAirBeforeSomethingIsFree) {
  // A post on the end of a low box: their common box is half air, seen against the table or against nothing.
  const Surface low = box({-0.1, 0, 0}, {0.1, 0.1, 0.04}), post = box({-0.1, 0, 0.04}, {-0.06, 0.1, 0.2});
  const GroupView view(smallView({slab(-0.6, -0.4, 0.6, 1, 0), low, post}), bySurface);
  const GroupView at_the_edge(smallView({slab(-0.6, -0.4, 0.6, 0.1, 0), low, post}), bySurface);
  const GroupCues before_table = view.cuesOf({0, 1}), before_nothing = at_the_edge.cuesOf({0, 1});
  EXPECT_GT(before_table.free, 0.3);
  EXPECT_EQ(before_table.unseen, 0);
  EXPECT_NEAR(before_nothing.free + before_nothing.unseen, before_table.free, 0.02);
  EXPECT_GT(before_nothing.unseen, 0.25);
}

TEST(GroupCues, OfTheBoxOfABox) {
  const GroupView view(smallView({kTable, box({-0.1, 0, 0}, {0.1, 0.1, 0.15})}),
                       [](int, const Eigen::Vector3d& p) { return p.z() > 0.149 ? 2 : 1; });
  const GroupHypothesis whole = view.describe({{0, 1}}).at(0);
  EXPECT_LT((view.scene.T_world_camera * whole.box.T_camera_box.translation() - Eigen::Vector3d(0, 0.05, 0.075)).norm(),
            0.01);
  EXPECT_NEAR(whole.box.size_m.prod(), 0.2 * 0.1 * 0.15, 4e-4);
  const GroupCues& cues = whole.cues;
  EXPECT_GT(cues.face_share, 0.95);
  EXPECT_NEAR(cues.box_fill, 1, 0.1);
  EXPECT_NEAR(cues.hull_fill, 1, 0.06);
  EXPECT_EQ(cues.other_points, 0);
  EXPECT_NEAR(cues.upright, 1, 1e-3);
  EXPECT_NEAR(cues.elongation, 0.75, 0.04);
  EXPECT_NEAR(cues.flatness, 0.1 / 0.15, 0.04);
  EXPECT_NEAR(cues.base_height, 0, 0.05);
  EXPECT_GT(cues.straddling, 0.9);
  EXPECT_GT(cues.outer_edges, 0.9) << "no edge is near the box but its own";
  EXPECT_LT(cues.free, 0.1);
  EXPECT_GT(cues.behind_own, 0.9);

  const GroupCues top = view.cuesOf({1});
  EXPECT_NEAR(top.base_height, 1, 0.05);
  EXPECT_LT(top.flatness, 0.2);
}

TEST(GroupCues, AreFiniteAndTheSameForAnyNumberOfThreads) {
  GroupView view = fivePieces();
  std::mt19937 random(8);
  view.links = randomLinks(5, random);
  const auto one = view.describe(kGroups, 1), three = view.describe(kGroups, 3);
  ASSERT_EQ(one.size(), kGroups.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].pieces, kGroups[i]);
    EXPECT_EQ(cueValues(one[i].cues), cueValues(three[i].cues));
    EXPECT_TRUE(one[i].box.T_camera_box.matrix() == three[i].box.T_camera_box.matrix());
    for (const float value : cueValues(one[i].cues)) EXPECT_TRUE(std::isfinite(value));
    EXPECT_TRUE(one[i].box.T_camera_box.matrix().allFinite());
  }
}
