// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "fixtures/leaf_model.hpp"
#include "fixtures/tool_test.hpp"

using namespace objectness_test;

namespace {

const std::string kTools = TOOL_DIR;

class SegmentTool : public ToolTest {
 protected:
  Outcome run(const std::string& arguments) const { return ToolTest::run("segment", arguments); }
  void expectUsageError(const std::string& arguments, const std::string& text) const {
    ToolTest::expectUsageError("segment", arguments, text);
  }
  std::string makeScene(const std::string& name) const {
    EXPECT_EQ(ToolTest::run("make_scene", "--demo --out " + (folder_ / name)).exit_status, 0);
    return folder_ / name;
  }
  /// The coarse angles make it quick.
  std::string common() const {
    return " --method paper --set search.angle_step_deg=45 --out " + (folder_ / "out") + " ";
  }
};

}  // namespace

TEST_F(SegmentTool, WritesTheResults) {
  const std::string scene = makeScene("kitchen");
  const Outcome outcome = run(common() + "--pictures --threads 2 --seed 3 " + scene + "/");
  ASSERT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.out.compare(0, 9, "kitchen: "), 0) << outcome.out;
  const auto json = nlohmann::json::parse(readBytes(folder_ / "out/kitchen/objects.json"));
  EXPECT_EQ(json["input"], scene + "/");
  EXPECT_EQ(json["status"], "ok");
  EXPECT_GE(json["objects"].size(), 3u);
  for (const char* count : {"boxes_sampled", "boxes_scored"}) EXPECT_GT(json["report"][count], 0) << count;
  EXPECT_GT(json["report"]["timings_ms"]["total"], 0);
  const cv::Mat labels = cv::imread(folder_ / "out/kitchen/labels.png", cv::IMREAD_UNCHANGED);
  ASSERT_EQ(labels.type(), CV_16UC1);
  double highest = 0;
  cv::minMaxLoc(labels, nullptr, &highest);
  EXPECT_EQ(highest, json["objects"].size() + 1.0);
  for (const auto& object : json["objects"])
    EXPECT_EQ(cv::countNonZero(labels == int(object["label"])), object["points"]);
  EXPECT_EQ(cv::imread(folder_ / "out/kitchen/overlay.png").size(), labels.size());
}

TEST_F(SegmentTool, BadInputsGetOneLineEachAndTheOthersAreDone) {
  const std::string good = makeScene("good"), cut = makeScene("cut"), text = makeScene("text");
  truncateFile(cut + "/depth.png", 0.5);
  writeBytes(text + "/depth.png", "no picture");
  writeBytes(text + "/camera.yaml", "image_width: [");
  std::filesystem::create_directory(folder_ / "empty");
  writeBytes(folder_ / "broken.pcd", "VERSION 0.7\nFIELDS x y z\n");
  writeBytes(folder_ / "out/cut/objects.json", "of an earlier run");
  const Outcome outcome = run(common() + cut + " " + text + " " + (folder_ / "empty") + " " + (folder_ / "missing") +
                              " " + (folder_ / "broken.pcd") + " / " + good + " " + (folder_ / "out/../good"));
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_EQ(outcome.errorLines(), 7) << outcome.err;
  for (const std::string& line : std::vector<std::string>{
           cut + ": depth.png: is cut off", text + ": depth.png: is not a PNG", "empty: holds no depth.png",
           "missing: there is no such file or folder", "broken.pcd: is cut off within its header", "/: has no name",
           "out/../good: its results would overwrite those of " + good}) {
    EXPECT_NE(outcome.err.find(line), std::string::npos) << line << "\n" << outcome.err;
  }
  EXPECT_EQ(outcome.out.compare(0, 6, "good: "), 0) << outcome.out;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/good/objects.json"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/cut/objects.json"));
}

TEST_F(SegmentTool, NothingOnTheTableIsAResult) {
  const std::string scene = makeScene("bare");
  cv::imwrite(scene + "/depth.png", cv::Mat(480, 640, CV_16UC1, cv::Scalar(1000)));
  const Outcome outcome = run(common() + scene);
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_EQ(outcome.out.compare(0, 15, "bare: 0 objects"), 0) << outcome.out;
}

TEST_F(SegmentTool, DepthOfAnotherUnitIsRightWithItsScaleAndARemarkWithout) {
  const std::string scene = makeScene("fifths"), depth = scene + "/depth.png";
  const std::string out = "--out " + (folder_ / "out") + " ";
  ASSERT_EQ(run(out + scene).exit_status, 0);
  const auto result = [&] { return nlohmann::json::parse(readBytes(folder_ / "out/fifths/objects.json")); };
  const auto labels = [&] { return readBytes(folder_ / "out/fifths/labels.png"); };
  const std::string true_labels = labels();
  EXPECT_TRUE(result()["remarks"].empty());
  const auto objects = result()["objects"].size();

  cv::imwrite(depth, cv::imread(depth, cv::IMREAD_UNCHANGED) * 5);
  for (const char* scale : {"5000", "0.0002"}) {
    const Outcome outcome = run(out + "--depth-scale " + scale + " " + scene);
    EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(result()["objects"].size(), objects);
    // Every depth is the same but for the rounding of its float.
    const cv::Mat a = cv::imdecode(std::vector<char>(true_labels.begin(), true_labels.end()), cv::IMREAD_UNCHANGED);
    const std::string found = labels();
    const cv::Mat b = cv::imdecode(std::vector<char>(found.begin(), found.end()), cv::IMREAD_UNCHANGED);
    EXPECT_LT(cv::countNonZero(a != b), 0.01 * cv::countNonZero(a)) << scale;
  }
  const Outcome without = run(out + scene);
  EXPECT_NE(without.err.find("--depth-scale"), std::string::npos) << without.err;
  writeBytes(scene + "/camera.yaml", readBytes(scene + "/camera.yaml") + "depth_scale: 5000\n");
  const Outcome by_file = run(out + scene);
  EXPECT_EQ(by_file.err, "");
  EXPECT_EQ(result()["objects"].size(), objects);
}

TEST_F(SegmentTool, ColourOfAnotherSizeIsARemark) {
  const std::string scene = makeScene("odd");
  cv::imwrite(scene + "/color.png", cv::Mat(20, 30, CV_8UC3));
  const Outcome outcome = run(common() + scene);
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_EQ(outcome.errorLines(), 1) << outcome.err;
  EXPECT_NE(outcome.err.find(scene + ": color.png is 30 x 20, depth.png 640 x 480"), std::string::npos) << outcome.err;
}

TEST_F(SegmentTool, TheMethodIsChosenByNameOrPreset) {
  const std::string scene = makeScene("kitchen"), out = "--out " + (folder_ / "out") + " ";
  const std::string quick = " --set search.angle_step_deg=45 ", preset = REPOSITORY_DIR "/cfg/paper.yaml";
  const struct {
    std::string options;
    bool paper;
  } cases[] = {{"", false},
               {"--method objectness", false},
               {"--method paper", true},
               {"--config " + preset, true},
               {"--config " + preset + " --method objectness", false}};
  for (const auto& c : cases) {
    const Outcome outcome = run(out + c.options + quick + scene);
    ASSERT_EQ(outcome.exit_status, 0) << outcome.err;
    const auto counts = nlohmann::json::parse(readBytes(folder_ / "out/kitchen/objects.json"))["report"];
    EXPECT_EQ(counts.contains("boxes_sampled"), c.paper) << c.options;
    EXPECT_EQ(counts.contains("pieces"), !c.paper) << c.options;
  }
}

TEST_F(SegmentTool, AModelOfOnesOwnTakesThePlaceOfTheBuiltInOne) {
  const std::string scene = makeScene("kitchen"), out = "--out " + (folder_ / "out") + " ";
  const auto objects = [&](const std::string& options) {
    const Outcome outcome = run(out + options + scene);
    EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
    return nlohmann::json::parse(readBytes(folder_ / "out/kitchen/objects.json"))["objects"];
  };
  const auto built_in = objects("");
  EXPECT_EQ(objects("--model " REPOSITORY_DIR "/cfg/objectness_model.json "), built_in);
  writeBytes(folder_ / "leaf.json", objectness::toJson(leafModel(0, 0, 0.75f)));
  const auto other = objects("--model " + (folder_ / "leaf.json") + " ");
  EXPECT_GE(other.size(), built_in.size()) << "no two pieces are joined";
  for (const auto& object : other) EXPECT_EQ(object["objectness"], 0.75);
}

TEST_F(SegmentTool, BadModelsAreNamed) {
  const auto expectRefused = [&](const std::string& model, const std::string& reason) {
    expectUsageError("--out o --model " + model + " scene", "--model " + model + ": " + reason);
  };
  expectRefused(folder_ / "none.json", "there is no such file");
  writeBytes(folder_ / "text.json", "no model");
  expectRefused(folder_ / "text.json", "is not a model: not a JSON object");
  auto foreign = nlohmann::json::parse(objectness::toJson(leafModel(0, 0, 0)));
  foreign["gap"]["cues"].push_back("smell");
  writeBytes(folder_ / "foreign.json", foreign.dump());
  expectRefused(folder_ / "foreign.json", "\"gap\" is made for the cues");
}

TEST_F(SegmentTool, WrongCommandLines) {
  expectUsageError("", "no INPUT given");
  expectUsageError("scene", "no --out DIR given");
  expectUsageError("--out o --pict scene", "unrecognised option '--pict'");
  expectUsageError("--out o --method graph scene", "there are only the methods 'objectness', 'paper' and 'boxes'");
  expectUsageError("--out o --threads many scene", "runtime.threads is 'many', must be a whole number");
  expectUsageError("--out o --seed -1 scene", "seed");
  expectUsageError("--out o --set serach.angle_step_deg=3 scene", "did you mean search.angle_step_deg?");
  expectUsageError("--out o --set search.angle_step_deg=0 scene", "must be within 1 and 90");
  expectUsageError("--out o --config none.yaml scene", "--config none.yaml: there is no such file");
  expectUsageError("--out o --depth-scale mm scene", "--depth-scale is 'mm', must be the units of a metre");
  expectUsageError("--out o --camera none.yaml scene", "--camera none.yaml: there is no such file");
  expectUsageError("--out o --out p scene", "out");
}

TEST_F(SegmentTool, OutputThatCannotBeWritten) {
  writeBytes(folder_ / "file", "x");
  for (const std::string& out : {folder_ / "file", folder_ / "file/below", std::string("/proc/nowhere")}) {
    const Outcome outcome = run("--out " + out + " scene");
    EXPECT_EQ(outcome.exit_status, 1);
    EXPECT_EQ(outcome.errorLines(), 1) << outcome.err;
    EXPECT_NE(outcome.err.find("--out " + out + ": cannot write there"), std::string::npos) << outcome.err;
  }
}

TEST_F(SegmentTool, PrintsHelpParametersAndConfiguration) {
  const Outcome help = run("--help");
  EXPECT_EQ(help.exit_status, 0);
  for (const char* text : {"--pictures", "--camera", "Examples:", "Exit status"})
    EXPECT_NE(help.out.find(text), std::string::npos);
  EXPECT_NE(run("--list-parameters").out.find("filter.threshold\tdouble\t"), std::string::npos);
  const std::string preset = REPOSITORY_DIR "/cfg/plain_boxes.yaml";
  const Outcome config = run("--print-config --config " + preset + " --set runtime.seed=5 runtime.threads=3");
  EXPECT_EQ(config.exit_status, 0) << config.err;
  for (const char* text : {"method: boxes", "seed: 5", "threads: 3"}) {
    EXPECT_NE(config.out.find(text), std::string::npos) << text << "\n" << config.out;
  }
}

TEST_F(SegmentTool, TheDepthScaleIsAParameter) {
  const Outcome config = run("--print-config --depth-scale 5000");
  EXPECT_NE(config.out.find("depth_unit_m: 0.0002"), std::string::npos) << config.out;
}

TEST_F(SegmentTool, LinksNoRos) {
  ASSERT_EQ(std::system(("ldd " + kTools + "/segment >" + (folder_ / "ldd")).c_str()), 0);
  const std::string libraries = readBytes(folder_ / "ldd");
  EXPECT_NE(libraries.find("libopencv_core"), std::string::npos);
  for (const char* ros : {"libroscpp", "librostime", "libnodelet"})
    EXPECT_EQ(libraries.find(ros), std::string::npos) << ros;
}

TEST(Parameters, TheFilesWrittenFromTheFieldListsAreFresh) {
  const std::string check = "/usr/bin/python3 " REPOSITORY_DIR "/scripts/update_parameters --check " TOOL_DIR;
  EXPECT_EQ(std::system(check.c_str()), 0) << "run scripts/update_parameters";
}

/// Where a processor has no AVX2, and on other kinds of processors.
TEST_F(SegmentTool, PortableKernelsGiveTheSameResult) {
  const std::string scene = makeScene("kitchen");
  const auto resultOf = [&](const std::string& tool, const std::string& method) {
    const std::string out = folder_ / (tool + "_" + method);
    const Outcome outcome = ToolTest::run(tool, "--method " + method + " --out " + out + " " + scene);
    EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
    auto json = nlohmann::json::parse(readBytes(out + "/kitchen/objects.json"));
    json["report"].erase("timings_ms");
    EXPECT_GE(json["objects"].size(), 3u);
    return std::make_pair(json.dump(1), readBytes(out + "/kitchen/labels.png"));
  };
  for (const std::string method : {"objectness", "paper"}) {
    const auto usual = resultOf("segment", method), portable = resultOf("segment_portable", method);
    EXPECT_EQ(portable.first, usual.first) << method;
    EXPECT_TRUE(portable.second == usual.second) << method << ": other pixels";
  }
  // The comparison is one of kernels only as long as the library calls those of the tool.
  const std::string tool = kTools + "/segment_portable";
  const Outcome run = runCommand("env LD_DEBUG=bindings " + tool + common() + scene);
  ASSERT_EQ(run.exit_status, 0);
  std::istringstream bindings(run.err);
  int own = 0;
  for (std::string line; std::getline(bindings, line);) {
    const auto from = line.find("_core.so"), to = line.find("] to " + tool);
    own += from < to && to != std::string::npos && line.find("neededStraddling") != std::string::npos;
  }
  EXPECT_GT(own, 0) << "the library uses its own kernels";
}
