// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "objectness_segmentation/config.hpp"

namespace objectness {

/// One field of a Config, as YAML presets, `--set` and validate() see it.
struct ConfigField {
  std::string group;  ///< "search"
  std::string name;   ///< "angle_step_deg"
  std::variant<double*, int*, bool*, SegmentationMethod*> value;
  Range range{0, 1};
  const char* description = "";

  std::string fullName() const { return group + "." + name; }
};

namespace detail {

struct FieldCollector {
  std::vector<ConfigField>& fields;
  const char* group;

  template <class T>
  void operator()(const char* name, T& value, const Range& range, const char* description) const {
    fields.push_back({group, name, &value, range, description});
  }
  void operator()(const char* name, bool& value, const char* description) const {
    fields.push_back({group, name, &value, Range{0, 1}, description});
  }
  void operator()(const char* name, SegmentationMethod& value, const char* description) const {
    fields.push_back({group, name, &value, Range{0, kMethodNames.size() - 1.0}, description});
  }
};

}  // namespace detail

/// All fields in the order of the structs. They point into `config`, which must outlive them and stay where it is.
inline std::vector<ConfigField> configFields(Config& config) {
  std::vector<ConfigField> fields;
  Config::groups(config, [&](const char* group, auto& stage) {
    std::decay_t<decltype(stage)>::fields(stage, detail::FieldCollector{fields, group});
  });
  return fields;
}

}  // namespace objectness
