// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <set>
#include <sstream>

#include "fixtures/labelled_scene.hpp"
#include "fixtures/tool_test.hpp"
#include "objectness_segmentation/pipeline.hpp"
#include "sim/scene_generator.hpp"
#include "sim/simulated_frame.hpp"
#include "sim/truth_file.hpp"

using namespace objectness_test;
namespace sim = objectness::sim;

namespace {

/// Twelve small simulated scenes of two levels, and what the tool makes of them.
class LearnTool : public ToolTest {
 protected:
  static void SetUpTestSuite() {
    scenes_ = new TemporaryFolder;
    sim::DepthSensor sensor;
    sensor.camera = {262.5, 262.5, 159.5, 119.5, 320, 240};
    for (const char* level : {"stacked", "occluded"}) {
      for (std::uint32_t i = 0; i < 6; ++i) {
        sim::SceneRequest request;
        request.level = level;
        request.index = i;
        request.objects = 4;
        request.camera = sensor.camera;
        const auto scene = sim::generateScene(request);
        ASSERT_TRUE(scene.ok()) << scene.status.message;
        const auto frame = sim::simulateFrame(scene.value, scene.value.T_world_camera, sensor, sim::noiseSeed(1, i, 0));
        const std::string folder = *scenes_ / ("set/" + std::string(level) + "_" + std::to_string(i));
        ASSERT_TRUE(sim::saveSimulatedFrame(folder, frame).ok());
      }
    }
  }
  static void TearDownTestSuite() {
    delete scenes_;
    scenes_ = nullptr;
  }

  Outcome run(const std::string& arguments) const { return ToolTest::run("learn_objectness", arguments); }
  Outcome learn(const std::string& arguments) const { return run("--folds 2 --out " + (folder_ / arguments)); }
  void expectError(const std::string& arguments, const std::string& text) const {
    const Outcome outcome = run("--out " + (folder_ / "model.json") + " " + arguments);
    EXPECT_EQ(outcome.exit_status, 1) << arguments;
    EXPECT_NE(outcome.err.find(text), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.compare(0, 18, "learn_objectness: "), 0) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "model.json"));
  }
  void expectUsageError(const std::string& arguments, const std::string& text) const {
    ToolTest::expectUsageError("learn_objectness", arguments, text);
  }
  static std::string set() { return *scenes_ / "set"; }

  static TemporaryFolder* scenes_;
};

TemporaryFolder* LearnTool::scenes_ = nullptr;

}  // namespace

TEST_F(LearnTool, LearnsAModelThatSegments) {
  const Outcome outcome = learn("model.json --threads 2 --note 'two levels' " + set());
  ASSERT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.out.compare(0, 20, "12 scenes; samples: "), 0) << outcome.out;
  EXPECT_NE(outcome.out.find("held out"), std::string::npos);
  EXPECT_NE(outcome.out.find("ALL"), std::string::npos);

  const auto model = objectness::loadModel(folder_ / "model.json");
  ASSERT_TRUE(model.ok()) << model.status.message;
  EXPECT_EQ(model.value.trained_on, "two levels");
  saveLabelledScene(folder_ / "scene", 0.05);
  const objectness::Config config;
  const auto frame = objectness::loadSceneFolder(folder_ / "scene", {}, config.input);
  ASSERT_TRUE(frame.ok());
  const objectness::Segmentation result = objectness::segment(frame.value, config, model.value);
  EXPECT_TRUE(result.status.ok()) << result.status.message;
  EXPECT_EQ(result.segments.size(), 3u) << "two boxes and a ball that stand apart";
}

TEST_F(LearnTool, TheSameModelTwiceWithAnyNumberOfThreads) {
  const Outcome two = learn("two.json --threads 2 " + set()), one = learn("one.json --threads 1 " + set());
  ASSERT_EQ(two.exit_status, 0) << two.err;
  EXPECT_EQ(two.out, one.out);
  EXPECT_GT(readBytes(folder_ / "two.json").size(), 1000u);
  EXPECT_EQ(readBytes(folder_ / "two.json"), readBytes(folder_ / "one.json"));
}

TEST_F(LearnTool, LearnsWithoutWhatIsSwitchedOff) {
  const std::string switches = "--set links.gaps=false group_cues.best_outside=false group_cues.hides=false ";
  const Outcome outcome = learn("model.json " + switches + set());
  ASSERT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find(" 0 gaps,"), std::string::npos) << outcome.out;
  const auto model = objectness::loadModel(folder_ / "model.json");
  ASSERT_TRUE(model.ok()) << model.status.message;
  EXPECT_EQ(model.value.gap.predict(std::vector<float>(model.value.gap.cues.size(), 1)), 0);
  std::set<std::string> used;
  for (const auto& tree : model.value.group.trees) {
    for (const auto& node : tree) {
      if (node.cue >= 0) used.insert(model.value.group.cues[static_cast<std::size_t>(node.cue)]);
    }
  }
  EXPECT_GT(used.size(), 5u);
  for (const char* off : {"best_outside", "hides"}) EXPECT_EQ(used.count(off), 0u) << off;
}

TEST_F(LearnTool, RecordedScenesCountAsOftenAsAsked) {
  std::filesystem::copy(set(), folder_ / "own", std::filesystem::copy_options::recursive);
  const std::string own = folder_ / "own";
  const auto pairs = [](const Outcome& outcome) { return outcome.out.substr(0, outcome.out.find(" gaps")); };
  ASSERT_EQ(learn("simulated.json --recorded-weight 3 " + own).exit_status, 0);
  std::filesystem::remove(own + "/stacked_0/pose.yaml");
  const Outcome once = learn("once.json " + own), thrice = learn("thrice.json --recorded-weight 3 " + own);
  EXPECT_EQ(readBytes(folder_ / "once.json"), readBytes(folder_ / "simulated.json")) << "none was recorded";
  EXPECT_NE(readBytes(folder_ / "once.json"), readBytes(folder_ / "thrice.json"));
  EXPECT_EQ(pairs(once), pairs(thrice)) << "there are no more of them";
}

TEST_F(LearnTool, ScenesThatTeachNothingAreNamed) {
  std::filesystem::copy(set(), folder_ / "own", std::filesystem::copy_options::recursive);
  truncateFile(folder_ / "own/stacked_0/depth.png", 0.5);
  const Outcome outcome = learn("model.json " + (folder_ / "own"));
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("left out: "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("own/stacked_0"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.errorLines(), 1) << outcome.err;
}

TEST_F(LearnTool, ScenesWhoseTableIsNotFoundCountAsNothingFound) {
  std::filesystem::copy(set(), folder_ / "own", std::filesystem::copy_options::recursive);
  const auto scored = [&] {
    const Outcome outcome = learn("model.json " + (folder_ / "own"));
    EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
    std::istringstream row(outcome.out.substr(outcome.out.find("\nALL") + 4));
    int scenes = 0;
    double precision = 0, recall = 0;
    row >> scenes >> precision >> recall;
    EXPECT_EQ(scenes, 12) << outcome.out;
    return recall;
  };
  const double before = scored();
  cv::Mat_<ushort> noise(240, 320);
  std::uint32_t state = 1;
  for (ushort& depth : noise) depth = static_cast<ushort>(600 + (state = 1664525 * state + 1013904223) % 1500);
  cv::imwrite(folder_ / "own/stacked_0/depth.png", noise);
  const double after = scored();
  EXPECT_GT(before, 0.5);
  EXPECT_LT(after, before - 0.04) << "a twelfth of the scenes";
}

TEST_F(LearnTool, BadInputIsNamed) {
  for (const char* folder : {"empty", "unlabelled"}) std::filesystem::create_directories(folder_ / folder);
  std::filesystem::copy(set() + "/stacked_1", folder_ / "unlabelled/a", std::filesystem::copy_options::recursive);
  std::filesystem::remove(folder_ / "unlabelled/a/labels.png");
  const struct {
    std::string arguments, error;
  } cases[] = {
      {folder_ / "nowhere", "there is no such folder"},
      {folder_ / "empty", "neither is a scene folder nor holds any with a labels.png"},
      {folder_ / "unlabelled/a", "holds no labels.png"},
      {set() + "/stacked_0 " + set() + "/stacked_1", "2 scenes are too few for 5 folds"},
      {"--groups " + (folder_ / "none.csv") + " " + set(), "none.csv"},
  };
  for (const auto& c : cases) expectError(c.arguments, c.error);
}

TEST_F(LearnTool, ScenesWithoutPairsAreTooLittle) {
  // TableClusters that stand apart: no two of them touch.
  for (int i = 0; i < 2; ++i) saveLabelledScene(folder_ / ("apart/s" + std::to_string(i)), 0.04 + 0.01 * i);
  const Outcome outcome = learn("model.json " + (folder_ / "apart"));
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_NE(outcome.err.find("more and fuller scenes are needed"), std::string::npos) << outcome.err;
}

TEST_F(LearnTool, AModelThatCannotBeWrittenIsSaidBeforeScenesAreLookedAt) {
  const std::pair<std::string, std::string> cases[] = {{folder_ / "nowhere/model.json", "there is no folder"},
                                                       {folder_.path(), "it is a folder"}};
  for (const auto& [path, reason] : cases) {
    const Outcome outcome = run("--folds 2 --out " + path + " " + (folder_ / "no_scenes"));
    EXPECT_EQ(outcome.exit_status, 1);
    EXPECT_EQ(outcome.errorLines(), 1) << outcome.err;
    EXPECT_NE(outcome.err.find("--out " + path + ": cannot be written: " + reason), std::string::npos) << outcome.err;
  }
}

TEST_F(LearnTool, UsageErrors) {
  const std::string out = "--out " + (folder_ / "model.json") + " ";
  expectUsageError(set(), "no --out MODEL.json given");
  expectUsageError(out, "no SCENES given");
  expectUsageError(out + "--folds 1 " + set(), "--folds must be at least 2");
  expectUsageError(out + "--folds many " + set(), "many");
  expectUsageError(out + "--threads -1 " + set(), "--threads must not be negative");
  expectUsageError(out + "--set group_cues.smell=false " + set(), "there is no parameter group_cues.smell");
  expectUsageError(out + "--recorded-weight 0 " + set(), "--recorded-weight must be at least 1");
  expectUsageError(out + "--no-such-option " + set(), "no-such-option");
  const Outcome help = run("--help");
  EXPECT_EQ(help.exit_status, 0);
  EXPECT_NE(help.out.find("learn_objectness --out MODEL.json"), std::string::npos);
}
