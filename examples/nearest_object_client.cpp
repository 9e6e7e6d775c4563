// SPDX-License-Identifier: BSD-3-Clause
// What a robot takes first: rosrun objectness_segmentation nearest_object_client [segment:=/segment_objects/segment]
// Has the next frame segmented by the service, and prints the box of the nearest object that carries no other one.
#include <objectness_segmentation/SegmentOnce.h>
#include <ros/ros.h>

#include <cmath>
#include <iostream>

using objectness_segmentation::SegmentedObject;
using objectness_segmentation::SegmentedObjectArray;

/// From the origin of the result's frame, metres: the camera, unless the nodelet has a ~target_frame.
double distance(const SegmentedObject& object) {
  const auto& centre = object.pose.position;
  return std::hypot(centre.x, centre.y, centre.z);
}

int main(int argc, char** argv) {
  ros::init(argc, argv, "nearest_object_client", ros::init_options::AnonymousName);
  ros::NodeHandle nh;
  auto client = nh.serviceClient<objectness_segmentation::SegmentOnce>("segment");
  objectness_segmentation::SegmentOnce call;
  call.request.timeout = 30;  // seconds
  if (!client.waitForExistence(ros::Duration(10)) || !client.call(call)) {
    return std::cerr << "no service " << client.getService() << ": is the nodelet running?\n", 1;
  }
  const SegmentedObjectArray& result = call.response.result;
  if (result.status != SegmentedObjectArray::OK) return std::cerr << result.message << '\n', 1;

  const SegmentedObject* nearest = nullptr;
  for (const SegmentedObject& object : result.objects) {
    if (!object.supports.empty()) continue;  // something stands on it
    if (!nearest || distance(object) < distance(*nearest)) nearest = &object;
  }
  if (!nearest) return std::cout << "no object on the table\n", 0;
  const auto& p = nearest->pose.position;
  const auto& size = nearest->dimensions;
  std::cout << "object " << nearest->label << " at " << p.x << ' ' << p.y << ' ' << p.z << " m in "
            << result.header.frame_id << ", " << size.x << " x " << size.y << " x " << size.z << " m\n";
}
