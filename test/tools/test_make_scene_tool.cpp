// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <opencv2/imgcodecs.hpp>
#include <set>

#include "fixtures/tool_test.hpp"
#include "objectness_segmentation/io/camera_yaml.hpp"

using namespace objectness_test;

namespace {

class MakeSceneTool : public ToolTest {
 protected:
  Outcome make(const std::string& arguments) const { return run("make_scene", arguments); }
  std::string file(const std::string& name) const { return folder_ / name; }
  bool exists(const std::string& name) const { return std::filesystem::exists(file(name)); }
  cv::Mat image(const std::string& name) const { return cv::imread(file(name), cv::IMREAD_UNCHANGED); }
};

}  // namespace

TEST_F(MakeSceneTool, WritesTheDemoScene) {
  const Outcome outcome = make("--demo --out " + file("demo"));
  ASSERT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("demo, 6 objects"), std::string::npos) << outcome.out;
  for (const char* name : {"depth.png", "color.png", "labels.png", "camera.yaml", "objects.yaml", "pose.yaml"}) {
    EXPECT_TRUE(exists(std::string("demo/") + name)) << name;
  }
  EXPECT_EQ(YAML::LoadFile(file("demo/objects.yaml"))["objects"].size(), 6u);
  ASSERT_EQ(make("--demo --out " + file("again")).exit_status, 0);
  for (const char* name : {"/depth.png", "/color.png", "/labels.png", "/objects.yaml"}) {
    EXPECT_EQ(readBytes(file("demo") + name), readBytes(file("again") + name)) << name;
  }
}

TEST_F(MakeSceneTool, WritesScenesOfALevelAndOfAll) {
  ASSERT_EQ(make("--level all --count 1 --size 160x120 --objects 3 --out " + file("all")).exit_status, 0);
  EXPECT_EQ(readBytes(file("all/groups.csv")),
            "scene,group\nboxes_0000,boxes\nshapes_0000,shapes\noccluded_0000,occluded\ntouching_0000,touching\n"
            "stacked_0000,stacked\nleaning_0000,leaning\nclutter_0000,clutter\n");
  ASSERT_EQ(make("--level stacked --count 2 --size 160x120 --objects 3 --out " + file("two")).exit_status, 0);
  EXPECT_EQ(readBytes(file("two/groups.csv")), "scene,group\nstacked_0000,stacked\nstacked_0001,stacked\n");
  EXPECT_EQ(readBytes(file("two/stacked_0000/depth.png")), readBytes(file("all/stacked_0000/depth.png")))
      << "a scene depends on its level, seed and number alone";
  ASSERT_EQ(make("--level stacked --size 160x120 --objects 3 --out " + file("one")).exit_status, 0);
  EXPECT_EQ(readBytes(file("one/depth.png")), readBytes(file("two/stacked_0000/depth.png")));
  ASSERT_EQ(make("--level stacked --size 160x120 --objects 3 --seed 2 --out " + file("other")).exit_status, 0);
  EXPECT_NE(readBytes(file("one/depth.png")), readBytes(file("other/depth.png")));
}

TEST_F(MakeSceneTool, WritesEverydayScenesWithTheirBackground) {
  ASSERT_EQ(make("--level everyday --count 1 --size 160x120 --around arm,rack --out " + file("all")).exit_status, 0);
  EXPECT_EQ(readBytes(file("all/groups.csv")),
            "scene,group\nplates_0000,plates\ntray_0000,tray\ntote_0000,tote\nshelf_0000,shelf\n"
            "stacks_0000,stacks\ncontents_0000,contents\n");
  const YAML::Node background = YAML::LoadFile(file("all/tray_0000/objects.yaml"))["background"];
  ASSERT_EQ(background.size(), 3u);
  const char* kinds[] = {"tray", "arm", "rack"};
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(background[i]["kind"].as<std::string>(), kinds[i]);
    EXPECT_EQ(background[i]["label"].as<int>(), i == 0 ? 2 : 3);
  }
  EXPECT_GT(cv::countNonZero(image("all/tray_0000/labels.png") == 2), 100) << "the tray";
}

TEST_F(MakeSceneTool, TakesTheLensOfACamera) {
  ASSERT_EQ(make("--level tray --lens realsense_hd --ideal --out " + file("a")).exit_status, 0);
  EXPECT_EQ(objectness::loadCamera(file("a/camera.yaml")).value.fx, 920);
  EXPECT_EQ(image("a/depth.png").size(), cv::Size(1280, 720));
  ASSERT_EQ(make("--level tray --lens realsense_hd --size 320x180 --out " + file("b")).exit_status, 0);
  EXPECT_NEAR(objectness::loadCamera(file("b/camera.yaml")).value.fx, 230, 1e-6);
}

TEST_F(MakeSceneTool, TakesTheKindOfSensor) {
  std::set<std::string> depths;
  for (const char* kind : {"structured", "stereo", "tof"}) {
    const std::string out = file(kind);
    ASSERT_EQ(make("--demo --size 160x120 --sensor " + std::string(kind) + " --out " + out).exit_status, 0);
    depths.insert(readBytes(out + "/depth.png"));
  }
  EXPECT_EQ(depths.size(), 3u);
}

TEST_F(MakeSceneTool, WritesASequence) {
  ASSERT_EQ(make("--level shapes --frames 3 --size 160x120 --out " + file("s")).exit_status, 0);
  std::set<std::string> poses;
  for (const char* frame : {"s/frame_0000", "s/frame_0001", "s/frame_0002"}) {
    poses.insert(readBytes(file(frame) + "/pose.yaml"));
    EXPECT_EQ(image(frame + std::string("/depth.png")).size(), cv::Size(160, 120));
  }
  EXPECT_EQ(poses.size(), 3u);
  EXPECT_FALSE(exists("s/frame_0003"));
}

TEST_F(MakeSceneTool, WritesFramesOfOneView) {
  ASSERT_EQ(make("--level shapes --frames 3 --still --size 160x120 --out " + file("s")).exit_status, 0);
  std::set<std::string> poses, depths;
  for (const char* frame : {"s/frame_0000", "s/frame_0001", "s/frame_0002"}) {
    poses.insert(readBytes(file(frame) + "/pose.yaml"));
    depths.insert(readBytes(file(frame) + "/depth.png"));
  }
  EXPECT_EQ(poses.size(), 1u);
  EXPECT_EQ(depths.size(), 3u) << "each with noise of its own";
  cv::Mat difference;
  cv::absdiff(image("s/frame_0000/depth.png"), image("s/frame_0001/depth.png"), difference);
  EXPECT_LT(cv::countNonZero(difference > 30), 0.05 * 160 * 120);
}

TEST_F(MakeSceneTool, TakesAnotherCamera) {
  ASSERT_TRUE(objectness::saveCamera(file("camera.yaml"), {610, 608, 325, 242, 640, 480}).ok());
  ASSERT_EQ(make("--level boxes --camera " + file("camera.yaml") + " --ideal --out " + file("a")).exit_status, 0);
  const auto same = objectness::loadCamera(file("a/camera.yaml"));
  EXPECT_EQ(same.value.fx, 610);
  EXPECT_EQ(cv::countNonZero(image("a/depth.png") == 0), 0) << "the room is closed, the ideal camera sees all of it";
  ASSERT_EQ(make("--demo --camera " + file("camera.yaml") + " --size 320x200 --out " + file("b")).exit_status, 0);
  const auto half = objectness::loadCamera(file("b/camera.yaml"));
  EXPECT_NEAR(half.value.fy, 304, 1e-6);
  EXPECT_NEAR(half.value.cx, 162.25, 1e-6);
  EXPECT_NEAR(half.value.cy, 100 - 0.5 + (242.5 - 240) / 2, 1e-6) << "cut at top and bottom alike";
  EXPECT_EQ(image("b/depth.png").size(), cv::Size(320, 200));
}

TEST_F(MakeSceneTool, PrintsHelpAndLevels) {
  const Outcome help = make("--help");
  EXPECT_EQ(help.exit_status, 0);
  for (const char* text : {"--level", "--table", "Examples:", "Exit status"})
    EXPECT_NE(help.out.find(text), std::string::npos) << text;
  const Outcome list = make("--list");
  EXPECT_EQ(list.exit_status, 0);
  EXPECT_EQ(std::count(list.out.begin(), list.out.end(), '\n'), 13);
  EXPECT_LT(list.out.find("boxes\t"), list.out.find("clutter\t")) << "from easy to hard";
  EXPECT_LT(list.out.find("clutter\t"), list.out.find("plates\t")) << "everyday ones last";
  EXPECT_NE(list.out.find("from above, seen from 65 to 90 deg down\n"), std::string::npos) << list.out;
}

TEST_F(MakeSceneTool, WrongCommandLines) {
  for (const auto& [arguments, text] : std::vector<std::pair<std::string, std::string>>{
           {"--out o", "give either --demo or --level"},
           {"--demo --level boxes --out o", "give either --demo or --level"},
           {"--demo", "neither --out DIR nor --bag FILE given"},
           {"--level chaos --out o", "--level chaos: must be all, boxes, shapes"},
           {"--level all --out o", "--level all needs --count"},
           {"--level boxes --count 2 --frames 2 --out o", "exclude each other"},
           {"--level boxes --still --out o", "--still needs --frames"},
           {"--level boxes --objects 41 --out o", "--objects 41: must be 0 to 40"},
           {"--level boxes --count 0 --out o", "--count 0: must be 1 to"},
           {"--level boxes --seed -1 --out o", "--seed -1: must be 0 to"},
           {"--level boxes --seed many --out o", "seed"},
           {"--level boxes --size 640 --out o", "--size 640: must be WIDTHxHEIGHT"},
           {"--level boxes --table 1x1 --out o", "--table: '1x1' is no table"},
           {"--level boxes --around leg --out o", "--around: 'leg' is not arm, wall, rack or table"},
           {"--level boxes --sensor sonar --out o", "--sensor sonar: must be structured, stereo or tof"},
           {"--level boxes --lens fisheye --out o", "--lens fisheye: must be xtion_qvga, kinect"},
           {"--level boxes --lens kinect --camera c.yaml --out o", "--camera and --lens exclude each other"},
           {"--level everyday --out o", "--level everyday needs --count"},
           {"--level boxes --table-share 2 --out o", "--table-share must be"},
           {"--level boxes --camera none.yaml --out o", "--camera none.yaml: there is no such file"},
           {"--demo --objects 3 --out o", "the demo scene has its own"},
           {"--demo --pict --out o", "unrecognised option '--pict'"}}) {
    expectUsageError("make_scene", arguments, text);
  }
}

TEST_F(MakeSceneTool, SaysWhatCannotBeMadeOrWritten) {
  const Outcome crowded = make("--level boxes --objects 20 --table 0.4x0.4x0.7 --count 1 --out " + file("crowded"));
  EXPECT_EQ(crowded.exit_status, 1);
  EXPECT_EQ(crowded.errorLines(), 1) << crowded.err;
  EXPECT_NE(crowded.err.find("boxes_0000: found no room for 20 objects"), std::string::npos) << crowded.err;
  for (const char* options : {"--demo", "--level boxes", "--level boxes --frames 2", "--level all --count 3"}) {
    const Outcome outcome = make(options + std::string(" --size 64x48 --out /proc/nowhere"));
    EXPECT_EQ(outcome.exit_status, 1) << options;
    EXPECT_EQ(outcome.errorLines(), 1) << outcome.err;
    EXPECT_NE(outcome.err.find("/proc/nowhere"), std::string::npos) << outcome.err;
  }
}
