// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/io/config_yaml.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <iomanip>
#include <limits>
#include <sstream>

#include "io/file_access.hpp"
#include "io/name_suggestion.hpp"
#include "io/yaml_text.hpp"
#include "objectness_segmentation/config_fields.hpp"

namespace objectness {
namespace {

using Problems = std::vector<std::string>;

struct TypeName {
  const char* operator()(const double*) const { return "double"; }
  const char* operator()(const int*) const { return "int"; }
  const char* operator()(const bool*) const { return "bool"; }
};

struct ExpectedText {
  const char* operator()(const double*) const { return "a number"; }
  const char* operator()(const int*) const { return "a whole number"; }
  const char* operator()(const bool*) const { return "true or false"; }
};

struct ValueText {
  std::string operator()(const bool* value) const { return *value ? "true" : "false"; }
  std::string operator()(const int* value) const { return std::to_string(*value); }
  /// The shortest text that reads back as the same number.
  std::string operator()(const double* value) const {
    std::ostringstream text;
    for (int digits = 6; digits <= std::numeric_limits<double>::max_digits10; ++digits) {
      text.str("");
      text << std::setprecision(digits) << *value;
      if (std::stod(text.str()) == *value) break;
    }
    return text.str();
  }
};

std::string number(double value) { return ValueText()(&value); }

void assign(const ConfigField& field, const YAML::Node& node, Problems& problems) {
  const bool converted =
      node.IsScalar() &&
      std::visit([&](auto* value) { return YAML::convert<std::decay_t<decltype(*value)>>::decode(node, *value); },
                 field.value);
  if (converted) return;
  const std::string found = node.IsScalar() ? "'" + node.Scalar() + "'"
                            : node.IsNull() ? "empty"
                                            : "not a single value";
  problems.push_back(field.fullName() + " is " + found + ", must be " + std::visit(ExpectedText(), field.value));
}

void assignByName(std::vector<ConfigField>& fields, const std::string& full_name, const YAML::Node& node,
                  Problems& problems) {
  std::vector<std::string> names;
  for (const ConfigField& field : fields) {
    if (field.fullName() == full_name) return assign(field, node, problems);
    names.push_back(field.fullName());
  }
  problems.push_back("there is no parameter " + full_name + didYouMean(full_name, names));
}

std::string joined(const Problems& problems) {
  std::string text;
  for (const std::string& problem : problems) text += (text.empty() ? "" : "; ") + problem;
  return text;
}

/// Accepts the changed configuration when everything about it is right.
Status commit(const Config& changed, Problems problems, Config& config) {
  // A value that could not be read would only be complained about twice.
  if (problems.empty()) problems = validate(changed);
  if (!problems.empty()) return Status::error(StatusCode::kBadConfig, joined(problems));
  config = changed;
  return {};
}

void assignGroups(const YAML::Node& root, std::vector<ConfigField>& fields, Problems& problems) {
  for (const auto& group : root) {
    const std::string group_name = group.first.Scalar();
    if (group.second.IsMap()) {
      for (const auto& field : group.second) {
        assignByName(fields, group_name + "." + field.first.Scalar(), field.second, problems);
      }
      continue;
    }
    std::vector<std::string> groups;
    for (const ConfigField& field : fields) groups.push_back(field.group);
    const bool known = std::find(groups.begin(), groups.end(), group_name) != groups.end();
    problems.push_back(known ? "group " + group_name + " must hold a list of 'field: value'"
                             : "there is no group " + group_name + didYouMean(group_name, groups));
  }
}

}  // namespace

Status loadConfig(const std::string& path, Config& config) {
  const Result<std::string> text = readFile(path, kMaxTextBytes);
  if (!text.ok()) return text.status;
  try {
    const YAML::Node root = parseYaml(text.value);
    if (root.IsNull()) return {};
    if (!root.IsMap()) {
      return Status::error(StatusCode::kBadInput, "is not a preset: it must hold 'group:' and below it 'field: value'");
    }
    Config changed = config;
    std::vector<ConfigField> fields = configFields(changed);
    Problems problems;
    assignGroups(root, fields, problems);
    return commit(changed, problems, config);
  } catch (const YAML::Exception& e) {
    return Status::error(StatusCode::kBadInput, std::string("is not valid YAML: ") + e.what());
  }
}

Status setParameters(const std::vector<std::string>& assignments, Config& config) {
  Config changed = config;
  std::vector<ConfigField> fields = configFields(changed);
  Problems problems;
  for (const std::string& assignment : assignments) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0) {
      problems.push_back("'" + assignment + "' is no assignment, must be group.field=value");
      continue;
    }
    // The node holds the text as it is: it cannot break out of its field.
    assignByName(fields, assignment.substr(0, equals), YAML::Node(assignment.substr(equals + 1)), problems);
  }
  return commit(changed, problems, config);
}

std::string toYaml(const Config& config) {
  Config copy = config;
  std::ostringstream text;
  std::string group;
  for (const ConfigField& field : configFields(copy)) {
    if (field.group != group) text << field.group << ":\n";
    group = field.group;
    text << "  " << field.name << ": " << std::visit(ValueText(), field.value) << "\n";
  }
  return text.str();
}

std::string listParameters() {
  Config defaults;
  std::ostringstream text;
  for (const ConfigField& field : configFields(defaults)) {
    const bool is_bool = std::holds_alternative<bool*>(field.value);
    text << field.fullName() << '\t' << std::visit(TypeName(), field.value) << '\t'
         << std::visit(ValueText(), field.value) << '\t' << (is_bool ? "false" : number(field.range.min)) << '\t'
         << (is_bool ? "true" : number(field.range.max)) << '\t' << field.description << '\n';
  }
  return text.str();
}

}  // namespace objectness
