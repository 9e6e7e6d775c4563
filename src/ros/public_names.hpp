// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/names.h>
#include <ros/node_handle.h>

#include <string>

namespace objectness_segmentation {

// Public names of a nodelet lie in the namespace of its own name, whichever its manager has. Its getNodeHandle() does
// not hold to that: roscpp takes a handle of "/" for one without a namespace, and puts relative names, also those of
// remappings, into the namespace of the process, which is the manager's.

/// A name, before remapping, as an absolute one.
inline std::string publicName(const ros::NodeHandle& private_nh, const std::string& name) {
  return ros::names::resolve(ros::names::parentNamespace(private_nh.getNamespace()), name, false);
}

/// A handle for absolute names, with the remappings that the nodelet was loaded with.
inline ros::NodeHandle publicHandle(const ros::NodeHandle& private_nh, const ros::M_string& remappings) {
  ros::M_string absolute;
  for (const auto& [from, to] : remappings) absolute[publicName(private_nh, from)] = publicName(private_nh, to);
  ros::NodeHandle nh("/", absolute);
  nh.setCallbackQueue(private_nh.getCallbackQueue());
  return nh;
}

}  // namespace objectness_segmentation
