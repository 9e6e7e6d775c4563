// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/thread_pool.hpp"

namespace objectness {

/// Calls work(i) for i = 0..count-1 on up to `threads` threads, the caller's included; 0: one per processor. They are
/// those of the ThreadPool that the calling thread has, otherwise threads that end with the call. The order is not
/// fixed, so work(i) writes only to what belongs to i. The first exception is rethrown when no call runs any more.
template <class Work>
void parallelFor(int count, int threads, Work&& work) {
  threads = ThreadPool::resolve(threads);
  if (threads == 1 || count <= 1 || ThreadPool::isHelping()) {
    for (int i = 0; i < count; ++i) work(i);
  } else if (ThreadPool* pool = ThreadPool::current()) {
    pool->run(count, threads, [&work](int i) { work(i); });
  } else {
    ThreadPool(threads < count ? threads : count).run(count, threads, [&work](int i) { work(i); });
  }
}

/// Calls both, at once when there are threads for it.
template <class First, class Second>
void inParallel(int threads, First&& first, Second&& second) {
  parallelFor(2, threads, [&](int i) { i == 0 ? first() : second(); });
}

}  // namespace objectness
