// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "fixtures/labelled_scene.hpp"
#include "fixtures/tool_test.hpp"

using namespace objectness_test;
using Json = nlohmann::json;

namespace {

/// Runs of one benchmark as Google Benchmark reports them.
void addRuns(const std::string& name, const std::vector<double>& ms, const Json& counters, Json& benchmarks) {
  for (const double time : ms) {
    Json run{{"name", name + "/iterations:1"}, {"run_type", "iteration"}, {"real_time", time}, {"cpu_time", time}};
    run.update(counters);
    benchmarks.push_back(run);
  }
}

class BenchmarkTest : public ToolTest {
 protected:
  Outcome runReport() const {
    return runCommand("/usr/bin/python3 " REPOSITORY_DIR "/benchmark/benchmark_report.py " + folder_.path());
  }
};

class BenchmarkReport : public BenchmarkTest {
 protected:
  BenchmarkReport() {
    addRuns("search/plain/wide/two", {1000}, {{"boxes", 5e8}}, benchmarks_);
    addRuns("search/scan/wide/two", {100, 120, 90}, {{"boxes", 5e8}}, benchmarks_);
    addRuns("search/bounded/wide/two", {4, 5, 9}, {{"boxes", 5e8}, {"passed", 7}}, benchmarks_);
    addRuns("frame/objectness/none/two", {40, 20, 30}, {{"stage:10:normals", 2.5}, {"peak_mib", 301}}, benchmarks_);
    addRuns("frame/paper/tight/two", {34, 34}, {{"stage:10:normals", 3.5}, {"peak_mib", 99}}, benchmarks_);
  }

  /// Writes what was measured and makes the report of it.
  Outcome report() const {
    const Json scene{{"name", "two"}, {"group", "all"}, {"objects", 2}, {"width", 640}, {"height", 480}};
    const Json run{{"machine", "an abacus"}, {"compiler", "none"},
                   {"commit", "abc"},        {"threads", 2},
                   {"load_before", 0.5},     {"repetitions", {{"frames", 3}, {"scan", 3}, {"plain", 1}}},
                   {"scenes", {scene}}};
    writeBytes(folder_ / "run.json", run.dump());
    writeBytes(folder_ / "benchmark.json", Json{{"benchmarks", benchmarks_}}.dump());
    return runReport();
  }
  Json figure(const std::string& name) const {
    const Json summary = Json::parse(readBytes(folder_ / "summary.json"));
    for (const Json& figure : summary["figures"]["recorded"]) {
      if (figure["name"] == name) return figure;
    }
    return {};
  }

  Json benchmarks_ = Json::array();
};

TEST_F(BenchmarkReport, TakesMediansAndComparesThemToTheTargets) {
  const Outcome outcome = report();
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  const Json against_loop = figure("exact search, wide, against the nested loop, CPU time");
  EXPECT_DOUBLE_EQ(against_loop["median"], 1.0 / 200);
  EXPECT_EQ(against_loop["reached"], true);
  EXPECT_DOUBLE_EQ(figure("the same against the vectorized scan")["median"], 1.0 / 20);
  EXPECT_EQ(figure("frame, `objectness`, 2 to 3 objects")["median"], 30);
  EXPECT_EQ(figure("frame, `objectness`, 2 to 3 objects")["reached"], true);
  EXPECT_EQ(figure("frame, `paper`, 2 to 3 objects")["reached"], false);
  EXPECT_EQ(figure("peak memory, `objectness`")["reached"], false);
  EXPECT_EQ(figure("peak memory, `paper`")["reached"], true);
  EXPECT_EQ(figure("frame, `objectness`, 14 to 20 objects")["scenes"], 0);
  EXPECT_NE(outcome.out.find("| 1/200 |"), std::string::npos) << outcome.out;

  const std::string text = readBytes(folder_ / "report.md");
  for (const char* const part : {"an abacus", "30.0 (20.0 to 40.0)", "| normals | 2.50 |", "1/200", "100.00", "301"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part;
  }
  EXPECT_NE(readBytes(folder_ / "plots/all_scenes.svg").find("</svg>"), std::string::npos);
}

TEST_F(BenchmarkReport, NamesWhatFailed) {
  Json failed{{"name", "search/bounded/tight/two/iterations:1"}, {"run_type", "iteration"}, {"error_occurred", true}};
  failed["error_message"] = "does not find the same boxes";
  benchmarks_.push_back(failed);
  const Outcome outcome = report();
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_NE(outcome.err.find("search/bounded/tight/two failed: does not find the same boxes"), std::string::npos)
      << outcome.err;
}

TEST_F(BenchmarkReport, SaysWhatIsMissing) {
  const Outcome outcome = runReport();
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_EQ(outcome.errorLines(), 1) << outcome.err;
  EXPECT_NE(outcome.err.find("run.json"), std::string::npos) << outcome.err;
}

#ifdef WITH_BENCHMARK
class BenchmarkTool : public BenchmarkTest {};

TEST_F(BenchmarkTool, MeasuresASmallScene) {
  saveLabelledScene(folder_ / "small", 0.05);
  const Outcome outcome = run("benchmark_objectness", "--quick '--benchmark_filter=/(none|tight)/' --out " +
                                                          folder_.path() + " " + (folder_ / "small"));
  ASSERT_EQ(outcome.exit_status, 0) << outcome.err;
  std::set<std::string> names;
  const Json report = Json::parse(readBytes(folder_ / "benchmark.json"));
  for (const Json& run : report["benchmarks"]) {
    EXPECT_FALSE(run.value("error_occurred", false)) << run;
    const std::string name = run["name"];
    names.insert(name.substr(0, name.find("/small")));
  }
  for (const char* const name : {"frame/objectness/none", "frame/paper/tight", "search/bounded/tight",
                                 "volumes/all/tight", "angles/all/tight"}) {
    EXPECT_TRUE(names.count(name)) << name;
  }
  EXPECT_EQ(runReport().exit_status, 0);
}

TEST_F(BenchmarkTool, RefusesWhatItCannotUse) {
  expectUsageError("benchmark_objectness", "scene", "--out DIR is needed");
  expectUsageError("benchmark_objectness", "--out .", "no scenes");
  expectUsageError("benchmark_objectness", "--out . --repetitions 0 scene", "above 0");
  const Outcome outcome = run("benchmark_objectness", "--out " + folder_.path() + " " + (folder_ / "nowhere"));
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_NE(outcome.err.find("no such folder"), std::string::npos) << outcome.err;
}
#endif

}  // namespace
