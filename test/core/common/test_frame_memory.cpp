// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstddef>
#include <thread>
#include <vector>

#include "common/frame_memory.hpp"

using namespace objectness;

namespace {

constexpr std::size_t kPage = 4096, kPages = 1024, kBuffers = 8;

long faultsOfThread() {
  rusage usage{};
  getrusage(RUSAGE_THREAD, &usage);
  return usage.ru_minflt;
}

/// 32 MB, as a frame takes and frees them.
void useBuffers() {
  std::vector<std::vector<char>> buffers;
  for (std::size_t i = 0; i < kBuffers; ++i) buffers.emplace_back(kPages * kPage, 1);
}

}  // namespace

TEST(FrameMemory, ServesTheNextFrame) {
#if !defined(__GLIBC__) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "memory is not glibc's to keep";
#endif
  for (const bool main_thread : {true, false}) {
    long faults = 0;
    const auto frames = [&] {
      keepFrameMemory();
      useBuffers();
      const long before = faultsOfThread();
      for (int frame = 0; frame < 5; ++frame) useBuffers();
      faults = faultsOfThread() - before;
    };
    if (main_thread) {
      frames();
    } else {
      std::thread(frames).join();
    }
    EXPECT_LT(faults, 100) << "of " << 5 * kBuffers * kPages << (main_thread ? ", main thread" : ", another thread");
  }
}
