// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <set>

#include "common/true_labels.hpp"
#include "evaluation/piece_methods.hpp"
#include "evaluation/scores.hpp"
#include "fixtures/label_pictures.hpp"
#include "fixtures/leaf_model.hpp"
#include "fixtures/small_scene.hpp"
#include "learning/training_scene.hpp"
#include "objectness_segmentation/pipeline.hpp"

using namespace objectness;
using namespace objectness::evaluation;
using namespace objectness_test;

namespace {

Pieces piecesOf(const cv::Mat_<int>& label, int count) {
  Pieces pieces;
  pieces.label = label;
  pieces.pieces.resize(count);
  for (int i = 0; i < static_cast<int>(label.total()); ++i) {
    const int k = label(i / label.cols, i % label.cols);
    if (k >= 0) pieces.pieces[k].pixels.push_back(i);
  }
  return pieces;
}

/// Pixels of pieces whose owner is that of the truth.
int rightPixels(const cv::Mat_<int>& label, const cv::Mat_<ushort>& truth, const std::vector<int>& owners) {
  int right = 0;
  for (int i = 0; i < static_cast<int>(label.total()); ++i) {
    const int v = i / label.cols, u = i % label.cols;
    right += label(v, u) >= 0 && owners[label(v, u)] == trueObject(truth(v, u));
  }
  return right;
}

using PixelSets = std::set<std::vector<int>>;

PixelSets pixelsOf(const std::vector<Segment>& segments) {
  PixelSets sets;
  for (const Segment& segment : segments) sets.insert(segment.pixels);
  return sets;
}

class PieceMethods : public testing::Test {
 protected:
  PieceMethods() {
    const sim::Scene scene = stackedScene();
    const SceneImages images = sim::takePicture(scene.bodies, scene.T_world_camera, smallSensor(), 1);
    frame_ = makeFrame(images.depth_mm, images.color, images.camera, {}).value;
    truth_ = images.true_labels;
    pieces_ = observe(frame_, truth_, config_).graph.pieces;
  }
  /// The pixels of all pieces of one number, by these numbers.
  PixelSets joined(const std::vector<int>& number) const {
    std::map<int, std::vector<int>> sets;
    for (int i = 0; i < frame_.size(); ++i) {
      const int k = pieces_.label(i / frame_.width(), i % frame_.width());
      if (k >= 0 && number[k] >= 0) sets[number[k]].push_back(i);
    }
    PixelSets large;
    for (const auto& [n, pixels] : sets) {
      if (static_cast<int>(pixels.size()) >= config_.segments.min_pixels) large.insert(pixels);
    }
    return large;
  }

  Config config_;
  Frame frame_;
  cv::Mat_<ushort> truth_;
  Pieces pieces_;
};

}  // namespace

TEST(PieceOwners, NoOtherChoiceGetsMorePixelsRight) {
  constexpr int kPieces = 5, kObjects = 3;
  std::mt19937 random(4);
  for (int round = 0; round < 40; ++round) {
    const cv::Size size(24, 16);
    const cv::Mat_<ushort> truth = randomLabels(size, kObjects * kTrueLabelsPerObject, kFirstTrueLabel, random);
    const cv::Mat_<ushort> painted = randomLabels(size, kPieces, 2, random);
    cv::Mat_<int> label(size);
    std::transform(painted.begin(), painted.end(), label.begin(), [](ushort k) { return k < 2 ? -1 : k - 2; });
    const int right = rightPixels(label, truth, pieceOwners(piecesOf(label, kPieces), truth));
    std::vector<int> owners(kPieces, -1);
    int best = 0;
    for (int k = 0; k < kPieces;) {  // every choice of -1..kObjects-1 for every piece
      best = std::max(best, rightPixels(label, truth, owners));
      for (k = 0; k < kPieces && ++owners[k] == kObjects; ++k) owners[k] = -1;
    }
    EXPECT_EQ(right, best) << "round " << round;
  }
}

TEST(PieceOwners, BackgroundHasToBeMore) {
  const cv::Mat_<int> label = (cv::Mat_<int>(1, 9) << 0, 0, 0, 1, 1, 1, 1, 1, -1);
  const cv::Mat_<ushort> truth = (cv::Mat_<ushort>(1, 9) << 20, 25, 1, 30, 0, 1, 40, 40, 50);
  // The parts 20 and 25 are one object; of the other piece as much is an object's as is nobody's.
  EXPECT_EQ(pieceOwners(piecesOf(label, 2), truth), (std::vector<int>{0, 2}));
  const cv::Mat_<ushort> less = (cv::Mat_<ushort>(1, 9) << 20, 30, 1, 30, 0, 1, 40, 1, 50);
  EXPECT_EQ(pieceOwners(piecesOf(label, 2), less), (std::vector<int>{0, -1}));
}

TEST_F(PieceMethods, TheOracleJoinsThePiecesOfEachObject) {
  const Segmentation found = segmentByOracle(frame_, truth_, config_);
  ASSERT_TRUE(found.status.ok()) << found.status.message;
  std::vector<int> owners;
  for (const Piece& piece : pieces_.pieces) {
    std::vector<int> pixels(4, 0);
    for (const int i : piece.pixels) ++pixels[trueObject(truth_(i / truth_.cols, i % truth_.cols)) + 1];
    owners.push_back(static_cast<int>(std::max_element(pixels.begin(), pixels.end()) - pixels.begin()) - 1);
  }
  EXPECT_EQ(found.segments.size(), 3u);
  EXPECT_EQ(pixelsOf(found.segments), joined(owners));
  const cv::Mat_<ushort> objects = truthAtLevel(truth_, Level::kObject);
  const Scores oracle = scoreLabels(found.labels, objects).value();
  EXPECT_GE(oracle.overlap_f, scoreLabels(segment(frame_, config_).labels, objects).value().overlap_f);
  EXPECT_EQ(oracle.found_75, 1);
  for (const Segment& segment : found.segments) {
    EXPECT_GT(segment.objectness, 0.8);
    EXPECT_LE(segment.objectness, 1);
    EXPECT_GT(segment.box.size_m.minCoeff(), 0.02);
  }
}

TEST_F(PieceMethods, WithoutTruthTheOracleFindsNothing) {
  const Segmentation found = segmentByOracle(frame_, cv::Mat_<ushort>(truth_.size(), ushort{1}), config_);
  EXPECT_TRUE(found.status.ok());
  EXPECT_TRUE(found.segments.empty());
  EXPECT_EQ(found.labels.size(), truth_.size());
}

TEST_F(PieceMethods, ClustersAreWhatTheLinksSay) {
  const std::vector<int> apart = [&] {
    std::vector<int> numbers(pieces_.pieces.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
  }();
  const LearnedObjectness none = leafModel(0.1f, 0.1f, 0), all = leafModel(0.9f, 0.9f, 0.5f);
  EXPECT_EQ(pixelsOf(segmentByClustering(frame_, config_, &none).segments), joined(apart));
  // Links join what they reach: all that stands on this small table.
  const Segmentation together = segmentByClustering(frame_, config_, &all);
  EXPECT_EQ(pixelsOf(together.segments), joined(std::vector<int>(apart.size(), 0)));
  ASSERT_EQ(together.segments.size(), 1u);
  EXPECT_EQ(together.segments[0].objectness, 0.5);
}

TEST_F(PieceMethods, ClusteringFindsThreeBoxes) {
  const Segmentation found = segmentByClustering(frame_, config_);
  ASSERT_TRUE(found.status.ok()) << found.status.message;
  EXPECT_EQ(scoreLabels(found.labels, truthAtLevel(truth_, Level::kObject)).value().found_75, 1);
  Config threads = config_;
  threads.runtime.threads = 4;
  EXPECT_EQ(pixelsOf(segmentByClustering(frame_, threads).segments), pixelsOf(found.segments));
}

TEST_F(PieceMethods, BadInputIsAStatus) {
  config_.segments.min_pixels = 0;
  EXPECT_EQ(segmentByClustering(frame_, config_).status.code, StatusCode::kBadConfig);
  EXPECT_EQ(segmentByOracle(frame_, truth_, config_).status.code, StatusCode::kBadConfig);
}
