// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nodelet/NodeletLoad.h>
#include <nodelet/NodeletUnload.h>
#include <ros/ros.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "process_state.hpp"

namespace objectness_test {

/// ROS's own nodelet manager, in a process that the test starts and may end.
class ManagerProcess {
 public:
  explicit ManagerProcess(const std::string& name) : name_(name) {
    const char* prefix = std::getenv("OBJECTNESS_MANAGER_PREFIX");  // of a sanitizer
    const std::string command =
        "exec " + std::string(prefix ? prefix : "") + " " NODELET_EXECUTABLE " manager __name:=" + name.substr(1);
    process_ = fork();
    if (process_ == 0) {
      execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
      _exit(127);
    }
    up_ = ros::service::waitForService(name_ + "/load_nodelet", ros::Duration(60));
  }
  ~ManagerProcess() {
    if (exited()) return;
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  ManagerProcess(const ManagerProcess&) = delete;
  ManagerProcess& operator=(const ManagerProcess&) = delete;

  bool up() const { return up_; }
  bool load(const std::string& nodelet) {
    nodelet::NodeletLoad load;
    load.request.name = nodelet;
    load.request.type = "objectness_segmentation/SegmentObjects";
    return ros::service::call(name_ + "/load_nodelet", load) && load.response.success;
  }
  bool unload(const std::string& nodelet) {
    nodelet::NodeletUnload unload;
    unload.request.name = nodelet;
    return ros::service::call(name_ + "/unload_nodelet", unload) && unload.response.success;
  }
  long threads() const { return threadCount(process_); }
  long residentKb() const { return objectness_test::residentKb(process_); }

  /// Seconds until the process has ended after a signal, at most `limit`.
  double end(int signal, double limit) {
    const ros::WallTime start = ros::WallTime::now();
    const auto elapsed = [&] { return (ros::WallTime::now() - start).toSec(); };
    kill(process_, signal);
    while (!exited() && elapsed() < limit) ros::WallDuration(0.002).sleep();
    return elapsed();
  }
  bool exited() {
    if (!ended_ && waitpid(process_, &status_, WNOHANG) == process_) ended_ = true;
    return ended_;
  }
  /// By itself with status 0, or by the signal that was sent.
  bool endedCleanly(int signal) const {
    return ended_ &&
           ((WIFEXITED(status_) && WEXITSTATUS(status_) == 0) || (WIFSIGNALED(status_) && WTERMSIG(status_) == signal));
  }

 private:
  std::string name_;
  pid_t process_ = -1;
  bool up_ = false, ended_ = false;
  int status_ = 0;
};

}  // namespace objectness_test
