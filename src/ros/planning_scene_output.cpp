// SPDX-License-Identifier: BSD-3-Clause
// Built only where moveit_msgs is found.
#include "ros/planning_scene_output.hpp"

#include <moveit_msgs/PlanningScene.h>

#include "objectness_segmentation/ros/output_conversions.hpp"
#include "objectness_segmentation/ros/topics.hpp"
#include "ros/geometry_output.hpp"

namespace objectness_segmentation {
namespace {

using moveit_msgs::CollisionObject;

/// Newer messages have a pose of the object that its parts are relative to.
template <class Object>
auto setNeutralPose(Object& object, int) -> decltype(object.pose, void()) {
  object.pose.orientation.w = 1;
}
template <class Object>
void setNeutralPose(Object&, long) {}

CollisionObject makeObject(const std::string& id, const std_msgs::Header& header, int operation) {
  CollisionObject object;
  object.header = header;
  object.id = id;
  setNeutralPose(object, 0);
  object.operation = static_cast<decltype(object.operation)>(operation);
  return object;
}

}  // namespace

void PlanningSceneOutput::advertise(ros::NodeHandle& nh, bool latch, const ros::SubscriberStatusCallback& changed) {
  publisher_ = nh.advertise<moveit_msgs::PlanningScene>(topics::kPlanningScene, kPublisherQueueSize, changed, changed,
                                                        {}, latch);
}

void PlanningSceneOutput::publish(const SegmentedFrame& result, const std_msgs::Header& header) {
  if (!haveSubscribers()) return;
  if (!result.segmentation.status.ok()) return;  // a frame that shows nothing is no reason to forget obstacles
  moveit_msgs::PlanningScene scene;
  scene.is_diff = true;
  scene.robot_state.is_diff = true;
  std::set<std::string> gone;
  gone.swap(shown_);
  for (std::size_t rank = 0; rank < result.segmentation.segments.size(); ++rank) {
    const objectness::Segment& segment = result.segmentation.segments[rank];
    const std::string id = "object_" + std::to_string(identityOf(result, rank).label);
    CollisionObject object = makeObject(id, header, CollisionObject::ADD);
    shape_msgs::SolidPrimitive box;
    box.type = shape_msgs::SolidPrimitive::BOX;
    box.dimensions = {segment.box.size_m.x(), segment.box.size_m.y(), segment.box.size_m.z()};
    object.primitives.push_back(box);
    object.primitive_poses.push_back(toPose(segment.box.T_camera_box));
    scene.world.collision_objects.push_back(object);
    gone.erase(id);
    shown_.insert(id);
  }
  for (const std::string& id : gone) {
    scene.world.collision_objects.push_back(makeObject(id, header, CollisionObject::REMOVE));
  }
  publisher_.publish(scene);
}

}  // namespace objectness_segmentation
