// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>
#include <vector>

namespace objectness_test {

/// `rosbag play` as a process of its own. It waits for a subscriber to every topic it plays, and is ended with this.
class BagPlayer {
 public:
  explicit BagPlayer(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"rosbag", "play", "--quiet", "--wait-for-subscribers"});
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(&argument[0]);
    argv.push_back(nullptr);
    process_ = fork();
    if (process_ == 0) {
      setpgid(0, 0);  // rosbag is a script that starts the player
      execvp(argv[0], argv.data());
      _exit(127);
    }
    setpgid(process_, process_);
  }
  ~BagPlayer() {
    if (process_ <= 0) return;
    kill(-process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  BagPlayer(const BagPlayer&) = delete;
  BagPlayer& operator=(const BagPlayer&) = delete;

  bool running() {
    if (process_ > 0 && waitpid(process_, nullptr, WNOHANG) == process_) process_ = -1;
    return process_ > 0;
  }

 private:
  pid_t process_ = -1;
};

}  // namespace objectness_test
