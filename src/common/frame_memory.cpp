// SPDX-License-Identifier: BSD-3-Clause
#include "common/frame_memory.hpp"

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>
#endif

namespace objectness {

void keepFrameMemory() {
#ifdef __GLIBC__
  constexpr std::size_t kMegabyte = 1 << 20;
  constexpr std::size_t kPage = 4096;
  // The largest blocks that glibc lets come from the heap, and more than the buffers of any frame together.
  constexpr std::size_t kLargestBlock = 32 * kMegabyte, kKept = 512 * kMegabyte;
  constexpr std::size_t kBlock = 24 * kMegabyte;
  mallopt(M_MMAP_THRESHOLD, kLargestBlock);
  mallopt(M_TRIM_THRESHOLD, kKept);
  // The main thread only: the heaps of others are small, and with large pages a process grows with every thread that
  // comes and goes.
  if (getpid() != static_cast<pid_t>(syscall(SYS_gettid))) return;
  // The heap grows by blocks that are freed at once: addresses only, until a frame touches them.
  void* blocks[3];
  for (void*& block : blocks) {
    block = std::malloc(kBlock);
    if (!block) continue;
    const std::uintptr_t first = (reinterpret_cast<std::uintptr_t>(block) + kPage - 1) / kPage * kPage;
    madvise(reinterpret_cast<void*>(first), kBlock - kPage, MADV_HUGEPAGE);  // refused: small pages, as before
  }
  for (void* block : blocks) std::free(block);
#endif
}

void returnFrameMemory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace objectness
