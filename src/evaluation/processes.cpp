// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/processes.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <map>

namespace objectness::evaluation {
namespace {

enum ChildStatus { kWorked = 0, kThrew = 1 };

[[noreturn]] void runChild(pid_t parent, const std::function<void(int)>& work, int index) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(kThrew);  // it died before it could be watched
  // What libraries print must not tear the parent's progress line apart.
  const int nowhere = open("/dev/null", O_WRONLY);
  if (nowhere >= 0) {
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
  }
  try {
    work(index);
  } catch (...) {
    _exit(kThrew);
  }
  _exit(kWorked);  // no destructors of what belongs to the parent
}

std::string failureText(int status) {
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    const std::string text = "was killed by signal " + std::to_string(signal) + " (" + strsignal(signal) + ")";
    return signal == SIGKILL ? text + ": out of memory?" : text;
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == kWorked) return "";
  return WIFEXITED(status) && WEXITSTATUS(status) != kThrew
             ? "ended by itself with exit status " + std::to_string(WEXITSTATUS(status))
             : "threw an exception";
}

}  // namespace

void forEachInProcess(int count, int jobs, const std::function<void(int)>& work,
                      const std::function<void(int, const std::string&)>& done) {
  std::map<pid_t, int> running;
  const auto waitForOne = [&] {
    int status = 0;
    const pid_t pid = waitpid(-1, &status, 0);
    const auto ended = running.find(pid);
    if (ended == running.end()) return pid >= 0 || errno == EINTR;
    const int index = ended->second;
    running.erase(ended);
    done(index, failureText(status));
    return true;
  };
  const pid_t self = getpid();
  for (int i = 0; i < count;) {
    if (static_cast<int>(running.size()) >= jobs) {
      waitForOne();
      continue;
    }
    const pid_t pid = fork();
    if (pid == 0) runChild(self, work, i);
    if (pid > 0) {
      running[pid] = i++;
    } else if (running.empty()) {
      done(i++, std::string("could not be started: ") + std::strerror(errno));
    } else {
      waitForOne();  // no more processes to be had for now
    }
  }
  while (!running.empty() && waitForOne()) {
  }
}

}  // namespace objectness::evaluation
