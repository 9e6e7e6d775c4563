// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <rosgraph_msgs/Log.h>

#include <algorithm>
#include <string>
#include <vector>

namespace objectness_test {

/// The warnings and errors of all nodes, from its making on.
class LogListener {
 public:
  LogListener() {
    subscriber_ = ros::NodeHandle().subscribe<rosgraph_msgs::Log>("/rosout", 1000,
                                                                  [this](const rosgraph_msgs::LogConstPtr& line) {
                                                                    if (line->level >= rosgraph_msgs::Log::WARN)
                                                                      lines_.push_back(line->msg);
                                                                  });
  }
  LogListener(const LogListener&) = delete;
  LogListener& operator=(const LogListener&) = delete;

  bool connected() const { return subscriber_.getNumPublishers() > 1; }  // the test itself is one
  /// Lines that hold the text.
  long count(const std::string& text) const {
    return std::count_if(lines_.begin(), lines_.end(),
                         [&](const std::string& line) { return line.find(text) != std::string::npos; });
  }

 private:
  ros::Subscriber subscriber_;
  std::vector<std::string> lines_;
};

}  // namespace objectness_test
