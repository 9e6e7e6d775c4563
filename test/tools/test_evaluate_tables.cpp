// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "fixtures/evaluate_tool.hpp"

using namespace objectness_test;
using Json = nlohmann::json;
namespace fs = std::filesystem;

TEST_F(EvaluateTool, ReportsByCameraWithBoxesAloneBesideLabels) {
  const std::string boxed = copyScene("s1", "s1");  // in another data set, of the same name
  fs::remove(boxed + "/labels.png");
  writeBytes(boxed + "/objects.yaml", "objects:\n- {seed: [160, 120], box: [0, 0, 5, 5]}\n");
  const Outcome outcome = run("--method mps --method oracle --method clustering --report " + (folder_ / "report") +
                              " " + all() + " " + (folder_ / "own"));
  ASSERT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("By camera"), std::string::npos) << outcome.out;
  const std::string csv = readBytes(folder_ / "report/cameras.csv");
  EXPECT_EQ(csv.find("method,camera,group,scenes,labelled,P,R,OvF,BdF,F75,extra,objects,found,tight,merged,segments,"
                     "stray,ms\n"),
            0u)
      << csv;
  for (const char* row :
       {"\nmps,own,,1,0,,,,,,,1,0,0,0,", "\nmps,set,easy,2,2,", "\nmps,set,,4,4,", "\noracle,set,,4,4,"})
    EXPECT_NE(csv.find(row), std::string::npos) << row << "\n" << csv;
  EXPECT_EQ(csv.find("\noracle,own,"), std::string::npos) << "it is told labels, and there are none";
  EXPECT_NE(readBytes(folder_ / "report/picture_boxes.csv").find("\nmps,own/s1,1,0,"), std::string::npos);
  EXPECT_TRUE(fs::exists(folder_ / "report/results/mps/own/s1/labels.png"));
  EXPECT_EQ(readJson("report/run.json")["scenes"][0]["camera"], "own");
  const Json summary = readJson("report/summary.json");
  EXPECT_EQ(summary["mps"]["object"]["ALL"]["scenes"], 4);
  EXPECT_GE(summary["oracle"]["object"]["ALL"]["OvF"], summary["clustering"]["object"]["ALL"]["OvF"]);
  if (fs::exists(folder_ / "report/report.html")) {
    EXPECT_NE(readBytes(folder_ / "report/report.html").find("<h2>By camera</h2>"), std::string::npos);
  }
}

TEST_F(EvaluateTool, ReportsBoxesInSpaceOfSimulatedScenes) {
  const std::string scene = folder_ / "simulated";
  ASSERT_EQ(ToolTest::run("make_scene", "--level shapes --seed 3 --out " + scene).exit_status, 0);
  const Outcome outcome =
      run("--method objectness --method lccp --method oracle --report " + (folder_ / "report") + " " + scene);
  ASSERT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("Boxes in space"), std::string::npos) << outcome.out;
  const std::string csv = readBytes(folder_ / "report/boxes.csv"), each = readBytes(folder_ / "report/objects.csv");
  const auto count = readJson("report/results/lccp/simulated.json")["box_fits"].size();
  EXPECT_GT(count, 0u);
  EXPECT_EQ(std::count(each.begin(), each.end(), '\n'), 1 + 3 * static_cast<long>(count));
  for (const char* method : {"objectness", "lccp", "oracle"}) {
    EXPECT_NE(csv.find(std::string(method) + ",all,,"), std::string::npos) << csv;
    double best = 0;
    const Json result = readJson(std::string("report/results/") + method + "/simulated.json");
    for (const Json& fit : result["box_fits"]) {
      best = std::max(best, fit["overlap"].get<double>());
    }
    EXPECT_GT(best, 0.3) << method;
  }
}

TEST_F(EvaluateTool, TellsHowStillTheResultsOfAStillSceneAre) {
  for (const char* frame : {"frame_0", "frame_1", "frame_2"}) {
    copyScene("s1", frame);
    fs::remove(folder_ / (std::string("own/") + frame + "/labels.png"));
  }
  const Outcome outcome = evaluate("report", "--method objectness --still " + (folder_ / "own"));
  ASSERT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("Stability"), std::string::npos) << outcome.out;
  const std::string csv = readBytes(folder_ / "report/stability.csv");
  EXPECT_EQ(csv.find("method,sequence,frames,count,count_spread,switches,segment_IoU,"), 0u) << csv;
  for (const char* method : {"mps", "objectness"}) {
    const auto row = csv.find(std::string("\n") + method + ",own,3,");
    ASSERT_NE(row, std::string::npos) << csv;
    EXPECT_NE(csv.find(",0.00000,0.00000,1.00000,0.00000,0.00000,0.00000,0.00000", row), std::string::npos)
        << "the same picture three times:\n"
        << csv;
  }
  const Outcome fused = evaluate("fused", "--method objectness --still --fuse-frames 4 " + (folder_ / "own"));
  ASSERT_EQ(fused.exit_status, 0) << fused.err;
  const std::string settings = readBytes(folder_ / "fused/run.json");
  EXPECT_NE(settings.find("fused: 4"), std::string::npos) << settings;
  expectOneError(evaluate("other", folder_ / "own"), "with a labels.png or objects.yaml");
  ToolTest::expectUsageError("evaluate", "--report r --still --shard 1/2 scenes", "--still: needs all frames");
  ToolTest::expectUsageError("evaluate", "--report r --fuse-frames 4 scenes", "--fuse-frames belongs to --still");
}
