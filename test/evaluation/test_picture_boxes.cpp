// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <random>
#include <sstream>

#include "evaluation/picture_boxes.hpp"
#include "fixtures/label_pictures.hpp"
#include "fixtures/temporary_folder.hpp"

using namespace objectness;
using namespace objectness::evaluation;
using namespace objectness_test;

namespace {

const cv::Size kSize(200, 100);

PictureBox object(int u0, int v0, int u1, int v1) {
  return {{cv::Point2d(u0, v0), cv::Point2d(u1, v1)}, {(u0 + u1) / 2, (v0 + v1) / 2}};
}

std::vector<int> numbers(const PictureBoxCounts& counts) {
  std::vector<int> numbers;
  PictureBoxCounts::fields(counts, [&](const char*, int value) { numbers.push_back(value); });
  return numbers;
}

}  // namespace

TEST(PictureBoxes, AreCountedAsByHand) {
  const cv::Mat_<ushort> labels = paintLabels(kSize, 1,
                                              {{{10, 10, 20, 20}, 2},    // exactly the first object
                                               {{50, 10, 20, 12}, 3},    // 0.6 of the second
                                               {{100, 10, 22, 10}, 4},   // two objects in one, 100 of 220 each
                                               {{0, 60, 20, 15}, 5},     // 300 pixels that are nothing
                                               {{30, 60, 23, 13}, 6},    // 299
                                               {{20, 80, 10, 10}, 7}});  // half of the sixth
  const std::vector<PictureBox> truth{object(10, 10, 30, 30),   object(50, 10, 70, 30),   object(100, 10, 110, 20),
                                      object(112, 10, 122, 20), object(150, 60, 160, 70),  // on the table
                                      object(20, 80, 40, 90),   object(170, 60, 180, 70)};
  // objects, found, tight, merged, segments, stray
  EXPECT_EQ(numbers(countPictureBoxes(labels, truth)), (std::vector<int>{7, 3, 1, 2, 6, 1}));
}

TEST(PictureBoxes, PairsAreOneToOne) {
  // Both objects overlap the one segment by half at least; only one can have it.
  const cv::Mat_<ushort> labels = paintLabels(kSize, 0, {{{10, 10, 20, 10}, 9}});
  const std::vector<PictureBox> truth{object(10, 10, 22, 20), object(10, 10, 30, 20)};
  EXPECT_EQ(numbers(countPictureBoxes(labels, truth)), (std::vector<int>{2, 1, 1, 1, 1, 0}));
}

TEST(PictureBoxes, NothingFoundAndNothingThere) {
  const cv::Mat_<ushort> nothing(kSize, ushort{0}), one = paintLabels(kSize, 0, {{{10, 10, 20, 20}, 2}});
  EXPECT_EQ(numbers(countPictureBoxes(nothing, {object(10, 10, 30, 30)})), (std::vector<int>{1, 0, 0, 0, 0, 0}));
  EXPECT_EQ(numbers(countPictureBoxes(one, {})), (std::vector<int>{0, 0, 0, 0, 1, 1}));
}

TEST(PictureBoxes, AreReadFromTheScene) {
  const TemporaryFolder folder;
  EXPECT_TRUE(loadPictureBoxes(folder.path()).ok());
  EXPECT_TRUE(loadPictureBoxes(folder.path()).value.empty());
  writeBytes(folder / "objects.yaml",
             "objects:\n- {\"name\": \"mug\", \"seed\": [7, 8], \"box\": [5, 6, 15, 26], \"height_mm\": null}\n"
             "- {name: hidden}\n");
  const auto boxes = loadPictureBoxes(folder.path());
  ASSERT_TRUE(boxes.ok()) << boxes.status.message;
  ASSERT_EQ(boxes.value.size(), 1u);
  EXPECT_EQ(boxes.value[0].box, cv::Rect2d(5, 6, 10, 20));
  EXPECT_EQ(boxes.value[0].seed, cv::Point(7, 8));
  for (const char* bad : {"objects: [{box: [1, 2, 3, 4]}]", "objects: [{box: [1, 2, 3], seed: [1, 2]}]",
                          "objects: [{box: [1, 2, 1, 4], seed: [1, 2]}]", "objects: [{box: all, seed: [1, 2]}]",
                          "objects: [{box: [1, 2, 3, 4], seed: [1]}]", "objects: [{"}) {
    writeBytes(folder / "objects.yaml", bad);
    EXPECT_EQ(loadPictureBoxes(folder.path()).status.code, StatusCode::kBadInput) << bad;
    EXPECT_NE(loadPictureBoxes(folder.path()).status.message.find("objects.yaml"), std::string::npos) << bad;
  }
}

TEST(PictureBoxes, AgreeWithTheReferenceScorer) {
  const std::string scorer = sharedData() + "/../tools/score_boxes.py";
  if (sharedData().empty() || !std::filesystem::exists(scorer)) {
    GTEST_SKIP() << "no recorded scenes with their scorer here: set OBJECTNESS_DATA";
  }
  if (std::system("/usr/bin/python3 -c 'import cv2, numpy, scipy.optimize, yaml' 2>/dev/null") != 0) {
    GTEST_SKIP() << "the scorer needs python3-opencv, python3-numpy, python3-scipy and python3-yaml";
  }
  const TemporaryFolder folder;
  std::mt19937 random(6);
  std::map<std::string, std::vector<int>> expected;
  for (int i = 0; i < 40; ++i) {
    const std::string name = std::to_string(i);
    const cv::Mat_<ushort> labels = randomLabels(kSize, 1 + i % 9, 2, random);
    const auto below = [&](int limit) { return static_cast<int>(random() % static_cast<unsigned>(limit)); };
    std::vector<PictureBox> truth;
    std::ostringstream yaml;
    yaml << "objects:\n";
    for (int k = 0; k <= i % 8; ++k) {
      // About a segment, so that many are found, or anywhere.
      const cv::Mat_<uchar> own = labels == 2 + k;
      const cv::Rect about = k % 3 && cv::countNonZero(own) ? cv::boundingRect(own) : cv::Rect(20, 20, 60, 30);
      const int u0 = std::max(0, about.x - below(9)), v0 = std::max(0, about.y - below(9));
      const int u1 = std::min(kSize.width, about.br().x + below(9)),
                v1 = std::min(kSize.height, about.br().y + below(9));
      truth.push_back({{cv::Point2d(u0, v0), cv::Point2d(u1, v1)}, {u0 + below(u1 - u0), v0 + below(v1 - v0)}});
      yaml << "- {box: [" << u0 << ", " << v0 << ", " << u1 << ", " << v1 << "], seed: [" << truth.back().seed.x << ", "
           << truth.back().seed.y << "]}\n";
    }
    writeBytes(folder / ("truth/" + name + "/objects.yaml"), yaml.str());
    std::filesystem::create_directories(folder / ("found/" + name));
    cv::imwrite(folder / ("found/" + name + "/labels.png"), labels);
    expected[name] = numbers(countPictureBoxes(labels, loadPictureBoxes(folder / ("truth/" + name)).value));
  }
  const std::string csv = folder / "boxes.csv";
  ASSERT_EQ(std::system(("/usr/bin/python3 " + scorer + " " + (folder / "found") + " " + (folder / "truth") +
                         " --csv " + csv + " >/dev/null")
                            .c_str()),
            0);
  std::ifstream file(csv);
  std::string line, cell;
  std::getline(file, line);
  int compared = 0, found = 0, merged = 0, stray = 0;
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::string name;
    std::getline(cells, name, ',');
    std::vector<int> row;
    while (std::getline(cells, cell, ',')) row.push_back(std::stoi(cell));
    EXPECT_EQ(expected.at(name), row) << "scene " << name;
    found += row[1], merged += row[3], stray += row[5];
    ++compared;
  }
  EXPECT_EQ(compared, 40);
  EXPECT_GT(std::min({found, merged, stray}), 5) << "every count was put to the test";
}
