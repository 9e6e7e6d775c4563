// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <map>

#include "fixtures/small_scene.hpp"
#include "learning/training_scene.hpp"
#include "objectness_segmentation/learning/cue_list.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

class TrainingSceneTest : public testing::Test {
 protected:
  TrainingSceneTest() {
    const sim::Scene scene = stackedScene();
    const SceneImages images = sim::takePicture(scene.bodies, scene.T_world_camera, smallSensor(), 1);
    frame_ = makeFrame(images.depth_mm, images.color, images.camera, {}).value;
    truth_ = images.true_labels;
    scene_ = observe(frame_, truth_, {});
  }

  Frame frame_;
  cv::Mat_<ushort> truth_;
  TrainingScene scene_;
};

}  // namespace

TEST_F(TrainingSceneTest, PiecesBelongToTheObjectsTheyShareMostWith) {
  ASSERT_TRUE(scene_.status.ok()) << scene_.status.message;
  const int pieces = scene_.graph.pieces.count();
  ASSERT_GE(pieces, 5);
  ASSERT_EQ(scene_.object_size.size(), 3u);
  for (int o = 0; o < 3; ++o) EXPECT_EQ(scene_.object_size[o], cv::countNonZero(truth_ == 20 + 10 * o));
  std::map<int, int> pieces_of;
  for (int k = 0; k < pieces; ++k) {
    std::map<int, int> pixels;
    int labelled = 0;
    for (const int i : scene_.graph.pieces.pieces[k].pixels) {
      if (truth_(i) > 0) ++labelled;
      ++pixels[truth_(i)];
    }
    int best = 0;
    for (int o = 0; o < 3; ++o) {
      EXPECT_EQ(scene_.shared(k, o), pixels[20 + 10 * o]);
      best = std::max(best, pixels[20 + 10 * o]);
    }
    EXPECT_DOUBLE_EQ(scene_.purity[k], best / static_cast<double>(std::max(1, labelled)));
    if (best > 0) {
      EXPECT_EQ(pixels[20 + 10 * scene_.object[k]], best);
    }
    ++pieces_of[scene_.object[k]];
  }
  EXPECT_EQ(pieces_of.count(-1), 0u) << "nothing else is there";
  EXPECT_EQ(pieces_of.size(), 3u);
}

TEST_F(TrainingSceneTest, PairsOfPurePiecesAreSamples) {
  Samples contact = samplesOf<ContactCues>(), gap = samplesOf<GapCues>();
  addPairSamples(scene_, {}, contact, gap);
  EXPECT_EQ(contact.cues, cueNames<ContactCues>());
  EXPECT_EQ(contact.values.size(), contact.cues.size() * contact.size());
  EXPECT_EQ(gap.values.size(), gap.cues.size() * gap.size());
  std::vector<float> contact_targets, gap_targets;
  for (const PairEvidence& pair : scene_.graph.pairs) {
    if (scene_.purity[pair.first] < 0.85 || scene_.purity[pair.second] < 0.85) continue;
    auto& targets = std::holds_alternative<ContactCues>(pair.cues) ? contact_targets : gap_targets;
    targets.push_back(scene_.object[pair.first] == scene_.object[pair.second]);
  }
  EXPECT_EQ(contact.targets, contact_targets);
  EXPECT_EQ(gap.targets, gap_targets);
  EXPECT_GT(std::count(contact_targets.begin(), contact_targets.end(), 1.f), 0);
  EXPECT_GT(std::count(contact_targets.begin(), contact_targets.end(), 0.f), 0) << "the box on the box";

  TrainingConfig all_pure;
  all_pure.min_purity = 1.1;
  Samples none = samplesOf<ContactCues>(), none_of_gaps = samplesOf<GapCues>();
  addPairSamples(scene_, all_pure, none, none_of_gaps);
  EXPECT_EQ(none.size() + none_of_gaps.size(), 0u);
}

TEST_F(TrainingSceneTest, GroupsAreWorthTheirOverlap) {
  const Config config;
  TrainingConfig training;
  training.max_groups_per_scene = 1000000;
  Samples all = samplesOf<GroupCues>();
  addGroupSamples(scene_, defaultModel(), config, training, all);
  const auto groups =
      proposeObjects(frame_, scene_.table, scene_.edges, scene_.graph,
                     judgePairs(scene_.graph.pairs, scene_.graph.borders, defaultModel()), config.grouping, 1);
  ASSERT_EQ(all.size(), groups.size());
  for (std::size_t i = 0; i < groups.size(); ++i) {
    cv::Mat_<uchar> mask = cv::Mat_<uchar>::zeros(truth_.size());
    for (const int k : groups[i].pieces) {
      for (const int pixel : scene_.graph.pieces.pieces[k].pixels) mask(pixel) = 255;
    }
    double best = 0;
    for (const int label : {20, 30, 40}) {
      const cv::Mat object = truth_ == label;
      best = std::max(best, cv::countNonZero(mask & object) / static_cast<double>(cv::countNonZero(mask | object)));
    }
    EXPECT_NEAR(all.targets[i], best, 1e-5);
  }
  EXPECT_GT(*std::max_element(all.targets.begin(), all.targets.end()), 0.9f) << "an object is among them";

  training.max_groups_per_scene = 4;
  Samples few = samplesOf<GroupCues>();
  addGroupSamples(scene_, defaultModel(), config, training, few);
  EXPECT_EQ(few.size(), 4u);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(few.targets[i], all.targets[i * all.size() / 4]) << "drawn evenly";
}

TEST_F(TrainingSceneTest, AViewWithoutATableTeachesNothing) {
  Frame nothing = frame_;
  for (auto& point : nothing.points) point.setConstant(std::nanf(""));
  const TrainingScene scene = observe(nothing, truth_, {});
  EXPECT_FALSE(scene.status.ok());
  Samples contact = samplesOf<ContactCues>(), gap = samplesOf<GapCues>();
  addPairSamples(scene, {}, contact, gap);
  EXPECT_EQ(contact.size() + gap.size(), 0u);
}
