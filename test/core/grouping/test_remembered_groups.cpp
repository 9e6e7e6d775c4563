// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "grouping/remembered_groups.hpp"

using namespace objectness;

namespace {

constexpr ushort kUnknown = GroupingMemory::kUnknown;

/// A row of pixels, and which piece each is of; -1: none.
Pieces piecesOf(const std::vector<int>& labels) {
  Pieces pieces;
  pieces.label = cv::Mat_<int>(1, static_cast<int>(labels.size()));
  for (std::size_t i = 0; i < labels.size(); ++i) {
    pieces.label(static_cast<int>(i)) = labels[i];
    if (labels[i] < 0) continue;
    if (labels[i] >= pieces.count()) pieces.pieces.resize(labels[i] + 1);
    pieces.pieces[labels[i]].pixels.push_back(static_cast<int>(i));
  }
  return pieces;
}

GroupingMemory memoryOf(const std::vector<int>& labels) {
  GroupingMemory memory{cv::Mat_<ushort>(1, static_cast<int>(labels.size()))};
  for (std::size_t i = 0; i < labels.size(); ++i) memory.labels(static_cast<int>(i)) = static_cast<ushort>(labels[i]);
  return memory;
}

float rememberedOf(const RememberedGroups& remembered, const std::vector<int>& pieces) {
  std::vector<GroupHypothesis> groups(1);
  groups[0].pieces = pieces;
  remembered.compare(groups);
  return groups[0].remembered;
}

double logOddsOf(const Link& link) { return std::log(link.probability / (1 - link.probability)); }

}  // namespace

TEST(RememberedGroups, AreThePiecesThatWereMostlyOfOneObject) {
  const Pieces pieces = piecesOf({0, 0, 0, 1, 1, 1, 2, 2, 3, 3, 4, 4, -1});
  const RememberedGroups remembered(pieces, memoryOf({5, 5, 5, 5, 5, 7, 7, 7, 5, 0, 1, kUnknown, 5}));
  // Piece 3 is half of an object and half of none, piece 4 was table as far as is known.
  EXPECT_EQ(remembered.groups(), (std::vector<std::vector<int>>{{0, 1}, {2}}));
}

TEST(RememberedGroups, WeighLinks) {
  const Pieces pieces = piecesOf({0, 1, 2, 3});
  const RememberedGroups remembered(pieces, memoryOf({5, 5, 6, kUnknown}));
  std::vector<Link> links;
  for (const auto& [a, b] : {std::pair{0, 1}, {1, 2}, {2, 3}}) {
    Link link{};
    link.first = a;
    link.second = b;
    link.probability = 0.6f;
    links.push_back(link);
  }
  const double before = logOddsOf(links[0]);
  remembered.weighLinks(1.5, links);
  EXPECT_NEAR(logOddsOf(links[0]), before + 1.5, 1e-4) << "one object";
  EXPECT_NEAR(logOddsOf(links[1]), before - 1.5, 1e-4) << "two objects";
  EXPECT_NEAR(logOddsOf(links[2]), before, 1e-6) << "not known";
}

TEST(RememberedGroups, TellHowMuchAGroupIsAnObjectOfBefore) {
  const Pieces pieces = piecesOf({0, 0, 1, 1, 2, 2, 3, 3, 4, 4});
  const RememberedGroups remembered(pieces, memoryOf({5, 5, 5, 5, 0, 1, kUnknown, kUnknown, 5, 5}));
  EXPECT_FLOAT_EQ(rememberedOf(remembered, {0, 1, 4}), 1);
  EXPECT_FLOAT_EQ(rememberedOf(remembered, {0, 1}), 2 * 4 / 6.f - 1);
  EXPECT_FLOAT_EQ(rememberedOf(remembered, {0}), 0) << "a third of it";
  EXPECT_FLOAT_EQ(rememberedOf(remembered, {2}), -1) << "no object";
  EXPECT_FLOAT_EQ(rememberedOf(remembered, {0, 2}), 0);
  EXPECT_FLOAT_EQ(rememberedOf(remembered, {3}), 0) << "not known";
  EXPECT_FLOAT_EQ(rememberedOf(remembered, {0, 1, 3, 4}), 1) << "what is not known does not count";
}

TEST(RememberedGroups, EqualAPlainCountOverPixels) {
  std::mt19937 random(5);
  for (int round = 0; round < 50; ++round) {
    std::vector<int> piece(60), label(60);
    for (int& p : piece) p = static_cast<int>(random() % 7) - 1;
    for (int& l : label) l = random() % 5 == 0 ? kUnknown : static_cast<int>(random() % 4);
    for (int k = 0; k < 6; ++k) piece[k] = k;
    const RememberedGroups remembered(piecesOf(piece), memoryOf(label));
    std::vector<int> group;
    for (int k = 0; k < 6; ++k) {
      if (random() % 2) group.push_back(k);
    }
    const std::set<int> in(group.begin(), group.end());
    double best = 0, known = 0, none = 0;
    for (int l = 2; l < 4; ++l) {
      double both = 0, either = 0;
      for (int i = 0; i < 60; ++i) {
        if (piece[i] < 0 || label[i] == kUnknown) continue;
        const bool a = in.count(piece[i]) > 0, b = label[i] == l;
        both += a && b;
        either += a || b;
      }
      if (either > 0) best = std::max(best, both / either);
    }
    for (int i = 0; i < 60; ++i) {
      if (piece[i] < 0 || label[i] == kUnknown || !in.count(piece[i])) continue;
      ++known;
      none += label[i] < 2;
    }
    const double expected = known == 0 ? 0 : std::max(0.0, 2 * best - 1) - std::max(0.0, 2 * none / known - 1);
    EXPECT_NEAR(rememberedOf(remembered, group), expected, 1e-6) << round;
  }
}

TEST(RememberedGroups, OfAFinerPictureAreLookedUpInTheMiddleOfThePixels) {
  const Pieces pieces = piecesOf({0, 1});
  GroupingMemory memory{cv::Mat_<ushort>(2, 4, static_cast<ushort>(0))};
  memory.labels(1, 1) = 5;
  memory.labels(1, 3) = 6;
  EXPECT_EQ(RememberedGroups(pieces, memory).groups(), (std::vector<std::vector<int>>{{0}, {1}}));
}
