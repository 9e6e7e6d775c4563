// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "grouping/propose_groups.hpp"

using namespace objectness;

namespace {

using Group = std::vector<int>;
constexpr GroupLimits kMany{100000, 100000};

Link link(int first, int second, float probability) { return {first, second, true, probability}; }

/// Links of all pairs of pieces: likely within an object, unlikely between two.
std::vector<Link> linksOf(const std::vector<int>& object_of, float same, float different, std::mt19937& random) {
  std::vector<Link> links;
  const int pieces = static_cast<int>(object_of.size());
  for (int a = 0; a < pieces; ++a) {
    for (int b = a + 1; b < pieces; ++b) {
      const float noise = (random() / 4294967296.f - 0.5f) * 0.1f;
      links.push_back(link(a, b, (object_of[a] == object_of[b] ? same : different) + noise));
    }
  }
  return links;
}

bool holds(const std::vector<Group>& groups, const Group& group) {
  return std::binary_search(groups.begin(), groups.end(), group);
}

void expectWellFormed(const std::vector<Group>& groups, int pieces) {
  for (std::size_t i = 0; i < groups.size(); ++i) {
    ASSERT_FALSE(groups[i].empty());
    ASSERT_TRUE(std::is_sorted(groups[i].begin(), groups[i].end()));
    ASSERT_EQ(std::set<int>(groups[i].begin(), groups[i].end()).size(), groups[i].size()) << "a piece twice";
    ASSERT_GE(groups[i].front(), 0);
    ASSERT_LT(groups[i].back(), pieces);
    if (i > 0) {
      ASSERT_LT(groups[i - 1], groups[i]) << "not sorted, or twice the same";
    }
  }
}

}  // namespace

TEST(ProposeGroups, HoldEveryPieceAndEveryTrueGroup) {
  const struct {
    const char* name;
    int pieces;
    std::vector<Link> links;
    std::vector<Group> expected;
  } cases[] = {
      {"no piece", 0, {}, {}},
      {"one piece", 1, {}, {{0}}},
      {"no links", 3, {}, {{0}, {1}, {2}}},
      {"a pair", 2, {link(0, 1, 0.9f)}, {{0}, {1}, {0, 1}}},
      {"a weak pair", 2, {link(0, 1, 0.2f)}, {{0}, {1}, {0, 1}}},
      {"a chain", 4, {link(0, 1, 0.9f), link(1, 2, 0.9f), link(2, 3, 0.9f)}, {{0, 1}, {2, 3}, {0, 1, 2, 3}}},
      {"two pairs weakly linked", 4, {link(0, 1, 0.9f), link(2, 3, 0.9f), link(1, 2, 0.3f)}, {{0, 1}, {2, 3}}},
      {"a bar in two halves behind a post",
       3,
       {link(0, 1, 0.2f), link(1, 2, 0.2f), {0, 2, false, 0.8f}},
       {{0, 2}, {1}}},
      {"a box that shows three faces, on another",
       6,
       {link(0, 1, 0.9f), link(0, 2, 0.9f), link(1, 2, 0.9f), link(3, 4, 0.9f), link(3, 5, 0.9f), link(4, 5, 0.9f),
        link(2, 3, 0.4f), link(1, 3, 0.4f)},
       {{0, 1, 2}, {3, 4, 5}}},
      {"one stray link too many",
       4,
       {link(0, 1, 0.95f), link(1, 2, 0.95f), link(2, 3, 0.9f), link(0, 2, 0.95f)},
       {{0, 1, 2}, {3}}},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(c.name);
    const std::vector<Group> groups = proposeGroups(c.pieces, c.links, kMany);
    expectWellFormed(groups, c.pieces);
    for (int k = 0; k < c.pieces; ++k) EXPECT_TRUE(holds(groups, {k}));
    for (const Group& group : c.expected) EXPECT_TRUE(holds(groups, group)) << testing::PrintToString(group);
  }
}

TEST(ProposeGroups, FindObjectsAmongNoisyLinks) {
  std::mt19937 random(4);
  for (int round = 0; round < 20; ++round) {
    const std::vector<int> object_of = {0, 1, 2, 0, 1, 2, 0, 3, 3, 0, 4, 2};
    const std::vector<Group> groups = proposeGroups(12, linksOf(object_of, 0.75f, 0.25f, random), kMany);
    expectWellFormed(groups, 12);
    for (const Group& object : {Group{0, 3, 6, 9}, {1, 4}, {2, 5, 11}, {7, 8}, {10}}) {
      EXPECT_TRUE(holds(groups, object)) << testing::PrintToString(object);
    }
  }
}

TEST(ProposeGroups, PiecesThatAreHardlyLinkedAreNotJoined) {
  const std::vector<Group> groups = proposeGroups(3, {link(0, 1, 0.9f), link(1, 2, 0.05f)}, kMany);
  EXPECT_EQ(groups, (std::vector<Group>{{0}, {0, 1}, {1}, {2}}));
}

TEST(ProposeGroups, ACapKeepsThePiecesAndTheBestLinkedGroups) {
  std::mt19937 random(4);
  const std::vector<int> object_of = {0, 0, 0, 1, 1, 2, 2, 3, 3, 3};
  const std::vector<Link> links = linksOf(object_of, 0.8f, 0.3f, random);
  const std::vector<Group> all = proposeGroups(10, links, kMany);
  ASSERT_GT(all.size(), 40u);
  for (const std::size_t most : {std::size_t{10}, std::size_t{14}, std::size_t{30}, all.size()}) {
    const std::vector<Group> capped = proposeGroups(10, links, {most, most});
    EXPECT_EQ(capped.size(), most);
    expectWellFormed(capped, 10);
    for (int k = 0; k < 10; ++k) EXPECT_TRUE(holds(capped, {k}));
    EXPECT_TRUE(std::includes(all.begin(), all.end(), capped.begin(), capped.end()));
  }
  EXPECT_TRUE(holds(proposeGroups(10, links, {14, 14}), {0, 1, 2}));
  EXPECT_TRUE(holds(proposeGroups(10, links, {14, 14}), {7, 8, 9}));
}

TEST(ProposeGroups, APartWithManyGroupsCostsTheOthersNone) {
  // Pieces 0 to 9 are a wall of which each fits to each, 10 to 12 and 13 to 14 an object each.
  std::mt19937 random(4);
  std::vector<Link> links = linksOf(std::vector<int>(10, 0), 0.9f, 0.9f, random);
  const std::vector<Link> objects = {link(10, 11, 0.6f), link(11, 12, 0.6f), link(13, 14, 0.6f)};
  links.insert(links.end(), objects.begin(), objects.end());
  const std::vector<Group> all = proposeGroups(15, links, kMany);
  for (const GroupLimits& limits : {GroupLimits{40, 100000}, GroupLimits{100000, 50}, GroupLimits{40, 49}}) {
    const std::vector<Group> capped = proposeGroups(15, links, limits);
    expectWellFormed(capped, 15);
    EXPECT_LE(capped.size(), limits.of_all);
    EXPECT_LT(capped.size(), all.size());
    EXPECT_TRUE(std::includes(all.begin(), all.end(), capped.begin(), capped.end()));
    for (int k = 0; k < 15; ++k) EXPECT_TRUE(holds(capped, {k}));
    for (const Group& object : {Group{10, 11, 12}, {10, 11}, {11, 12}, {13, 14}}) EXPECT_TRUE(holds(capped, object));
    const auto of_wall = std::count_if(capped.begin(), capped.end(), [](const Group& g) { return g.front() < 10; });
    EXPECT_LE(static_cast<std::size_t>(of_wall), limits.of_a_part);
    EXPECT_GE(of_wall, 39) << "and it has what is left";
  }
}

TEST(ProposeGroups, TheOrderOfLinksDoesNotCount) {
  std::mt19937 random(4);
  std::vector<Link> links = linksOf({0, 1, 0, 1, 2, 2, 0, 3}, 0.7f, 0.3f, random);
  const std::vector<Group> groups = proposeGroups(8, links, {25, 25});
  std::reverse(links.begin(), links.end());
  EXPECT_EQ(proposeGroups(8, links, {25, 25}), groups);
}

TEST(ProposeGroups, KindsCanBeLeftOut) {
  std::mt19937 random(4);
  std::vector<Link> links;
  for (int a = 0; a < 12; ++a) {
    for (int b = a + 1; b < 12; ++b) links.push_back(link(a, b, static_cast<float>(random() % 100) / 100));
  }
  const std::vector<Group> all = proposeGroups(12, links, kMany),
                           merged = proposeGroups(12, links, kMany, {true, false}),
                           grown = proposeGroups(12, links, kMany, {false, true});
  std::vector<Group> singles;
  for (int k = 0; k < 12; ++k) singles.push_back({k});
  EXPECT_EQ(proposeGroups(12, links, kMany, {false, false}), singles);
  for (const std::vector<Group>* some : {&merged, &grown}) {
    EXPECT_GT(some->size(), singles.size());
    EXPECT_LT(some->size(), all.size()) << "only merging makes groups of all, only growing those beside its ways";
    EXPECT_TRUE(std::includes(all.begin(), all.end(), some->begin(), some->end()));
    EXPECT_TRUE(std::includes(some->begin(), some->end(), singles.begin(), singles.end()));
  }
  EXPECT_LE(merged.size(), 12u + 3 * 11) << "a merge each";
}
