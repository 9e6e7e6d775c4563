// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include "fixtures/temporary_folder.hpp"
#include "objectness_segmentation/config_fields.hpp"
#include "objectness_segmentation/io/config_yaml.hpp"

using namespace objectness;
using objectness_test::TemporaryFolder;
using objectness_test::writeBytes;

namespace {

void put(const ConfigField& field, double value) {
  std::visit([&](auto* target) { *target = static_cast<std::decay_t<decltype(*target)>>(value); }, field.value);
}

bool mentions(const std::vector<std::string>& problems, const std::string& text) {
  for (const std::string& problem : problems) {
    if (problem.find(text) != std::string::npos) return true;
  }
  return false;
}

Status load(const std::string& yaml, Config& config) {
  const TemporaryFolder folder;
  writeBytes(folder / "preset.yaml", yaml);
  return loadConfig(folder / "preset.yaml", config);
}

}  // namespace

TEST(Config, DefaultsAreValid) { EXPECT_TRUE(validate(Config()).empty()); }

TEST(Config, FullNamesAreUnique) {
  Config config;
  std::set<std::string> names;
  for (const ConfigField& field : configFields(config))
    EXPECT_TRUE(names.insert(field.fullName()).second) << field.fullName();
  EXPECT_GT(names.size(), 40u);
}

TEST(Config, EveryValueOutOfItsRangeIsNamedWithTheRange) {
  const Config defaults;
  Config config;
  for (const ConfigField& field : configFields(config)) {
    if (std::holds_alternative<bool*>(field.value)) continue;
    for (const double wrong : {field.range.min - 1, field.range.max + 1}) {
      if (std::holds_alternative<int*>(field.value) && wrong > std::numeric_limits<int>::max()) continue;
      config = defaults;
      put(field, wrong);
      const auto problems = validate(config);
      EXPECT_TRUE(mentions(problems, field.fullName() + " is ")) << field.fullName();
      const bool is_method = std::holds_alternative<SegmentationMethod*>(field.value);
      EXPECT_TRUE(mentions(problems, is_method ? "must be objectness, paper or boxes" : "must be within"))
          << field.fullName();
    }
    if (std::holds_alternative<double*>(field.value)) {
      config = defaults;
      put(field, std::nan(""));
      EXPECT_TRUE(mentions(validate(config), field.fullName() + " is nan")) << field.fullName();
    }
  }
}

TEST(Config, ContradictionsAreNamed) {
  const auto problemsOf = [](auto change) {
    Config config;
    change(config);
    return validate(config);
  };
  EXPECT_TRUE(mentions(problemsOf([](Config& c) { c.input.min_depth_m = 3, c.input.max_depth_m = 2; }),
                       "input.min_depth_m is 3, must be less than input.max_depth_m, which is 2"));
  EXPECT_TRUE(mentions(problemsOf([](Config& c) { c.normals.min_window_px = 40; }), "normals.max_window_px"));
  EXPECT_TRUE(mentions(problemsOf([](Config& c) { c.search.min_size_m = 0.6; }), "search.max_size_m"));
  EXPECT_TRUE(mentions(problemsOf([](Config& c) { c.search.corner_step_m = 0.025; }),
                       "search.corner_step_m is 0.025, must be a whole multiple of volume.voxel_m, which is 0.01"));
  EXPECT_TRUE(mentions(problemsOf([](Config& c) { c.volume.voxel_m = 0.008; }), "search.min_size_m"));
  EXPECT_TRUE(
      mentions(problemsOf([](Config& c) { c.selection.end_temperature = 2000; }), "selection.start_temperature"));
  EXPECT_TRUE(mentions(problemsOf([](Config& c) { c.table.given = true; }), "table.given_a"));
  EXPECT_TRUE(problemsOf([](Config& c) { c.volume.voxel_m = 0.005; }).empty());
}

TEST(ConfigYaml, LaysAPresetOverTheConfiguration) {
  Config config;
  config.runtime.seed = 7;
  const Status status = load("search:\n  angle_step_deg: 10\nsegments: {max_reach_m: 0.1, min_pixels: 5}\n", config);
  ASSERT_TRUE(status.ok()) << status.message;
  EXPECT_EQ(config.search.angle_step_deg, 10);
  EXPECT_EQ(config.segments.max_reach_m, 0.1);
  EXPECT_EQ(config.segments.min_pixels, 5);
  EXPECT_EQ(config.runtime.seed, 7);
  EXPECT_TRUE(load("", config).ok());
}

TEST(ConfigYaml, WritesWhatItReads) {
  Config config, read;
  config.search.angle_step_deg = 90.0 / 7;
  config.table.given = true;
  config.table.given_c = -1.0 / 3;
  config.runtime.threads = 5;
  ASSERT_TRUE(load(toYaml(config), read).ok());
  EXPECT_EQ(read.search.angle_step_deg, 90.0 / 7);
  EXPECT_EQ(read.table.given_c, -1.0 / 3);
  EXPECT_EQ(toYaml(read), toYaml(config));
}

TEST(ConfigYaml, NamesEveryProblemAndChangesNothing) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"serach: {angle_step_deg: 10}",
       "there is no parameter serach.angle_step_deg (did you mean search.angle_step_deg?)"},
      {"search: {angle_step: 10}", "did you mean search.angle_step_deg?"},
      {"saerch: 3", "there is no group saerch (did you mean search?)"},
      {"search: 3", "group search must hold"},
      {"search: {angle_step_deg: ten}", "search.angle_step_deg is 'ten', must be a number"},
      {"search: {angle_step_deg: [1, 2]}", "search.angle_step_deg is not a single value"},
      {"search: {angle_step_deg: }", "search.angle_step_deg is empty"},
      {"runtime: {seed: 1.5}", "runtime.seed is '1.5', must be a whole number"},
      {"table: {given: 3}", "table.given is '3', must be true or false"},
      {"search: {angle_step_deg: 0}", "search.angle_step_deg is 0, must be within 1 and 90"},
      {"search: {angle_step_deg: .nan}", "search.angle_step_deg is nan"},
      {"runtime: {seed: 1.5}\nsearch: {angle_step: 10}", "runtime.seed is '1.5', must be a whole number; there is no"},
      {"search: {angle_step_deg: 10", "is not valid YAML"},
      {"search: {angle_step_deg:", "is not valid YAML"},
      {"search: {angle_step_deg:] 10}", "is not valid YAML"},
      {"- 1", "is not a preset"}};
  for (const auto& [yaml, expected] : cases) {
    Config config;
    const Status status = load(yaml, config);
    EXPECT_FALSE(status.ok()) << yaml;
    EXPECT_NE(status.message.find(expected), std::string::npos) << status.message;
    EXPECT_EQ(toYaml(config), toYaml(Config()));
  }
  Config config;
  EXPECT_EQ(loadConfig("/no/such.yaml", config).message, "there is no such file");
}

TEST(ConfigYaml, Assignments) {
  Config config;
  ASSERT_TRUE(setParameters({"volume.voxel_m=0.005", "filter.threshold=-1e-1"}, config).ok());
  EXPECT_EQ(config.volume.voxel_m, 0.005);
  EXPECT_EQ(config.filter.threshold, -0.1);
  // Each alone would contradict the other's old value.
  EXPECT_TRUE(setParameters({"search.min_size_m=0.6", "search.max_size_m=0.8"}, config).ok());
  EXPECT_NE(setParameters({"threshold=1"}, config).message.find("did you mean filter.threshold?"), std::string::npos);
  EXPECT_NE(setParameters({"filter.threshold"}, config).message.find("must be group.field=value"), std::string::npos);
  EXPECT_FALSE(setParameters({"filter.threshold=1: 2"}, config).ok());
}

TEST(ConfigYaml, MethodsHaveNames) {
  Config config;
  for (std::size_t k = 0; k < kMethodNames.size(); ++k) {
    ASSERT_TRUE(load(std::string("pipeline: {method: ") + kMethodNames[k] + "}", config).ok());
    EXPECT_EQ(config.pipeline.method, static_cast<SegmentationMethod>(k));
    EXPECT_NE(toYaml(config).find(std::string("method: ") + kMethodNames[k]), std::string::npos);
  }
  EXPECT_NE(setParameters({"pipeline.method=graph"}, config)
                .message.find("pipeline.method is 'graph', must be objectness, paper or boxes"),
            std::string::npos);
}

TEST(ConfigYaml, FormerNamesOfMethodsCountWithAWarning) {
  const std::vector<std::tuple<std::vector<std::string>, SegmentationMethod, std::size_t>> cases{
      {{}, SegmentationMethod::kObjectness, 0},
      {{"grouping.enabled=false"}, SegmentationMethod::kPaper, 1},
      {{"pipeline.method=paper", "grouping.enabled=true"}, SegmentationMethod::kPaper, 1},
      {{"grouping.enabled=false", "pipeline.method=objectness"}, SegmentationMethod::kObjectness, 1},
      {{"segments.follow_superpixels=false", "grouping.enabled=false"}, SegmentationMethod::kBoxes, 2},
      {{"segments.follow_superpixels=false"}, SegmentationMethod::kObjectness, 1},
      {{"pipeline.method=boxes", "segments.follow_superpixels=true"}, SegmentationMethod::kBoxes, 1}};
  for (const auto& [assignments, method, warned] : cases) {
    Config config;
    std::vector<std::string> warnings;
    ASSERT_TRUE(setParameters(assignments, config, &warnings).ok());
    EXPECT_EQ(config.pipeline.method, method);
    ASSERT_EQ(warnings.size(), warned);
    for (const std::string& warning : warnings) {
      EXPECT_NE(warning.find("is replaced by pipeline.method: "), std::string::npos) << warning;
    }
  }
  // Over a preset that was read before.
  for (const auto& [start, assignment, method] :
       {std::tuple("paper", "grouping.enabled=true", SegmentationMethod::kObjectness),
        std::tuple("boxes", "grouping.enabled=false", SegmentationMethod::kBoxes),
        std::tuple("boxes", "segments.follow_superpixels=true", SegmentationMethod::kPaper)}) {
    Config changed;
    ASSERT_TRUE(setParameters({std::string("pipeline.method=") + start}, changed).ok());
    ASSERT_TRUE(setParameters({assignment}, changed).ok());
    EXPECT_EQ(changed.pipeline.method, method) << assignment;
  }
  Config config;
  EXPECT_NE(setParameters({"grouping.enabled=3"}, config).message.find("must be true or false"), std::string::npos);
  std::vector<std::string> warnings;
  const TemporaryFolder folder;
  writeBytes(folder / "preset.yaml", "grouping: {enabled: off}");
  ASSERT_TRUE(loadConfig(folder / "preset.yaml", config, &warnings).ok());
  EXPECT_EQ(warnings, std::vector<std::string>{"grouping.enabled is replaced by pipeline.method: paper"});
}

TEST(ConfigYaml, ListsEveryParameter) {
  const std::string list = listParameters();
  EXPECT_NE(list.find("search.angle_step_deg\tdouble\t5\t1\t90\tstep of"), std::string::npos) << list;
  EXPECT_NE(list.find("table.given\tbool\tfalse\tfalse\ttrue\t"), std::string::npos);
  EXPECT_NE(list.find("pipeline.method\tstring\tobjectness\tobjectness|paper|boxes\t\t"), std::string::npos);
}

TEST(ConfigYaml, ShippedPresetsLoad) {
  int presets = 0;
  for (const auto& file : std::filesystem::directory_iterator(REPOSITORY_DIR "/cfg")) {
    if (file.path().extension() != ".yaml") continue;
    Config config;
    const Status status = loadConfig(file.path().string(), config);
    EXPECT_TRUE(status.ok()) << file.path() << ": " << status.message;
    const bool is_default = file.path().stem() == "default";
    EXPECT_EQ(is_default, toYaml(config) == toYaml(Config())) << file.path() << " changes nothing";
    ++presets;
  }
  EXPECT_GE(presets, 4);
}
