// SPDX-License-Identifier: BSD-3-Clause
// The nodelet in a process of its own, for a debugger or profiler.
#include <nodelet/loader.h>
#include <ros/ros.h>

int main(int argc, char** argv) {
  ros::init(argc, argv, "segment_objects");
  nodelet::Loader loader;
  if (!loader.load(ros::this_node::getName(), "objectness_segmentation/SegmentObjects", ros::names::getRemappings(),
                   {})) {
    return 1;
  }
  ros::spin();
  return 0;
}
