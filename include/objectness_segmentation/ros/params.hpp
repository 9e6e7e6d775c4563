// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dynamic_reconfigure/Config.h>
#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "objectness_segmentation/former_parameters.hpp"

namespace objectness_segmentation {

/// The core's configuration as ROS parameters, all derived from its list of fields.

/// "objectness_weight_edges" for field weight_edges of group objectness.
std::string parameterName(const objectness::ConfigField& field);

/// Fields of the group "runtime" are read once, at the start; all others can be changed between frames.
bool isReconfigurable(const objectness::ConfigField& field);

/// What was read from the parameter server, and a sentence for each parameter that could not be used.
struct ReadParameters {
  objectness::Config config;
  std::vector<std::string> problems;
};

/// Reads the parameters below nh: "group/field" as a preset of the file tool gives them, over it "group_field". A value
/// of the wrong type or out of range is a problem and leaves the default, a contradiction between values leaves all
/// defaults; a name that is no parameter (nor in `others`) or one of an earlier version is a problem too.
ReadParameters readParameters(const ros::NodeHandle& nh, const std::vector<std::string>& others);

/// Writes the reconfigurable fields below nh, where the dynamic_reconfigure server of the same nh finds them.
void writeReconfigurable(objectness::Config config, const ros::NodeHandle& nh);

/// The reconfigurable fields as dynamic_reconfigure sends them, and back (other fields keep their values).
dynamic_reconfigure::Config toReconfigureMessage(objectness::Config config);
objectness::Config fromReconfigureMessage(const dynamic_reconfigure::Config& message, objectness::Config config);

}  // namespace objectness_segmentation
