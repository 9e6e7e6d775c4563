// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "fixtures/leaf_model.hpp"
#include "fixtures/small_scene.hpp"
#include "learning/training_scene.hpp"
#include "objectness_segmentation/config_fields.hpp"
#include "objectness_segmentation/io/config_yaml.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

/// Cues that all differ from their defaults.
template <class Cues>
Cues unusual() {
  Cues cues;
  float next = 7;
  Cues::cues(cues, [&](const char*, float& value) { value = next++; });
  return cues;
}

template <class Cues>
std::size_t indexOf(const std::string& name) {
  const std::vector<std::string> names = cueNames<Cues>();
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

template <class Cues>
void expectEachSwitchToSilenceItsCueOnly(const std::string& group) {
  const std::vector<std::string> names = cueNames<Cues>();
  const std::vector<float> neutral = cueValues(Cues()), all = cueValues(unusual<Cues>());
  EXPECT_EQ(cueValues(CueSwitches<Cues>()(unusual<Cues>())), all) << "on by default";
  Config config;
  std::vector<ConfigField> fields = configFields(config);
  std::size_t k = 0;
  for (const ConfigField& field : fields) {
    if (field.group != group) continue;
    ASSERT_LT(k, names.size());
    EXPECT_EQ(field.name, names[k]);
    CueSwitches<Cues> switches;
    switches.on[k] = false;
    std::vector<float> expected = all;
    expected[k] = neutral[k];
    EXPECT_EQ(cueValues(switches(unusual<Cues>())), expected) << field.name;
    ++k;
  }
  EXPECT_EQ(k, names.size());
}

/// Two boxes and what training makes of them.
class CueSwitchesScene : public testing::Test {
 protected:
  CueSwitchesScene() {
    const sim::Scene scene = smallScene();
    const SceneImages images = sim::takePicture(scene.bodies, scene.T_world_camera, smallSensor(), 1);
    frame_ = makeFrame(images.depth_mm, images.color, images.camera, {}).value;
    truth_ = images.true_labels;
  }
  TrainingScene observeWith(const std::vector<std::string>& assignments) {
    EXPECT_TRUE(setParameters(assignments, config_).ok());
    return observe(frame_, truth_, config_);
  }

  Frame frame_;
  cv::Mat_<ushort> truth_;
  Config config_;
};

}  // namespace

TEST(CueSwitches, EachSilencesItsCueOnly) {
  expectEachSwitchToSilenceItsCueOnly<ContactCues>("contact_cues");
  expectEachSwitchToSilenceItsCueOnly<GapCues>("gap_cues");
  expectEachSwitchToSilenceItsCueOnly<GroupCues>("group_cues");
}

TEST_F(CueSwitchesScene, PairsAreTheSameButForWhatIsOff) {
  const TrainingScene all = observeWith({});
  const TrainingScene less = observeWith({"contact_cues.angle_median_deg=false", "gap_cues.cosine=false"});
  ASSERT_EQ(less.graph.pairs.size(), all.graph.pairs.size());
  int contacts = 0, gaps = 0;
  for (std::size_t i = 0; i < all.graph.pairs.size(); ++i) {
    if (const auto* contact = std::get_if<ContactCues>(&all.graph.pairs[i].cues)) {
      ContactCues expected = *contact;
      EXPECT_NE(expected.angle_median_deg, 0);
      expected.angle_median_deg = 0;
      EXPECT_EQ(cueValues(std::get<ContactCues>(less.graph.pairs[i].cues)), cueValues(expected));
      ++contacts;
    } else {
      GapCues expected = std::get<GapCues>(all.graph.pairs[i].cues);
      expected.cosine = 0;
      EXPECT_EQ(cueValues(std::get<GapCues>(less.graph.pairs[i].cues)), cueValues(expected));
      ++gaps;
    }
  }
  EXPECT_GT(contacts, 0);
  EXPECT_GT(gaps, 0);

  const TrainingScene touching = observeWith({"links.gaps=false"});
  EXPECT_EQ(touching.graph.pairs.size(), static_cast<std::size_t>(contacts));
}

TEST_F(CueSwitchesScene, GroupsAreLearnedWithoutWhatIsOff) {
  const TrainingScene scene = observeWith({});
  TrainingConfig training;
  training.max_groups_per_scene = 1000000;
  const LearnedObjectness links = leafModel(0.6f, 0.4f, 0);
  Samples all = samplesOf<GroupCues>(), less = samplesOf<GroupCues>();
  addGroupSamples(scene, links, config_, training, all);
  ASSERT_TRUE(setParameters({"group_cues.weakest_piece=false", "group_cues.pieces=false"}, config_).ok());
  addGroupSamples(scene, links, config_, training, less);

  ASSERT_EQ(less.size(), all.size());
  const std::size_t columns = all.cues.size(), weakest = indexOf<GroupCues>("weakest_piece"),
                    pieces = indexOf<GroupCues>("pieces");
  bool differs = false;
  for (std::size_t i = 0; i < all.values.size(); ++i) {
    const std::size_t column = i % columns;
    const float expected = column == weakest ? 1 : column == pieces ? 0 : all.values[i];
    EXPECT_EQ(less.values[i], expected) << all.cues[column];
    differs |= all.values[i] != expected;
  }
  EXPECT_TRUE(differs);
  const Forest forest = trainForest(less, {30, 9, 2});
  int splits = 0;
  for (const auto& tree : forest.trees) {
    for (const Forest::Node& node : tree) {
      splits += node.cue >= 0;
      EXPECT_NE(node.cue, static_cast<int>(weakest));
      EXPECT_NE(node.cue, static_cast<int>(pieces));
    }
  }
  EXPECT_GT(splits, 30);
}
