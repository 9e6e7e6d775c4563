// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <new>

#include "evaluation/experiment.hpp"
#include "fixtures/labelled_scene.hpp"
#include "fixtures/temporary_folder.hpp"

using namespace objectness;
using namespace objectness::evaluation;
using namespace objectness_test;
using State = SceneResult::State;
namespace fs = std::filesystem;

namespace {

/// Labels everything as one segment.
Segmentation oneSegment(const Frame& frame) {
  Segmentation result;
  result.labels = cv::Mat_<ushort>(frame.height(), frame.width(), ushort{2});
  result.segments.resize(1);
  result.report.timings_ms = {{"total", 5}};
  return result;
}

Method method(const std::string& name, const std::function<Segmentation(const Frame&)>& run) {
  return {name, "", name, run};
}

class Experiment : public testing::Test {
 protected:
  void SetUp() override { saveLabelledScene(scene_.folder, 0.05); }
  std::vector<SceneResult> run(const std::vector<Method>& methods) {
    computed_ = 0;
    const auto results = runExperiment(folder_ / "report", {scene_}, methods, 2,
                                       [&](const Progress& progress) { computed_ = progress.computed; });
    EXPECT_TRUE(results.ok()) << results.status.message;
    return results.value;
  }

  TemporaryFolder folder_;
  evaluation::Scene scene_{"scene", folder_ / "scene"};
  int computed_ = 0;
};

}  // namespace

TEST_F(Experiment, AMethodThatDiesCostsOnlyItself) {
  const std::vector<Method> methods{
      method("crash",
             [](const Frame&) -> Segmentation {
               raise(SIGSEGV);
               return {};
             }),
      method("good", oneSegment),
      method("hungry", [](const Frame&) -> Segmentation { throw std::bad_alloc(); }),
      method("throws", [](const Frame&) -> Segmentation { throw std::runtime_error("no idea"); }),
      method("refuses",
             [](const Frame&) {
               Segmentation s;
               s.status = Status::error(StatusCode::kNoTable, "no table");
               return s;
             }),
      method("odd", [](const Frame&) { return Segmentation{}; }),
  };
  const auto results = run(methods);
  ASSERT_EQ(results.size(), methods.size());
  const char* const problems[] = {"signal 11", "",         "needs more memory than there is",
                                  "no idea",   "no table", "labels of another size"};
  for (std::size_t i = 0; i < methods.size(); ++i) {
    EXPECT_EQ(results[i].method, methods[i].name);
    EXPECT_EQ(results[i].state, methods[i].name == "good" ? State::kDone : State::kFailed);
    EXPECT_NE(results[i].problem.find(problems[i]), std::string::npos) << results[i].problem;
    ASSERT_TRUE(results[i].object.has_value());
    EXPECT_EQ(results[i].object->recall, methods[i].name == "good" ? 1 : 0) << methods[i].name;
  }
  EXPECT_EQ(results[1].segments, 1);
  EXPECT_EQ(results[1].totalMs(), 5.0);

  run(methods);
  EXPECT_EQ(computed_, 5);  // what failed is tried again
}

TEST_F(Experiment, PeakMemoryIsThatOfEachMethod) {
  constexpr std::size_t kMib = 1 << 20;
  const auto results = run({method("large",
                                   [](const Frame& frame) {
                                     std::vector<char> memory(200 * kMib);
                                     for (std::size_t i = 0; i < memory.size(); i += 4096) {
                                       static_cast<volatile char*>(memory.data())[i] = 1;
                                     }
                                     return oneSegment(frame);
                                   }),
                            method("small", oneSegment)});
  EXPECT_GT(results[0].peak_mib, 200);
  EXPECT_LT(results[1].peak_mib, results[0].peak_mib - 150);
}

TEST_F(Experiment, AScenesFilesAndTheSettingsDecideAboutARerun) {
  Method same = method("good", oneSegment);
  run({same});
  EXPECT_EQ(computed_, 1);
  run({same});
  EXPECT_EQ(computed_, 0);
  same.settings = "other";
  run({same});
  EXPECT_EQ(computed_, 1);
  saveLabelledScene(scene_.folder, 0.06);
  run({same});
  EXPECT_EQ(computed_, 1);
}

TEST_F(Experiment, ASceneWithoutObjectsIsNotScored) {
  SceneImages images;
  images.camera = {262.5, 262.5, 159.5, 119.5, 320, 240};
  images.depth_mm = cv::Mat_<ushort>(240, 320, ushort{900});
  images.true_labels = cv::Mat_<ushort>(240, 320, ushort{1});
  ASSERT_TRUE(saveSceneFolder(scene_.folder, images).ok());
  const auto results = run({method("good", oneSegment)});
  EXPECT_EQ(results[0].state, State::kDone);
  EXPECT_FALSE(results[0].object.has_value());
}

TEST_F(Experiment, BoxesInThePictureAreTruthEnough) {
  fs::remove(scene_.folder + "/labels.png");
  writeBytes(scene_.folder + "/objects.yaml",
             "objects:\n- {seed: [9, 9], box: [0, 0, 320, 240]}\n- {seed: [99, 99], box: [90, 90, 110, 110]}\n");
  Method knowing = method("oracle", {});
  knowing.run_knowing = [](const Frame& frame, const cv::Mat_<ushort>&) { return oneSegment(frame); };
  const std::vector<Method> methods{method("good", oneSegment), knowing,
                                    method("throws", [](const Frame&) -> Segmentation { throw std::bad_alloc(); })};
  const auto results = run(methods);
  EXPECT_EQ(results[0].state, State::kDone);
  EXPECT_FALSE(results[0].object.has_value());
  ASSERT_TRUE(results[0].picture_boxes.has_value());
  EXPECT_EQ(results[0].picture_boxes->found, 1);
  EXPECT_EQ(results[0].picture_boxes->merged, 1);
  EXPECT_EQ(results[1].state, State::kNotApplicable) << "it is told labels, and there are none";
  EXPECT_FALSE(results[1].picture_boxes.has_value());
  EXPECT_EQ(results[2].state, State::kFailed);
  EXPECT_EQ(results[2].picture_boxes->objects, 2);
  EXPECT_EQ(results[2].picture_boxes->found, 0);
  run(methods);
  EXPECT_EQ(computed_, 1) << "only what failed is tried again";

  for (const char* bad : {"objects:\n- {seed: [320, 9], box: [0, 0, 320, 240]}\n", "objects:\n- {box: [1]}\n"}) {
    writeBytes(scene_.folder + "/objects.yaml", bad);
    const auto refused = run({method("good", oneSegment)});
    EXPECT_EQ(refused[0].state, State::kUnusable);
    EXPECT_NE(refused[0].problem.find("objects.yaml"), std::string::npos) << refused[0].problem;
  }
}

TEST_F(Experiment, AMethodThatIsToldTheTruthGetsIt) {
  Method knowing = method("oracle", {});
  knowing.run_knowing = [](const Frame& frame, const cv::Mat_<ushort>& true_labels) {
    Segmentation result = oneSegment(frame);
    result.labels.setTo(0, true_labels != 20);
    return result;
  };
  const auto results = run({knowing});
  EXPECT_EQ(results[0].state, State::kDone) << results[0].problem;
  EXPECT_NEAR(results[0].object->found_75, 1.0 / 3, 1e-12);
  EXPECT_EQ(results[0].object->extra, 0);
}

TEST_F(Experiment, ScenesInFoldersOfTheirDataSet) {
  scene_.name = "set/scene";
  const auto results = run({method("good", oneSegment)});
  EXPECT_EQ(results[0].state, State::kDone);
  for (const char* file : {"results/good/set/scene.json", "results/good/set/scene/labels.png", "truth/set/scene.png"}) {
    EXPECT_TRUE(fs::exists(folder_ / (std::string("report/") + file))) << file;
  }
  EXPECT_EQ(loadResult(folder_ / "report", "good", "set/scene").value.object->recall, 1);
}
