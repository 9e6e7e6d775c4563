// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/ros/params.hpp"

#include <algorithm>
#include <set>
#include <sstream>

namespace objectness_segmentation {
namespace {

using objectness::Config;
using objectness::Range;

/// Exact types only, but a whole number may stand for a double: `max_depth_m: 6`.
bool assign(const XmlRpc::XmlRpcValue& value, double& field) {
  XmlRpc::XmlRpcValue copy = value;  // its conversions are not const
  if (copy.getType() == XmlRpc::XmlRpcValue::TypeInt) {
    field = static_cast<int>(copy);
    return true;
  }
  if (copy.getType() != XmlRpc::XmlRpcValue::TypeDouble) return false;
  field = static_cast<double>(copy);
  return true;
}

bool assign(const XmlRpc::XmlRpcValue& value, int& field) {
  XmlRpc::XmlRpcValue copy = value;
  if (copy.getType() != XmlRpc::XmlRpcValue::TypeInt) return false;
  field = static_cast<int>(copy);
  return true;
}

bool assign(const XmlRpc::XmlRpcValue& value, bool& field) {
  XmlRpc::XmlRpcValue copy = value;
  if (copy.getType() != XmlRpc::XmlRpcValue::TypeBoolean) return false;
  field = static_cast<bool>(copy);
  return true;
}

std::string expected(double, const Range& range) {
  std::ostringstream text;
  text << "a number from " << range.min << " to " << range.max;
  return text.str();
}
std::string expected(int, const Range& range) {
  std::ostringstream text;
  text << "a whole number from " << static_cast<long>(range.min) << " to " << static_cast<long>(range.max);
  return text.str();
}

template <class Number>
bool accepted(Number value, const Range& range) {
  return value >= range.min && value <= range.max;  // false for NaN
}

/// Reads one parameter, flat or nested, into a field.
class FieldReader {
 public:
  FieldReader(const ros::NodeHandle& nh, ReadParameters& result) : nh_(nh), result_(result) {}

  template <class Number>
  void operator()(const std::string& group, const std::string& name, Number& field, const Range& range, const char*) {
    read(group, name, field, expected(Number{}, range), [&range](Number value) { return accepted(value, range); });
  }
  void operator()(const std::string& group, const std::string& name, bool& field, const char*) {
    read(group, name, field, "true or false", [](bool) { return true; });
  }

 private:
  template <class Field, class IsAccepted>
  void read(const std::string& group, const std::string& name, Field& field, const std::string& expectation,
            IsAccepted is_accepted) {
    for (const std::string& key : {group + "/" + name.substr(group.size() + 1), name}) {
      XmlRpc::XmlRpcValue parameter;
      if (!nh_.getParam(key, parameter)) continue;
      Field value = field;
      if (assign(parameter, value) && is_accepted(value)) {
        field = value;
        continue;
      }
      std::ostringstream problem;
      problem << "parameter " << nh_.resolveName(key) << " is " << parameter.toXml() << ", expected is " << expectation
              << ": using " << field;
      result_.problems.push_back(problem.str());
    }
  }

  const ros::NodeHandle& nh_;
  ReadParameters& result_;
};

/// Parameters below nh that nobody reads: most likely misspelt.
std::vector<std::string> findUnknown(const ros::NodeHandle& nh, const std::vector<std::string>& others) {
  std::set<std::string> known(others.begin(), others.end());
  Config config;
  visitParameters(config, [&known](const std::string& group, const std::string& name, const auto&...) {
    known.insert(name);
    known.insert(group + "/" + name.substr(group.size() + 1));
  });
  std::vector<std::string> all, unknown;
  nh.getParamNames(all);
  const std::string prefix = nh.getNamespace() + "/";
  for (const std::string& name : all) {
    if (name.compare(0, prefix.size(), prefix) == 0 && known.count(name.substr(prefix.size())) == 0) {
      unknown.push_back("parameter " + name + " is not known: it is ignored");
    }
  }
  return unknown;
}

/// Appends every reconfigurable field to the list of its type.
struct MessageWriter {
  dynamic_reconfigure::Config& message;

  void operator()(const std::string& group, const std::string& name, double value, const Range&, const char*) {
    append(group, name, value, message.doubles);
  }
  void operator()(const std::string& group, const std::string& name, int value, const Range&, const char*) {
    append(group, name, value, message.ints);
  }
  void operator()(const std::string& group, const std::string& name, bool value, const char*) {
    append(group, name, value, message.bools);
  }

  template <class Value, class List>
  static void append(const std::string& group, const std::string& name, Value value, List& list) {
    if (!isReconfigurable(group)) return;
    list.emplace_back();
    list.back().name = name;
    list.back().value = value;
  }
};

struct MessageReader {
  const dynamic_reconfigure::Config& message;

  void operator()(const std::string& group, const std::string& name, double& field, const Range&, const char*) {
    find(group, name, field, message.doubles);
  }
  void operator()(const std::string& group, const std::string& name, int& field, const Range&, const char*) {
    find(group, name, field, message.ints);
  }
  void operator()(const std::string& group, const std::string& name, bool& field, const char*) {
    find(group, name, field, message.bools);
  }

  template <class Field, class List>
  static void find(const std::string& group, const std::string& name, Field& field, const List& list) {
    const auto named = std::find_if(list.begin(), list.end(), [&name](const auto& entry) { return entry.name == name; });
    if (isReconfigurable(group) && named != list.end()) field = named->value;
  }
};

}  // namespace

bool isReconfigurable(const std::string& group) { return group != "runtime"; }

ReadParameters readParameters(const ros::NodeHandle& nh, const std::vector<std::string>& others) {
  ReadParameters result;
  visitParameters(result.config, FieldReader(nh, result));
  for (std::string& unknown : findUnknown(nh, others)) result.problems.push_back(std::move(unknown));
  const std::vector<std::string> contradictions = objectness::validate(result.config);
  if (!contradictions.empty()) {
    result.problems.insert(result.problems.end(), contradictions.begin(), contradictions.end());
    result.problems.push_back("the parameters contradict each other: using the default of every one");
    result.config = Config{};
  }
  return result;
}

void writeReconfigurable(const Config& config, const ros::NodeHandle& nh) {
  visitParameters(config, [&nh](const std::string& group, const std::string& name, const auto& value, const auto&...) {
    if (isReconfigurable(group)) nh.setParam(name, value);
  });
}

dynamic_reconfigure::Config toReconfigureMessage(const Config& config) {
  dynamic_reconfigure::Config message;
  visitParameters(config, MessageWriter{message});
  return message;
}

Config fromReconfigureMessage(const dynamic_reconfigure::Config& message, Config config) {
  visitParameters(config, MessageReader{message});
  return config;
}

}  // namespace objectness_segmentation
