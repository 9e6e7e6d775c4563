// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/config.hpp"

#include <dynamic_reconfigure/Config.h>
#include <ros/node_handle.h>

#include <string>
#include <vector>

namespace objectness_segmentation {

/// The core's configuration as ROS parameters. Everything is derived from the fields() lists: the parameter of field
/// "group.field" is "group_field" (~objectness_weight_edges).

/// Fields of the group "runtime" are read once, at the start; all others can be changed between frames.
bool isReconfigurable(const std::string& group);

/// Calls visit(group, parameter name, field, Range, description) for each field in order; without the Range for bools.
template <class AnyConfig, class Visit>
void visitParameters(AnyConfig& config, Visit&& visit) {
  objectness::Config::groups(config, [&visit](const std::string& group, auto& stage) {
    std::decay_t<decltype(stage)>::fields(stage, [&](const char* field, auto& value, const auto&... range_and_description) {
      visit(group, group + "_" + field, value, range_and_description...);
    });
  });
}

/// What was read from the parameter server, and a sentence for each parameter that could not be used.
struct ReadParameters {
  objectness::Config config;
  std::vector<std::string> problems;
};

/// Reads the parameters below nh: "group/field" as a preset of the file tool gives them, over it "group_field". A value of
/// the wrong type or out of range is a problem and leaves the default, a contradiction between values leaves all defaults;
/// a name that is no parameter (but in `others`) is a problem too.
ReadParameters readParameters(const ros::NodeHandle& nh, const std::vector<std::string>& others);

/// Writes the reconfigurable fields below nh, where the dynamic_reconfigure server of the same nh finds them.
void writeReconfigurable(const objectness::Config& config, const ros::NodeHandle& nh);

/// The reconfigurable fields as dynamic_reconfigure sends them, and back (other fields keep their values).
dynamic_reconfigure::Config toReconfigureMessage(const objectness::Config& config);
objectness::Config fromReconfigureMessage(const dynamic_reconfigure::Config& message, objectness::Config config);

}  // namespace objectness_segmentation
