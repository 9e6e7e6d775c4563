// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <objectness_segmentation/ObjectnessSegmentationConfig.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "objectness_segmentation/ros/params.hpp"

namespace {

using namespace objectness_segmentation;
using objectness::Config;
using objectness::ConfigField;
using objectness::configFields;
using Generated = ObjectnessSegmentationConfig;

constexpr char kOutOfDate[] = "cfg/ObjectnessSegmentation.cfg is out of date: run scripts/update_parameters";

/// name -> value of any type, as written in messages: type and text.
std::map<std::string, std::string> valuesOf(const dynamic_reconfigure::Config& message) {
  std::map<std::string, std::string> values;
  char text[64];
  for (const auto& entry : message.doubles) {
    std::snprintf(text, sizeof(text), "double %.17g", entry.value);
    values[entry.name] = text;
  }
  for (const auto& entry : message.ints) values[entry.name] = "int " + std::to_string(entry.value);
  for (const auto& entry : message.bools) values[entry.name] = entry.value ? "bool true" : "bool false";
  for (const auto& entry : message.strs) values[entry.name] = "str " + entry.value;
  return values;
}

std::map<std::string, std::string> valuesOf(const Generated& config) {
  dynamic_reconfigure::Config message;
  config.__toMessage__(message);
  return valuesOf(message);
}

/// Every number at its lower or upper bound, every flag accordingly.
Config bounds(bool upper) {
  Config config;
  for (const ConfigField& field : configFields(config)) {
    std::visit(
        [&](auto* value) {
          *value = static_cast<std::decay_t<decltype(*value)>>(upper ? field.range.max : field.range.min);
        },
        field.value);
  }
  return config;
}

TEST(DynamicReconfigure, DefaultsAreThoseOfTheStructs) {
  EXPECT_EQ(valuesOf(Generated::__getDefault__()), valuesOf(toReconfigureMessage(Config{}))) << kOutOfDate;
}

TEST(DynamicReconfigure, RangesAreThoseOfTheStructs) {
  const auto ranged = [](const auto& config) {
    std::map<std::string, std::string> values = valuesOf(config);
    values.erase("pipeline_method");  // names have no order
    return values;
  };
  EXPECT_EQ(ranged(Generated::__getMin__()), ranged(toReconfigureMessage(bounds(false)))) << kOutOfDate;
  EXPECT_EQ(ranged(Generated::__getMax__()), ranged(toReconfigureMessage(bounds(true)))) << kOutOfDate;
}

TEST(DynamicReconfigure, GroupsAndDescriptionsAreThoseOfTheStructs) {
  std::vector<std::string> expected, generated;
  Config config;
  for (const ConfigField& field : configFields(config)) {
    const char* type[] = {"double", "int", "bool", "str"};  // as in the variant
    if (!isReconfigurable(field)) continue;
    expected.push_back(field.group + "/" + type[field.value.index()] + " " + parameterName(field) + ": " +
                       field.description);
  }
  for (const auto& group : Generated::__getGroupDescriptions__()) {
    if (group->id == 0) continue;  // the root: all parameters once more
    for (const auto& parameter : group->parameters) {
      generated.push_back(group->name + "/" + parameter.type + " " + parameter.name + ": " + parameter.description);
    }
  }
  EXPECT_EQ(generated, expected) << kOutOfDate;
}

TEST(DynamicReconfigure, MessagesRoundTripEveryField) {
  Config changed = bounds(true);
  changed.runtime = Config{}.runtime;
  const Config back = fromReconfigureMessage(toReconfigureMessage(changed), Config{});
  EXPECT_EQ(valuesOf(toReconfigureMessage(back)), valuesOf(toReconfigureMessage(changed)));
  EXPECT_EQ(back.objectness.weight_edges, changed.objectness.weight_edges);
}

TEST(DynamicReconfigure, WhatIsNoMethodIsNotValid) {
  Config config;
  config.pipeline.method = objectness::SegmentationMethod::kPaper;
  dynamic_reconfigure::Config message = toReconfigureMessage(Config{});
  ASSERT_EQ(message.strs.size(), 1u);
  EXPECT_EQ(fromReconfigureMessage(message, config).pipeline.method, objectness::SegmentationMethod::kObjectness);
  message.strs[0].value = "graph";
  EXPECT_EQ(objectness::validate(fromReconfigureMessage(message, config)).size(), 1u);
}

TEST(DynamicReconfigure, LeavesTheStartParametersAlone) {
  Config started;
  started.runtime.threads = 7;
  started.runtime.seed = 11;
  dynamic_reconfigure::Config message = toReconfigureMessage(Config{});
  EXPECT_EQ(valuesOf(message).count("runtime_threads"), 0u);
  message.ints.emplace_back();
  message.ints.back().name = "runtime_threads";
  message.ints.back().value = 3;
  const Config config = fromReconfigureMessage(message, started);
  EXPECT_EQ(config.runtime.threads, 7);
  EXPECT_EQ(config.runtime.seed, 11);
}

TEST(DynamicReconfigure, LeavesCueSwitchesToTheStart) {
  Config config;
  const auto fields = configFields(config);
  for (const char* name : {"runtime.seed", "contact_cues.step", "gap_cues.flush", "group_cues.free", "links.gaps"}) {
    const auto field = std::find_if(fields.begin(), fields.end(), [&](const auto& f) { return f.fullName() == name; });
    ASSERT_NE(field, fields.end()) << name;
    EXPECT_EQ(isReconfigurable(*field), field->group == "links") << name;
  }
}

TEST(Parameters, HaveFlatNamesWithUnits) {
  std::vector<std::string> names;
  Config config;
  for (const ConfigField& field : configFields(config)) names.push_back(parameterName(field));
  EXPECT_EQ(std::count(names.begin(), names.end(), "objectness_weight_edges"), 1);
  EXPECT_EQ(std::count(names.begin(), names.end(), "volume_voxel_m"), 1);
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
}

}  // namespace
