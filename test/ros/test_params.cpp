// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/ros/params.hpp"

#include <gtest/gtest.h>
#include <objectness_segmentation/ObjectnessSegmentationConfig.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

namespace {

using namespace objectness_segmentation;
using objectness::Config;
using objectness::Range;
using Generated = ObjectnessSegmentationConfig;

constexpr char kOutOfDate[] = "cfg/ObjectnessSegmentation.cfg is out of date: run scripts/update_cfg";

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
  return values;
}

std::map<std::string, std::string> valuesOf(const Generated& config) {
  dynamic_reconfigure::Config message;
  config.__toMessage__(message);
  return valuesOf(message);
}

/// The C++ structs with every number replaced by its lower or upper bound.
struct SetToBound {
  bool upper;
  template <class Number>
  void operator()(const std::string&, const std::string&, Number& value, const Range& range, const char*) const {
    value = static_cast<Number>(upper ? range.max : range.min);
  }
  void operator()(const std::string&, const std::string&, bool& value, const char*) const { value = upper; }
};

Config bounds(bool upper) {
  Config config;
  visitParameters(config, SetToBound{upper});
  return config;
}

TEST(DynamicReconfigure, DefaultsAreThoseOfTheStructs) {
  EXPECT_EQ(valuesOf(Generated::__getDefault__()), valuesOf(toReconfigureMessage(Config{}))) << kOutOfDate;
}

TEST(DynamicReconfigure, RangesAreThoseOfTheStructs) {
  EXPECT_EQ(valuesOf(Generated::__getMin__()), valuesOf(toReconfigureMessage(bounds(false)))) << kOutOfDate;
  EXPECT_EQ(valuesOf(Generated::__getMax__()), valuesOf(toReconfigureMessage(bounds(true)))) << kOutOfDate;
}

/// "group/type name: description" of each reconfigurable field, in order.
struct ListDescriptions {
  std::vector<std::string>& list;
  template <class Value>
  void operator()(const std::string& group, const std::string& name, const Value&, const Range&,
                  const char* description) const {
    add(group, std::is_same<Value, int>::value ? "int" : "double", name, description);
  }
  void operator()(const std::string& group, const std::string& name, bool, const char* description) const {
    add(group, "bool", name, description);
  }
  void add(const std::string& group, const char* type, const std::string& name, const char* description) const {
    if (isReconfigurable(group)) list.push_back(group + "/" + type + " " + name + ": " + description);
  }
};

TEST(DynamicReconfigure, GroupsAndDescriptionsAreThoseOfTheStructs) {
  std::vector<std::string> expected, generated;
  const Config config;
  visitParameters(config, ListDescriptions{expected});
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

TEST(Parameters, HaveFlatNamesWithUnits) {
  std::vector<std::string> names;
  const Config config;
  visitParameters(config, [&names](const std::string&, const std::string& name, const auto&...) { names.push_back(name); });
  EXPECT_EQ(std::count(names.begin(), names.end(), "objectness_weight_edges"), 1);
  EXPECT_EQ(std::count(names.begin(), names.end(), "volume_voxel_m"), 1);
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
}

}  // namespace
