// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

namespace objectness_test {

/// `roslaunch objectness_segmentation ARGUMENTS` with the master of the test, in a namespace. Ends with this.
class LaunchProcess {
 public:
  LaunchProcess(const std::string& name_space, const std::string& arguments) {
    const std::string command = "exec roslaunch objectness_segmentation " + arguments;
    process_ = fork();
    if (process_ == 0) {
      setpgid(0, 0);
      setenv("ROS_NAMESPACE", name_space.c_str(), 1);
      execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
      _exit(127);
    }
  }
  ~LaunchProcess() {
    if (process_ <= 0) return;
    kill(process_, SIGINT);  // roslaunch ends its nodes, which have process groups of their own
    waitpid(process_, nullptr, 0);
  }
  LaunchProcess(const LaunchProcess&) = delete;
  LaunchProcess& operator=(const LaunchProcess&) = delete;

 private:
  pid_t process_ = -1;
};

}  // namespace objectness_test
