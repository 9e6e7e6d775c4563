// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "fixtures/evaluate_tool.hpp"
#include "fixtures/leaf_model.hpp"

using namespace objectness_test;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

const char* const kColumns[] = {"P",   "R",     "OvP",  "OvR",  "OvF", "BdP", "BdR",     "BdF",
                                "F75", "extra", "F_os", "F_us", "WO",  "ms",  "peak_mib"};

}  // namespace

TEST_F(EvaluateTool, WritesTheReport) {
  const Outcome outcome = evaluate("report", "--method lccp --level part --level object --jobs 2 " + all());
  ASSERT_EQ(outcome.exit_status, 0) << outcome.err;
  const Json summary = readJson("report/summary.json");
  for (const char* method : {"mps", "lccp"}) {
    for (const char* level : {"object", "part"}) {
      ASSERT_EQ(summary[method][level].size(), 3u);
      for (const auto& [group, scenes] :
           {std::make_pair("easy", 2), std::make_pair("hard", 2), std::make_pair("ALL", 4)}) {
        const Json& columns = summary[method][level][group];
        EXPECT_EQ(columns["scenes"], scenes);
        for (const char* column : kColumns) EXPECT_TRUE(columns.at(column).is_number()) << column;
        EXPECT_GT(columns["ms"], 0);
        EXPECT_GT(columns["peak_mib"], 10);
        EXPECT_GT(columns["R"], 0.3) << "the method finds nothing";
      }
    }
  }
  const std::string csv = readBytes(folder_ / "report/scenes.csv");
  EXPECT_EQ(csv.compare(0, 38, "method,level,scene,group,state,P,R,OvP"), 0) << csv;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2 * 2 * 4);
  for (const char* file : {"results/mps/s1/labels.png", "results/lccp/s4/overlay.png", "truth/s2.png"}) {
    EXPECT_FALSE(cv::imread(folder_ / (std::string("report/") + file), cv::IMREAD_UNCHANGED).empty()) << file;
  }
}

TEST_F(EvaluateTool, MeasuresTheProposalsOfItsOwnMethods) {
  ASSERT_EQ(run("--method boxes --method mps --report " + (folder_ / "report") + " " + all() + "/s1").exit_status, 0);
  const Json figures = readJson("report/summary.json")["boxes"]["object"]["ALL"];
  EXPECT_EQ(figures["boxed_objects"], 3);
  EXPECT_GT(figures["best_P"], 0.9);
  double last = 0;
  for (const char* kept : {"1", "5", "10", "20", "100"}) {
    const double recall = figures[std::string("box50_") + kept];
    EXPECT_GE(recall, last);
    EXPECT_LE(figures[std::string("box70_") + kept], recall);
    EXPECT_GE(figures[std::string("fixed50_") + kept], 0);
    last = recall;
  }
  EXPECT_GT(last, 0.6);
  EXPECT_FALSE(readJson("report/summary.json")["mps"]["object"]["ALL"].contains("box50_1"));
}

TEST_F(EvaluateTool, TheReportIsOneFileWithItsPictures) {
  if (std::system("/usr/bin/python3 -c 'import matplotlib' 2>/dev/null") != 0) {
    GTEST_SKIP() << "the pictures need python3-matplotlib";
  }
  ASSERT_EQ(evaluate("report", all()).exit_status, 0);
  EXPECT_FALSE(cv::imread(folder_ / "report/plots/precision_recall_mps.png").empty());
  const std::string html = readBytes(folder_ / "report/report.html");
  for (const char* text : {"easy", "F75", "peak_mib", "cluster_distance_m", "data:image/png;base64,",
                           "data:image/jpeg;base64,", "Milliseconds of each stage"}) {
    EXPECT_NE(html.find(text), std::string::npos) << text;
  }
  EXPECT_NE(html.find(readJson("report/run.json")["commit"]), std::string::npos);
  for (const char* link : {"http://", "https://", "href=", "src=\"/", "src=\"file", "<script", "@import", "url("}) {
    EXPECT_EQ(html.find(link), std::string::npos) << link;
  }
}

TEST_F(EvaluateTool, ShardsMergedAreTheWhole) {
  ASSERT_EQ(evaluate("whole", all()).exit_status, 0);
  for (const char* k : {"1", "2", "3"}) {
    const Outcome shard = evaluate(std::string("part") + k, std::string("--shard ") + k + "/3 " + all());
    ASSERT_EQ(shard.exit_status, 0) << shard.err;
  }
  const auto part = [&](const char* k) { return folder_ / (std::string("part") + k); };
  const std::string merge = "merge --report " + (folder_ / "merged") + " ";
  const Outcome merged = run(merge + part("2") + " " + part("1") + " " + part("3"));
  ASSERT_EQ(merged.exit_status, 0) << merged.err;
  EXPECT_EQ(withoutTimes(readJson("merged/summary.json")), withoutTimes(readJson("whole/summary.json")));
  EXPECT_EQ(readJson("merged/run.json"), readJson("whole/run.json"));
  EXPECT_TRUE(fs::exists(folder_ / "merged/results/mps/s3/overlay.png"));

  expectOneError(run(merge + part("1") + " " + part("3")), "shard 2/3 is missing");
  expectOneError(run(merge + part("1") + " " + part("1")), "is shard 1/3, as");
  expectOneError(run(merge + part("1") + " " + (folder_ / "whole")), "it is one of 1 shards, not of 3");
  expectOneError(run(merge + part("1") + " " + (folder_ / "none")), "none: holds no finished report");
  Json other = readJson("part2/run.json");
  other["commit"] = "0123456789";
  writeBytes(folder_ / "part2/run.json", other.dump());
  expectOneError(run(merge + part("1") + " " + part("2")), "it is of commit 0123456789, not ");
}

TEST_F(EvaluateTool, ResumesWithWhatIsMissing) {
  ASSERT_EQ(evaluate("report", all()).exit_status, 0);
  const Json first = readJson("report/summary.json");
  auto before = resultTimes("report");
  const Outcome again = evaluate("report", all());
  EXPECT_EQ(again.exit_status, 0);
  EXPECT_NE(again.err.find("4 of 4 results are there"), std::string::npos) << again.err;
  EXPECT_EQ(resultTimes("report"), before);
  EXPECT_EQ(readJson("report/summary.json"), first);  // the times, too

  fs::remove(folder_ / "report/results/mps/s2.json");
  writeBytes(folder_ / "report/results/mps/s3.json", "{");
  EXPECT_NE(evaluate("report", all()).err.find("2 of 4 results are there"), std::string::npos);
  EXPECT_EQ(withoutTimes(readJson("report/summary.json")), withoutTimes(first));
  EXPECT_EQ(resultTimes("report")[folder_ / "report/results/mps/s1.json"],
            before[folder_ / "report/results/mps/s1.json"]);
  EXPECT_EQ(evaluate("report", "--threads 1 " + all()).err.find("are there"), std::string::npos);  // other settings
}

TEST_F(EvaluateTool, BadScenesCostOnlyThemselves) {
  const std::string good = copyScene("s1", "good"), cut = copyScene("s1", "cut"), small = copyScene("s1", "small"),
                    wall = copyScene("s1", "wall"), bare = copyScene("s1", "bare"), flat = copyScene("s1", "flat");
  truncateFile(cut + "/depth.png", 0.5);
  cv::imwrite(small + "/labels.png", cv::Mat(10, 10, CV_16UC1, cv::Scalar(20)));
  cv::imwrite(wall + "/depth.png", cv::Mat(240, 320, CV_16UC1, cv::Scalar(0)));
  cv::imwrite(flat + "/labels.png", cv::Mat(240, 320, CV_8UC1, cv::Scalar(20)));
  fs::remove(bare + "/labels.png");
  std::string scenes;
  for (const auto& scene : {good, cut, small, wall, bare, flat, folder_ / "missing"}) scenes += " " + scene;
  const Outcome outcome = evaluate("report", scenes);
  EXPECT_EQ(outcome.exit_status, 1);
  for (const char* text :
       {"cut, mps: depth.png: is cut off", "(counts as nothing found)", "wall, mps: ", "bare: holds no labels.png",
        "small, mps: labels.png is 10 x 10, depth.png is 320 x 240", "(not counted)",
        "missing: there is no such folder",
        "flat, mps: labels.png: is 8-bit with 1 channel, must be 16-bit with 1 channel: a label a pixel"}) {
    EXPECT_NE(outcome.err.find(text), std::string::npos) << text << "\n" << outcome.err;
  }
  EXPECT_EQ(readJson("report/summary.json")["mps"]["object"]["ALL"]["scenes"], 3);
  EXPECT_EQ(readJson("report/results/mps/cut.json")["object"]["R"], 0);
  EXPECT_GT(readJson("report/results/mps/good.json")["object"]["R"], 0);
  EXPECT_FALSE(readJson("report/summary.json")["mps"]["object"].contains("all"));
}

TEST_F(EvaluateTool, ParametersAndModelAreThoseGiven) {
  writeBytes(folder_ / "leaf.json", objectness::toJson(leafModel(0, 0, 0.25f)));
  const auto recall = [&](const std::string& options) {
    const Outcome outcome = run("--method objectness --report " + (folder_ / "report") + " " + options + all() + "/s1");
    EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
    EXPECT_EQ(outcome.err.find("are there"), std::string::npos) << "taken for a result of other settings";
    return readJson("report/summary.json")["objectness"]["object"]["ALL"]["R"].get<double>();
  };
  EXPECT_GT(recall(""), 0.9);
  const std::string model = "--model " + (folder_ / "leaf.json") + " ";
  EXPECT_EQ(recall(model + "--set grouping.standing=false "), 0) << "every group is rather left out";
  EXPECT_GT(recall(model), 0.3) << "but what surely stands on the table";
  EXPECT_GT(recall(model + "--set grouping.standing=false grouping.least_objectness=0.1 runtime.seed=2 "), 0.3);
  EXPECT_EQ(recall("--set object_points.max_height_m=0.03 "), 0);
}

TEST_F(EvaluateTool, GapsOfTheChoiceAreReportedWhereThereIsOne) {
  const std::string scene = all() + "/s1 --report " + (folder_ / "report") + " ";
  const Outcome outcome = run("--method objectness --method mps --set grouping.compare_annealing=true " + scene);
  ASSERT_EQ(outcome.exit_status, 0) << outcome.err;
  const Json summary = readJson("report/summary.json");
  for (const char* gap : {"selection_gap", "selection_gap_max", "annealing_gap", "annealing_gap_max"}) {
    EXPECT_EQ(summary["objectness"]["object"]["ALL"].value(gap, -1.0), 0)
        << "three things apart are no riddle: " << gap;
    EXPECT_FALSE(summary["mps"]["object"]["ALL"].contains(gap));
  }
  EXPECT_NE(outcome.out.find("annealing_gap_max 0.00000"), std::string::npos) << outcome.out;

  ASSERT_EQ(run("--method objectness --set grouping.exact_nodes=0 grouping.iterations=0 " + scene).exit_status, 0);
  const Json unproven = readJson("report/summary.json")["objectness"]["object"]["ALL"];
  EXPECT_GE(unproven["selection_gap"], 0);
  EXPECT_FALSE(unproven.contains("annealing_gap"));
}

TEST_F(EvaluateTool, TheAblationPrintsARowForEachPartSwitchedOff) {
  const std::string command = REPOSITORY_DIR "/scripts/ablation --build " TOOL_DIR "/../../.. --only 'single pieces' " +
                              ("--report " + (folder_ / "ablation")) + " " + all() + "/s1 >" + (folder_ / "table");
  ASSERT_EQ(std::system(command.c_str()), 0);
  const std::string table = readBytes(folder_ / "table");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 4) << table;
  const auto recall = [&](const std::string& row) {
    const Json summary = readJson("ablation/" + row + "/summary.json");
    return summary["objectness"]["object"]["ALL"]["R"].get<double>();
  };
  EXPECT_GT(recall("nothing"), recall("groups_single_pieces") + 0.1) << "boxes show more than one face";
  char cell[32];
  std::snprintf(cell, sizeof cell, " %.3f |", recall("groups_single_pieces"));
  EXPECT_NE(table.find("| groups | single pieces |"), std::string::npos) << table;
  EXPECT_NE(table.find(cell, table.find("single pieces")), std::string::npos) << table;
}

TEST_F(EvaluateTool, ReportThatCannotBeWrittenAndNoScenes) {
  writeBytes(folder_ / "file", "x");
  expectOneError(evaluate("file", all()), "cannot write there: ");
  expectOneError(run("--report /proc/nowhere " + all()), "--report /proc/nowhere: cannot write there");
  expectOneError(evaluate("report", ""), "no scenes to evaluate");
  fs::create_directories(folder_ / "empty");
  expectOneError(evaluate("report", folder_ / "empty"), "neither is a scene folder nor holds any");
  expectOneError(evaluate("report", "--groups none.csv " + all()), "none.csv: there is no such file");
}

TEST_F(EvaluateTool, WithoutPythonTheTablesAreThere) {
  // The program in a folder without the script.
  fs::copy(std::string(TOOL_DIR) + "/evaluate", folder_ / "evaluate");
  const std::string command =
      "cd " + folder_.path() + " && ./evaluate --method mps --report report " + all() + "/s1 >stdout 2>stderr";
  EXPECT_EQ(std::system(command.c_str()), 0) << readBytes(folder_ / "stderr");
  EXPECT_NE(readBytes(folder_ / "stderr").find("warning: no plots and no report.html"), std::string::npos);
  EXPECT_TRUE(fs::exists(folder_ / "report/summary.json"));
  EXPECT_FALSE(fs::exists(folder_ / "report/report.html"));
}

TEST_F(EvaluateTool, WrongCommandLines) {
  const auto expectUsageError = [&](const std::string& arguments, const std::string& text) {
    ToolTest::expectUsageError("evaluate", arguments, text);
  };
  expectUsageError("scenes", "no --report DIR given");
  expectUsageError("--report r --method graph scenes", "there is no method 'graph', only objectness, paper, boxes");
  expectUsageError("--report r --level pixel scenes", "--level pixel: must be object or part");
  expectUsageError("--report r --jobs 0 scenes", "--jobs 0: must be within 1 and");
  expectUsageError("--report r --threads many scenes", "threads");
  for (const char* shard : {"0/3", "4/3", "1", "1/3x", "a/b"}) {
    expectUsageError(std::string("--report r scenes --shard ") + shard, "must be K/N with 1 <= K <= N");
  }
  expectUsageError("--report r --set grouping.learnd=1 scenes", "there is no parameter grouping.learnd");
  expectUsageError("--report r --model none.json scenes", "--model none.json: there is no such file");
  expectUsageError("merge --report r", "no SHARD_DIR given");
  expectUsageError("merge --report r --model m.json a b", "--model: merge takes it from the shards");
  expectUsageError("merge --report r --jobs 2 a b", "--jobs: merge takes it from the shards");
  EXPECT_EQ(run("--help").exit_status, 0);
}
