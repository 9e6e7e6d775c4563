// SPDX-License-Identifier: BSD-3-Clause
#include "peak_memory.hpp"

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <new>

#include "evaluation/processes.hpp"

namespace objectness::benchmarks {
namespace {

/// Numbers that forked processes write and this one reads.
class SharedNumbers {
 public:
  explicit SharedNumbers(std::size_t count)
      : bytes_(count * sizeof(double)),
        memory_(mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
    if (memory_ == MAP_FAILED) throw std::bad_alloc();
  }
  ~SharedNumbers() { munmap(memory_, bytes_); }
  SharedNumbers(const SharedNumbers&) = delete;
  SharedNumbers& operator=(const SharedNumbers&) = delete;

  double& operator[](std::size_t i) { return static_cast<double*>(memory_)[i]; }

 private:
  std::size_t bytes_;
  void* memory_;
};

std::string nameOf(const FrameMethod& method) { return method.name + "/" + method.volume; }

std::string keyOf(const BenchmarkScene& scene, const FrameMethod& method) {
  return nameOf(method) + "/" + scene.source.name;
}

/// The peak of this program, run anew with --alone; 0 when that fails.
double peakMib(const BenchmarkScene& scene, const FrameMethod& method) {
  const std::string name = nameOf(method);
  const pid_t pid = fork();
  if (pid == 0) {
    execl("/proc/self/exe", "benchmark_objectness", "--alone", name.c_str(), scene.source.folder.c_str(), nullptr);
    _exit(1);
  }
  int status = 0;
  rusage usage{};
  if (pid < 0 || wait4(pid, &status, 0, &usage) != pid || !WIFEXITED(status) || WEXITSTATUS(status) != 0) return 0;
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

}  // namespace

void PeakMemory::measure(const std::vector<BenchmarkScene>& scenes, const std::vector<FrameMethod>& methods) {
  std::vector<std::pair<const BenchmarkScene*, const FrameMethod*>> jobs;
  for (const BenchmarkScene& scene : scenes) {
    for (const FrameMethod& method : methods) {
      if (!method.is_baseline) jobs.emplace_back(&scene, &method);
    }
  }
  if (jobs.empty()) return;
  SharedNumbers peak(jobs.size());
  const auto work = [&](int i) { peak[i] = peakMib(*jobs[i].first, *jobs[i].second); };
  const auto done = [&](int i, const std::string& failure) {
    if (failure.empty()) mib_[keyOf(*jobs[i].first, *jobs[i].second)] = peak[i];
  };
  evaluation::forEachInProcess(static_cast<int>(jobs.size()), kThreads, work, done);
}

double PeakMemory::mib(const BenchmarkScene& scene, const FrameMethod& method) const {
  const auto found = mib_.find(keyOf(scene, method));
  return found == mib_.end() ? 0 : found->second;
}

bool runAlone(const std::string& method, const BenchmarkScene& scene) {
  for (const FrameMethod& known : frameMethods()) {
    if (nameOf(known) == method) return known.run(frameOf(scene)).status.ok();
  }
  return false;
}

}  // namespace objectness::benchmarks
