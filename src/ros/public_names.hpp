// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/names.h>
#include <ros/node_handle.h>
#include <ros/this_node.h>

#include <string>

namespace objectness_segmentation {

// Public names of a nodelet lie in the namespace of its own name, whichever its manager has. Its getNodeHandle() does
// not hold to that: roscpp takes a handle of "/" for one without a namespace, and puts relative names into the
// namespace of the process, which is the manager's.

/// A name, before remapping, as an absolute one.
inline std::string publicName(const ros::NodeHandle& private_nh, const std::string& name) {
  return ros::names::resolve(ros::names::parentNamespace(private_nh.getNamespace()), name, false);
}

/// A handle for absolute names, with the remappings that the nodelet was loaded with. Its manager has put relative ones
/// that came by its service, and not by the `nodelet` tool, into the manager's namespace: they hold for the name all
/// the same, where nothing else does.
inline ros::NodeHandle publicHandle(const ros::NodeHandle& private_nh, const ros::M_string& remappings) {
  const std::string& own = ros::this_node::getNamespace();
  const std::string of_process = own == "/" ? own : own + "/";
  ros::M_string absolute;
  for (const auto& [from, to] : remappings) absolute[ros::names::resolve(from, false)] = to;
  for (const auto& [from, to] : ros::M_string(absolute)) {
    if (from.compare(0, of_process.size(), of_process) != 0) continue;
    absolute.emplace(publicName(private_nh, from.substr(of_process.size())), to);
  }
  ros::NodeHandle nh("/", absolute);
  nh.setCallbackQueue(private_nh.getCallbackQueue());
  return nh;
}

}  // namespace objectness_segmentation
