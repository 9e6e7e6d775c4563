// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/ros/params.hpp"

#include <algorithm>
#include <set>
#include <sstream>
#include <type_traits>
#include <variant>

#include "method_names.hpp"

namespace objectness_segmentation {
namespace {

using objectness::Config;
using objectness::ConfigField;
using objectness::configFields;
using objectness::FormerParameters;
using objectness::SegmentationMethod;
using XmlRpc::XmlRpcValue;

/// The name in the nested form of the presets.
std::string nestedName(const ConfigField& field) { return field.group + "/" + field.name; }

/// Exact types only, but a whole number may stand for a double: `max_depth_m: 6`. Takes a copy as XmlRpcValue's
/// conversions are not const.
bool convert(XmlRpcValue from, double& to) {
  if (from.getType() == XmlRpcValue::TypeInt) {
    to = static_cast<int>(from);
    return true;
  }
  if (from.getType() != XmlRpcValue::TypeDouble) return false;
  to = static_cast<double>(from);
  return true;
}
bool convert(XmlRpcValue from, int& to) {
  if (from.getType() != XmlRpcValue::TypeInt) return false;
  to = static_cast<int>(from);
  return true;
}
bool convert(XmlRpcValue from, bool& to) {
  if (from.getType() != XmlRpcValue::TypeBoolean) return false;
  to = static_cast<bool>(from);
  return true;
}

bool convert(XmlRpcValue from, SegmentationMethod& to) {
  if (from.getType() != XmlRpcValue::TypeString) return false;
  const auto method = objectness::methodNamed(static_cast<std::string>(from));
  to = method.value_or(to);
  return method.has_value();
}

/// Sets the field; false, and the field as it was, when the value has the wrong type or is out of range.
bool assign(const XmlRpcValue& value, const ConfigField& field) {
  return std::visit(
      [&](auto* target) {
        auto converted = *target;
        if (!convert(value, converted)) return false;
        const auto number = static_cast<double>(converted);
        if (!(number >= field.range.min && number <= field.range.max)) return false;  // also of NaN
        *target = converted;
        return true;
      },
      field.value);
}

std::string expectation(const ConfigField& field) {
  if (std::holds_alternative<bool*>(field.value)) return "true or false";
  if (std::holds_alternative<SegmentationMethod*>(field.value)) return objectness::joinedMethodNames(", ", " or ");
  std::ostringstream text;
  text << (std::holds_alternative<int*>(field.value) ? "a whole number" : "a number") << " from " << field.range.min
       << " to " << field.range.max;
  return text.str();
}

/// Parameters below nh that nobody reads: most likely misspelt.
std::vector<std::string> findUnknown(const ros::NodeHandle& nh, const std::vector<std::string>& others) {
  std::set<std::string> known(others.begin(), others.end());
  Config config;
  FormerParameters former;
  for (const auto& fields : {configFields(config), former.fields()}) {
    for (const ConfigField& field : fields) known.insert({parameterName(field), nestedName(field)});
  }
  std::vector<std::string> all, unknown;
  nh.getParamNames(all);
  const std::string prefix = nh.getNamespace() + "/";
  for (const std::string& name : all) {
    if (name.compare(0, prefix.size(), prefix) == 0 && known.count(name.substr(prefix.size())) == 0) {
      unknown.push_back("parameter " + name + " is not known and has no effect");
    }
  }
  return unknown;
}

/// Calls visit(list, value) with the message's list for the field's type.
template <class Message, class Visit>
void visitList(Message& message, const ConfigField& field, Visit&& visit) {
  if (auto* const* number = std::get_if<double*>(&field.value)) visit(message.doubles, **number);
  if (auto* const* whole = std::get_if<int*>(&field.value)) visit(message.ints, **whole);
  if (auto* const* flag = std::get_if<bool*>(&field.value)) visit(message.bools, **flag);
  if (auto* const* method = std::get_if<SegmentationMethod*>(&field.value)) visit(message.strs, **method);
}

// Values as dynamic_reconfigure has them.
template <class T>
T toReconfigure(T value) {
  return value;
}
std::string toReconfigure(SegmentationMethod method) { return objectness::toString(method); }
template <class T, class From>
void fromReconfigure(const From& from, T& to) {
  to = from;
}
/// What is no name of a method becomes a value that validate() rejects.
void fromReconfigure(const std::string& name, SegmentationMethod& to) {
  constexpr auto kNone = static_cast<SegmentationMethod>(objectness::kMethodNames.size());
  to = objectness::methodNamed(name).value_or(kNone);
}

}  // namespace

std::string parameterName(const ConfigField& field) { return field.group + "_" + field.name; }

bool isReconfigurable(const ConfigField& field) {
  // Switches of single cues are for experiments: a robot's model knows them all.
  static const std::set<std::string> at_start = {"runtime", "contact_cues", "gap_cues", "group_cues"};
  return at_start.count(field.group) == 0;
}

ReadParameters readParameters(const ros::NodeHandle& nh, const std::vector<std::string>& others) {
  ReadParameters result;
  FormerParameters former;
  std::set<std::string> given;
  std::vector<ConfigField> fields = configFields(result.config);
  for (const ConfigField& field : former.fields()) fields.push_back(field);
  for (const ConfigField& field : fields) {
    for (const std::string& name : {nestedName(field), parameterName(field)}) {
      XmlRpcValue value;
      if (!nh.getParam(name, value)) continue;
      if (assign(value, field)) {
        given.insert(field.fullName());
      } else {
        std::ostringstream problem;
        problem << "parameter " << nh.resolveName(name) << " is " << value << ", must be " << expectation(field)
                << ": it is not used";
        result.problems.push_back(problem.str());
      }
    }
  }
  for (const std::string& warning : former.apply(given, result.config))
    result.problems.push_back("parameter " + warning);
  for (std::string& unknown : findUnknown(nh, others)) result.problems.push_back(std::move(unknown));
  const std::vector<std::string> contradictions = objectness::validate(result.config);
  if (!contradictions.empty()) {
    result.problems.insert(result.problems.end(), contradictions.begin(), contradictions.end());
    result.problems.push_back("the parameters contradict each other: every one has its default");
    result.config = Config{};
  }
  return result;
}

void writeReconfigurable(Config config, const ros::NodeHandle& nh) {
  for (const ConfigField& field : configFields(config)) {
    if (!isReconfigurable(field)) continue;
    std::visit([&](const auto* value) { nh.setParam(parameterName(field), toReconfigure(*value)); }, field.value);
  }
}

dynamic_reconfigure::Config toReconfigureMessage(Config config) {
  dynamic_reconfigure::Config message;
  for (const ConfigField& field : configFields(config)) {
    if (!isReconfigurable(field)) continue;
    visitList(message, field, [&](auto& list, const auto& value) {
      list.emplace_back();
      list.back().name = parameterName(field);
      list.back().value = toReconfigure(value);
    });
  }
  return message;
}

Config fromReconfigureMessage(const dynamic_reconfigure::Config& message, Config config) {
  for (const ConfigField& field : configFields(config)) {
    if (!isReconfigurable(field)) continue;
    visitList(message, field, [name = parameterName(field)](const auto& list, auto& value) {
      const auto named = std::find_if(list.begin(), list.end(), [&](const auto& entry) { return entry.name == name; });
      if (named != list.end()) fromReconfigure(named->value, value);
    });
  }
  return config;
}

}  // namespace objectness_segmentation
