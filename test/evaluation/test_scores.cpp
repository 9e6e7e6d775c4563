// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "evaluation/scores.hpp"
#include "fixtures/label_pictures.hpp"
#include "fixtures/temporary_folder.hpp"

using namespace objectness::evaluation;
using namespace objectness_test;

namespace {

const cv::Size kSize(100, 80);

Scores scored(const cv::Mat_<ushort>& labels, const cv::Mat_<ushort>& truth) {
  const auto scores = scoreLabels(labels, truth);
  EXPECT_TRUE(scores.has_value());
  return scores.value_or(Scores{});
}

/// The scorer that the figures of this data are compared by, when it lies beside the data.
std::string referenceScorer() {
  const std::string data = sharedData();
  const std::string scorer = data.empty() ? "" : data + "/../tools/score_labels.py";
  return std::filesystem::exists(scorer) ? scorer : "";
}

using Row = std::map<std::string, double>;

std::map<std::string, Row> readCsv(const std::string& path) {
  std::map<std::string, Row> rows;
  std::ifstream file(path);
  std::string line, cell;
  std::vector<std::string> header;
  while (std::getline(file, line)) {
    line.erase(std::remove(line.begin(), line.end(), '\r'), line.end());
    std::vector<std::string> cells;
    for (std::istringstream stream(line); std::getline(stream, cell, ',');) cells.push_back(cell);
    if (header.empty()) {
      header = cells;
    } else {
      for (std::size_t i = 2; i < cells.size(); ++i) rows[cells[0]][header[i]] = std::stod(cells[i]);
    }
  }
  return rows;
}

}  // namespace

TEST(Truth, LevelsJoinTheTableAndTheParts) {
  cv::Mat_<ushort> annotation(1, 7);
  annotation << 0, 1, 9, 20, 21, 30, 315;
  cv::Mat_<ushort> objects(1, 7), parts(1, 7);
  objects << 0, 1, 1, 2, 2, 3, 31;
  parts << 0, 1, 1, 20, 21, 30, 315;
  EXPECT_EQ(cv::countNonZero(truthAtLevel(annotation, Level::kObject) != objects), 0);
  EXPECT_EQ(cv::countNonZero(truthAtLevel(annotation, Level::kPart) != parts), 0);
}

TEST(Scores, APerfectSegmentationIsPerfect) {
  const auto truth = paintLabels(kSize, 1, {{{10, 10, 20, 20}, 2}, {{50, 30, 30, 10}, 5}});
  const auto labels = paintLabels(kSize, 1, {{{10, 10, 20, 20}, 7}, {{50, 30, 30, 10}, 3}});  // other names
  const Scores scores = scored(labels, truth);
  Scores::fields(scores, [](const char* name, double value) {
    const bool error = std::string(name) == "extra" || name[1] == '_';
    EXPECT_NEAR(value, error ? 0 : 1, 1e-12) << name;
  });
}

TEST(Scores, MergedObjects) {
  // Objects of 100 and 300 pixels in one segment of 500, of which 100 lie on the table.
  const auto truth = paintLabels(kSize, 1, {{{10, 10, 10, 10}, 2}, {{20, 10, 30, 10}, 3}});
  const auto labels = paintLabels(kSize, 0, {{{10, 10, 50, 10}, 2}});
  const Scores scores = scored(labels, truth);
  EXPECT_NEAR(scores.precision, (0.2 + 0.6) / 2, 1e-12);
  EXPECT_NEAR(scores.recall, 1, 1e-12);
  EXPECT_NEAR(scores.overlap_precision, 300.0 / 500, 1e-12);
  EXPECT_NEAR(scores.overlap_recall, 300.0 / 400, 1e-12);
  EXPECT_NEAR(scores.overlap_f, 2 * 0.6 * 0.75 / 1.35, 1e-12);
  EXPECT_NEAR(scores.found_75, 0, 1e-12);  // Dice 600 / 800 does not exceed 0.75
  EXPECT_EQ(scores.extra, 0);
  EXPECT_NEAR(scores.over_segmentation, 0, 1e-12);
  EXPECT_NEAR(scores.under_segmentation, (400.0 / 100 + 200.0 / 300) / 2, 1e-12);
  EXPECT_NEAR(scores.weighted_overlap, (100 * 0.2 + 300 * 0.6) / 400, 1e-12);
}

TEST(Scores, ASplitObjectAndAStraySegment) {
  const auto truth = paintLabels(kSize, 1, {{{10, 10, 40, 10}, 2}, {{0, 60, 100, 20}, 0}});
  // Its larger half, its smaller half, a stray one on the table, one on void that does not count.
  const auto labels = paintLabels(
      kSize, 0, {{{10, 10, 30, 10}, 2}, {{40, 10, 10, 10}, 3}, {{70, 30, 10, 10}, 4}, {{10, 65, 10, 10}, 5}});
  const Scores scores = scored(labels, truth);
  EXPECT_NEAR(scores.precision, 1, 1e-12);
  EXPECT_NEAR(scores.recall, 0.75, 1e-12);
  EXPECT_NEAR(scores.over_segmentation, 0.25, 1e-12);
  EXPECT_NEAR(scores.overlap_precision, 300.0 / 500, 1e-12);
  EXPECT_EQ(scores.extra, 2);
  EXPECT_EQ(scores.found_75, 1);
  // The tolerance is ceil(0.003 * 128) = 1 pixel: of the ten of the side where it is cut all but four are far.
  const double outline = 2 * (30 + 10) - 4, others = 2 * (2 * (10 + 10) - 4);
  EXPECT_NEAR(scores.boundary_precision, (outline - 6) / (outline + others), 1e-12);
}

TEST(Scores, NothingFoundAndNothingToFind) {
  const auto truth = paintLabels(kSize, 1, {{{10, 10, 40, 10}, 2}});
  const Scores scores = scored(cv::Mat_<ushort>(kSize, ushort{1}), truth);
  EXPECT_EQ(scores.precision + scores.recall + scores.overlap_f + scores.boundary_f + scores.found_75, 0);
  EXPECT_EQ(scores.overlap_precision, 1);
  EXPECT_EQ(scores.boundary_precision, 1);
  EXPECT_EQ(scores.over_segmentation, 1);
  EXPECT_FALSE(scoreLabels(truth, cv::Mat_<ushort>(kSize, ushort{1})).has_value());
}

TEST(Scores, AgreeWithTheReferenceScorer) {
  const std::string scorer = referenceScorer();
  if (scorer.empty()) GTEST_SKIP() << "no recorded scenes with their scorer here: set OBJECTNESS_DATA";
  if (std::system("/usr/bin/python3 -c 'import cv2, numpy, scipy.optimize' 2>/dev/null") != 0) {
    GTEST_SKIP() << "the scorer needs python3-opencv, python3-numpy and python3-scipy";
  }
  // Recorded truth against itself moved aside, and random pictures full of ties.
  const TemporaryFolder folder;
  std::mt19937 random(2);
  for (int i = 0; i < 40; ++i) {
    const std::string name = std::to_string(i);
    cv::Mat_<ushort> truth, labels;
    const std::string recorded = sharedData() + "/mosd/learn" + name + "/labels.png";
    if (i < 15 && std::filesystem::exists(recorded)) {
      truth = cv::imread(recorded, cv::IMREAD_UNCHANGED);
      labels = cv::Mat_<ushort>(truth.size(), ushort{0});
      const int dx = 3 + i, dy = i / 2;
      const cv::Rect from(0, 0, truth.cols - dx, truth.rows - dy), to(dx, dy, from.width, from.height);
      truth(from).copyTo(labels(to));
    } else {
      const cv::Size size(40 + static_cast<int>(random() % 300), 40 + static_cast<int>(random() % 200));
      truth = randomLabels(size, 1 + i % 9, 20, random);
      labels = randomLabels(size, 1 + i % 7, 2, random);
    }
    for (const auto& [side, image] : {std::make_pair("truth", truth), std::make_pair("found", labels)}) {
      std::filesystem::create_directories(folder / (std::string(side) + "/" + name));
      cv::imwrite(folder / (std::string(side) + "/" + name + "/labels.png"), image);
    }
  }
  int compared = 0;
  for (const Level level : {Level::kObject, Level::kPart}) {
    const std::string csv = folder / "scores.csv";
    const std::string command = "/usr/bin/python3 " + scorer + " " + (folder / "found") + " " + (folder / "truth") +
                                " --csv " + csv + (level == Level::kPart ? " --parts" : "") + " >/dev/null";
    ASSERT_EQ(std::system(command.c_str()), 0);
    for (const auto& [name, expected] : readCsv(csv)) {
      const cv::Mat_<ushort> truth = cv::imread(folder / ("truth/" + name + "/labels.png"), cv::IMREAD_UNCHANGED);
      const cv::Mat_<ushort> labels = cv::imread(folder / ("found/" + name + "/labels.png"), cv::IMREAD_UNCHANGED);
      const Scores scores = scored(labels, truthAtLevel(truth, level));
      Scores::fields(scores, [&, scene = name, reference = expected](const char* column, double value) {
        if (!reference.count(column)) return;
        EXPECT_NEAR(value, reference.at(column), 1e-4) << scene << " " << column << " " << toString(level);
        ++compared;
      });
    }
  }
  EXPECT_GT(compared, 500);
}
