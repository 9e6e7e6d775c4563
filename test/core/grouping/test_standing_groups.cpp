// SPDX-License-Identifier: BSD-3-Clause
// What stands alone on the table is an object, whatever a model makes of its shape.
#include <gtest/gtest.h>

#include "grouping/standing_groups.hpp"

using namespace objectness;

namespace {

constexpr int kSide = 60;  // pixels of the picture
constexpr float kDepth_m = 0.6f, kPixel_m = 0.002f;

/// A picture of a table from above, with rectangles on it that are one piece each.
struct View {
  Frame frame;
  Table table;
  ObjectPoints above;
  Pieces pieces;
  std::vector<GroupHypothesis> groups;  ///< each piece alone
  std::vector<Link> links;
  GroupingConfig config;

  View() {
    frame.camera = {kDepth_m / kPixel_m, kDepth_m / kPixel_m, 0.5 * kSide, 0.5 * kSide, kSide, kSide};
    frame.points.resize(kSide * kSide);
    for (int i = 0; i < kSide * kSide; ++i)
      frame.points[i] = {(i % kSide) * kPixel_m, (i / kSide) * kPixel_m, kDepth_m};
    table.noise = {0.002, 0};
    above.height_m = cv::Mat_<float>(kSide, kSide, 0.f);
    above.mask = cv::Mat_<uchar>(kSide, kSide, uchar(0));
    above.on_table = cv::Mat_<uchar>(kSide, kSide, uchar(255));
    above.container = cv::Mat_<uchar>(kSide, kSide, uchar(0));
    pieces.label = cv::Mat_<int>(kSide, kSide, -1);
  }

  void add(const cv::Rect& where, float height_m, float objectness = 0.1f) {
    Piece piece;
    for (int v = where.y; v < where.br().y; ++v) {
      for (int u = where.x; u < where.br().x; ++u) piece.pixels.push_back(v * kSide + u);
    }
    piece.area_m2 = static_cast<float>(where.area()) * kPixel_m * kPixel_m;
    above.height_m(where) = height_m;
    above.mask(where) = 255;
    above.on_table(where) = 0;
    pieces.label(where) = pieces.count();
    GroupHypothesis group;
    group.pieces = {pieces.count()};
    group.objectness = objectness;
    groups.push_back(group);
    pieces.pieces.push_back(piece);
  }

  void link(int first, int second, float probability, bool contact = true) {
    Link link{};
    link.first = first, link.second = second, link.contact = contact, link.probability = probability;
    links.push_back(link);
  }

  std::vector<int> standing(const std::vector<int>& chosen = {}) const {
    return standingGroups(frame, table, above, pieces, links, groups, chosen, config, 1);
  }
};

const cv::Rect kCompact(10, 10, 20, 20);  // 16 cm2

}  // namespace

TEST(StandingGroups, AreFoundWhateverTheirObjectness) {
  View view;
  view.add(kCompact, 0.008f, 0.01f);
  EXPECT_EQ(view.standing(), (std::vector<int>{0}));
  view.config.standing = false;
  EXPECT_TRUE(view.standing().empty());
}

TEST(StandingGroups, LieOverTheNoiseAndShowEnoughSurface) {
  View low;
  low.add(kCompact, 0.0035f);  // 1.75 sigma
  EXPECT_TRUE(low.standing().empty());
  View small;
  small.add({10, 10, 14, 14}, 0.03f);  // 7.8 cm2
  EXPECT_TRUE(small.standing().empty());
  small.add({24, 10, 14, 14}, 0.03f);
  small.link(0, 1, 0.9f);
  EXPECT_EQ(small.standing(), (std::vector<int>{0, 1})) << "in contact they show enough together";
}

TEST(StandingGroups, TouchNothingThatWasChosen) {
  View view;
  view.add(kCompact, 0.03f);
  view.add({30, 10, 20, 20}, 0.03f, 0.9f);
  view.link(0, 1, 0.2f);
  EXPECT_TRUE(view.standing({1}).empty()) << "a part of it, or its shadow";
  view.links[0].contact = false;
  EXPECT_EQ(view.standing({1}), (std::vector<int>{0})) << "over a gap";
}

TEST(StandingGroups, HaveACompactOutlineWithTableAround) {
  View ragged;
  for (int k = 0; k < 4; ++k)
    ragged.add({10 + 6 * k, 10 + 10 * k, 36 - 12 * k > 6 ? 36 - 12 * k : 40 - 6 * k, 4}, 0.009f);
  for (int k = 0; k < 3; ++k) ragged.link(k, k + 1, 0.9f);
  EXPECT_TRUE(ragged.standing().empty()) << "4.5 sigma";
  View high = ragged;
  high.above.height_m *= 1.2f;
  EXPECT_EQ(high.standing().size(), 4u) << "noise does not reach that far";

  View walled;
  walled.add(kCompact, 0.03f);
  walled.above.on_table(cv::Rect(0, 0, kSide, 22)).setTo(0);  // something else is seen around most of it
  EXPECT_TRUE(walled.standing().empty());
  View tray = walled;
  tray.above.container(cv::Rect(0, 0, kSide, 22)).setTo(255);
  EXPECT_EQ(tray.standing(), (std::vector<int>{0})) << "the wall of what it lies in";
  walled.above.height_m(cv::Rect(0, 0, kSide, 10)).setTo(std::nanf(""));
  walled.above.height_m(cv::Rect(0, 0, 10, kSide)).setTo(std::nanf(""));
  walled.above.height_m(cv::Rect(30, 0, 30, kSide)).setTo(std::nanf(""));
  EXPECT_EQ(walled.standing(), (std::vector<int>{0})) << "what has no depth says nothing";
}

TEST(StandingGroups, AreSeenDownToTheTable) {
  View view;
  view.add(kCompact, 0.03f);
  view.above.height_m(kCompact) += 0.02f;
  EXPECT_TRUE(view.standing().empty()) << "a part of something that hangs in the air";
  view.above.height_m(cv::Rect(kCompact.tl(), cv::Size(kCompact.width, 2))).setTo(0.035f);
  EXPECT_EQ(view.standing(), (std::vector<int>{0}));
}

TEST(StandingGroups, AreTheBestPackingOfWhatIsLeft) {
  View view;
  view.add({10, 10, 20, 20}, 0.03f, 0.2f);
  view.add({30, 10, 20, 20}, 0.03f, 0.2f);
  view.link(0, 1, 0.9f);
  GroupHypothesis both;
  both.pieces = {0, 1};
  both.objectness = 0.2f;
  view.groups.push_back(both);
  EXPECT_EQ(view.standing(), (std::vector<int>{2})) << "well linked";
  view.links[0].probability = 0.1f;
  EXPECT_EQ(view.standing(), (std::vector<int>{0, 1}));
}
