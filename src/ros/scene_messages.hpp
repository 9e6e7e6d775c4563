// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

#include <Eigen/Geometry>
#include <string>

#include "objectness_segmentation/scene/frame.hpp"

namespace objectness_segmentation {

/// What a camera driver sends, made from a frame.

/// Organized, x y z and, when the frame has colours, rgb.
sensor_msgs::PointCloud2 toCloudMessage(const objectness::Frame& frame, const std_msgs::Header& header);

/// The camera of a rectified image.
sensor_msgs::CameraInfo toCameraInfo(const objectness::PinholeCamera& camera, const std_msgs::Header& header);

/// bgr8
sensor_msgs::Image toImageMessage(const cv::Mat_<cv::Vec3b>& image, const std_msgs::Header& header);

/// 16UC1
sensor_msgs::Image toImageMessage(const cv::Mat_<ushort>& image, const std_msgs::Header& header);

/// Maps points of child_frame to those of header.frame_id.
geometry_msgs::TransformStamped toTransformMessage(const Eigen::Isometry3d& T_parent_child,
                                                   const std_msgs::Header& header, const std::string& child_frame);

/// From the optical frame (z forward) to the body frame it belongs to (x forward, z up), REP 103.
Eigen::Isometry3d opticalToBody();

}  // namespace objectness_segmentation
