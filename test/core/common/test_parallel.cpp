// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include "common/parallel.hpp"

using objectness::parallelFor;
using objectness::ThreadPool;

TEST(ParallelFor, CallsEachIndexOnce) {
  for (const int threads : {0, 1, 2, 7}) {
    std::vector<int> calls(100, 0);
    parallelFor(100, threads, [&](int i) { ++calls[i]; });
    EXPECT_EQ(std::accumulate(calls.begin(), calls.end(), 0), 100);
    EXPECT_EQ(*std::max_element(calls.begin(), calls.end()), 1);
  }
  parallelFor(0, 2, [](int) { FAIL(); });
}

TEST(ParallelFor, RethrowsAndJoins) {
  std::atomic<int> calls{0};
  EXPECT_THROW(parallelFor(50, 2,
                           [&](int i) {
                             ++calls;
                             if (i == 3) throw std::runtime_error("stop");
                           }),
               std::runtime_error);
  EXPECT_GE(calls, 4);
}

namespace {

int threadsOfThisProcess() {
  int threads = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task")) threads += entry.is_directory();
  return threads;
}

}  // namespace

TEST(ThreadPool, OneJobAfterTheOtherOnTheSameThreads) {
  const int before = threadsOfThisProcess();
  {
    ThreadPool pool(4);
    EXPECT_EQ(threadsOfThisProcess(), before + 3);
    EXPECT_EQ(ThreadPool::current(), &pool);
    for (int job = 0; job < 2000; ++job) {
      std::vector<int> calls(job % 40, 0);
      parallelFor(static_cast<int>(calls.size()), 1 + job % 6, [&](int i) { ++calls[i]; });
      ASSERT_EQ(std::count(calls.begin(), calls.end(), 1), static_cast<long>(calls.size())) << "job " << job;
    }
    EXPECT_EQ(threadsOfThisProcess(), before + 3) << "no thread of its own for any of the jobs";
  }
  EXPECT_EQ(ThreadPool::current(), nullptr);
  // A thread that was joined may be listed for a moment longer.
  for (int wait = 0; wait < 1000 && threadsOfThisProcess() != before; ++wait) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_EQ(threadsOfThisProcess(), before) << "no thread is left behind";
}

TEST(ThreadPool, UsesNoMoreThreadsThanAsked) {
  ThreadPool pool(4);
  std::mutex mutex;
  std::set<std::thread::id> seen;
  for (int job = 0; job < 50; ++job) {
    parallelFor(64, 2, [&](int) {
      const std::lock_guard<std::mutex> lock(mutex);
      seen.insert(std::this_thread::get_id());
    });
    ASSERT_LE(seen.size(), 2u);
    seen.clear();
  }
}

TEST(ThreadPool, CallsWithinCallsAreDoneAlone) {
  ThreadPool pool(3);
  std::vector<int> calls(12 * 7, 0);
  parallelFor(12, 3, [&](int i) {
    const std::thread::id mine = std::this_thread::get_id();
    parallelFor(7, 3, [&](int k) {
      EXPECT_EQ(std::this_thread::get_id(), mine);
      ++calls[i * 7 + k];
    });
  });
  EXPECT_EQ(std::count(calls.begin(), calls.end(), 1), 12 * 7);
}

TEST(ThreadPool, AnExceptionLeavesThePoolUsable) {
  ThreadPool pool(3);
  for (int round = 0; round < 20; ++round) {
    EXPECT_THROW(parallelFor(100, 3,
                             [](int i) {
                               if (i == 50) throw std::runtime_error("fifty");
                             }),
                 std::runtime_error);
    std::atomic<int> calls{0};
    parallelFor(100, 3, [&](int) { ++calls; });
    EXPECT_EQ(calls, 100);
  }
}

TEST(ParallelFor, DoesTwoThingsAtOnceOrOneAfterTheOther) {
  for (const int threads : {1, 2, 4}) {
    const ThreadPool pool(threads);
    std::atomic<int> first{0}, second{0}, nested{0};
    objectness::inParallel(
        threads, [&] { first += 1, parallelFor(10, threads, [&](int) { ++nested; }); }, [&] { second += 10; });
    EXPECT_EQ(first, 1);
    EXPECT_EQ(second, 10);
    EXPECT_EQ(nested, 10);
    EXPECT_THROW(objectness::inParallel(
                     threads, [] {}, [] { throw std::runtime_error("second"); }),
                 std::runtime_error);
  }
}

TEST(ThreadPool, LoopsThatFollowAtAnyTimeUseIt) {
  // Shorter than a thread looks out, about as long, and longer: it sleeps, wakes, or has not slept.
  const ThreadPool pool(3);
  for (const int pause_us : {0, 20, 90, 100, 110, 150, 400}) {
    for (int loop = 0; loop < 50; ++loop) {
      std::vector<int> calls(loop % 7, 0);
      parallelFor(static_cast<int>(calls.size()), 1 + loop % 4, [&](int i) { ++calls[i]; });
      ASSERT_TRUE(std::all_of(calls.begin(), calls.end(), [](int count) { return count == 1; }));
      std::this_thread::sleep_for(std::chrono::microseconds(pause_us));
    }
  }
}
