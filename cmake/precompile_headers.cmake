# SPDX-License-Identifier: BSD-3-Clause
# Three quarters of a compile are these libraries' headers: they are parsed once a library or test. A source still
# includes whatever it uses; the build with link-time optimization (CONTRIBUTING.md) is one without.
option(PRECOMPILE_HEADERS "parse the headers of Eigen, OpenCV, ROS and GoogleTest once a target" ON)
set(CORE_HEADERS <algorithm> <cmath> <map> <optional> <sstream> <string> <vector> <Eigen/Geometry> <opencv2/core.hpp>
  <opencv2/imgproc.hpp>)
set(ROS_HEADERS ${CORE_HEADERS} <ros/ros.h> <sensor_msgs/CameraInfo.h> <sensor_msgs/Image.h> <sensor_msgs/PointCloud2.h>
  <visualization_msgs/MarkerArray.h>)
set(TEST_HEADERS <gtest/gtest.h> <nlohmann/json.hpp> <filesystem> <fstream> <random>)

# precompile_headers(TARGET HEADER...)
function(precompile_headers target)
  if(PRECOMPILE_HEADERS)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()
