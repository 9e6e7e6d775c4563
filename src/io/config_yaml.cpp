// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/io/config_yaml.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <iomanip>
#include <limits>
#include <set>
#include <sstream>

#include "io/file_access.hpp"
#include "io/name_suggestion.hpp"
#include "io/yaml_text.hpp"
#include "method_names.hpp"
#include "objectness_segmentation/former_parameters.hpp"

namespace objectness {
namespace {

using Problems = std::vector<std::string>;

struct TypeName {
  const char* operator()(const double*) const { return "double"; }
  const char* operator()(const int*) const { return "int"; }
  const char* operator()(const bool*) const { return "bool"; }
  const char* operator()(const SegmentationMethod*) const { return "string"; }
};

struct ExpectedText {
  std::string operator()(const double*) const { return "a number"; }
  std::string operator()(const int*) const { return "a whole number"; }
  std::string operator()(const bool*) const { return "true or false"; }
  std::string operator()(const SegmentationMethod*) const { return joinedMethodNames(", ", " or "); }
};

struct ValueText {
  std::string operator()(const bool* value) const { return *value ? "true" : "false"; }
  std::string operator()(const int* value) const { return std::to_string(*value); }
  std::string operator()(const SegmentationMethod* value) const { return toString(*value); }
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

template <class T>
bool read(const YAML::Node& node, T& value) {
  return YAML::convert<T>::decode(node, value);
}

bool read(const YAML::Node& node, SegmentationMethod& value) {
  const auto method = methodNamed(node.Scalar());
  value = method.value_or(value);
  return method.has_value();
}

void assign(const ConfigField& field, const YAML::Node& node, Problems& problems) {
  const bool converted = node.IsScalar() && std::visit([&](auto* value) { return read(node, *value); }, field.value);
  if (converted) return;
  const std::string found = node.IsScalar() ? "'" + node.Scalar() + "'"
                            : node.IsNull() ? "empty"
                                            : "not a single value";
  problems.push_back(field.fullName() + " is " + found + ", must be " + std::visit(ExpectedText(), field.value));
}

std::string joined(const Problems& problems) {
  std::string text;
  for (const std::string& problem : problems) text += (text.empty() ? "" : "; ") + problem;
  return text;
}

/// A configuration as it is being changed: all of the new values are taken over, or none.
class Change {
 public:
  explicit Change(const Config& config) : changed_(config), fields_(configFields(changed_)) {
    for (const ConfigField& field : former_.fields()) fields_.push_back(field);
  }
  Change(const Change&) = delete;  // fields_ points into it
  Change& operator=(const Change&) = delete;

  void assignByName(const std::string& full_name, const YAML::Node& node) {
    std::vector<std::string> names;
    for (const ConfigField& field : fields_) {
      if (field.fullName() == full_name) {
        given_.insert(full_name);
        return assign(field, node, problems_);
      }
      names.push_back(field.fullName());
    }
    refuse("there is no parameter " + full_name + didYouMean(full_name, names));
  }
  void refuse(const std::string& problem) { problems_.push_back(problem); }
  const std::vector<ConfigField>& fields() const { return fields_; }

  /// Takes it over when everything about it is right.
  Status commit(Config& config, std::vector<std::string>* warnings) {
    const std::vector<std::string> replaced = former_.apply(given_, changed_);
    // A value that could not be read would only be complained about twice.
    if (problems_.empty()) problems_ = validate(changed_);
    if (!problems_.empty()) return Status::error(StatusCode::kBadConfig, joined(problems_));
    if (warnings) warnings->insert(warnings->end(), replaced.begin(), replaced.end());
    config = changed_;
    return {};
  }

 private:
  Config changed_;
  FormerParameters former_;
  std::vector<ConfigField> fields_;
  std::set<std::string> given_;
  Problems problems_;
};

void assignGroups(const YAML::Node& root, Change& change) {
  for (const auto& group : root) {
    const std::string group_name = group.first.Scalar();
    if (group.second.IsMap()) {
      for (const auto& field : group.second) {
        change.assignByName(group_name + "." + field.first.Scalar(), field.second);
      }
      continue;
    }
    std::vector<std::string> groups;
    for (const ConfigField& field : change.fields()) groups.push_back(field.group);
    const bool known = std::find(groups.begin(), groups.end(), group_name) != groups.end();
    change.refuse(known ? "group " + group_name + " must hold a list of 'field: value'"
                        : "there is no group " + group_name + didYouMean(group_name, groups));
  }
}

}  // namespace

Status loadConfig(const std::string& path, Config& config, std::vector<std::string>* warnings) {
  const Result<std::string> text = readFile(path, kMaxTextBytes);
  if (!text.ok()) return text.status;
  try {
    const YAML::Node root = parseYaml(text.value);
    if (root.IsNull()) return {};
    if (!root.IsMap()) {
      return Status::error(StatusCode::kBadInput, "is not a preset: it must hold 'group:' and below it 'field: value'");
    }
    Change change(config);
    assignGroups(root, change);
    return change.commit(config, warnings);
  } catch (const YAML::Exception& e) {
    return Status::error(StatusCode::kBadInput, std::string("is not valid YAML: ") + e.what());
  }
}

Status setParameters(const std::vector<std::string>& assignments, Config& config, std::vector<std::string>* warnings) {
  Change change(config);
  for (const std::string& assignment : assignments) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0) {
      change.refuse("'" + assignment + "' is no assignment, must be group.field=value");
      continue;
    }
    // The node holds the text as it is: it cannot break out of its field.
    change.assignByName(assignment.substr(0, equals), YAML::Node(assignment.substr(equals + 1)));
  }
  return change.commit(config, warnings);
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
    const bool is_method = std::holds_alternative<SegmentationMethod*>(field.value);
    const std::string least = is_bool ? "false" : is_method ? joinedMethodNames("|", "|") : number(field.range.min);
    const std::string largest = is_bool ? "true" : is_method ? "" : number(field.range.max);
    text << field.fullName() << '\t' << std::visit(TypeName(), field.value) << '\t'
         << std::visit(ValueText(), field.value) << '\t' << least << '\t' << largest << '\t' << field.description
         << '\n';
  }
  return text.str();
}

}  // namespace objectness
