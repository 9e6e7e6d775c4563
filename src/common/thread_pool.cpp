// SPDX-License-Identifier: BSD-3-Clause
#include "common/thread_pool.hpp"

#include <algorithm>
#include <chrono>
#include <system_error>

namespace objectness {
namespace {

thread_local ThreadPool* current_pool = nullptr;
thread_local bool helping = false;

/// Looks out for what a sleeping thread would be woken up for. Others that have work come first.
template <class Condition>
void lookOut(Condition&& happened) {
  constexpr auto kWhile = std::chrono::microseconds(100);
  const auto end = std::chrono::steady_clock::now() + kWhile;
  while (!happened() && std::chrono::steady_clock::now() < end) std::this_thread::yield();
}

}  // namespace

ThreadPool* ThreadPool::current() { return current_pool; }

bool ThreadPool::isHelping() { return helping; }

int ThreadPool::resolve(int threads) {
  return threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

ThreadPool::ThreadPool(int threads) : outer_(current_pool) {
  try {
    for (int i = 1; i < resolve(threads); ++i) helpers_.emplace_back([this] { help(); });
  } catch (const std::system_error&) {
    // No more threads to be had: those that started and the caller do the work.
  }
  current_pool = this;
}

ThreadPool::~ThreadPool() {
  current_pool = outer_;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  for (auto& helper : helpers_) helper.join();
}

void ThreadPool::work() {
  const bool was_helping = helping;
  helping = true;
  try {
    for (int i = next_++; i < count_ && !failed_; i = next_++) (*call_)(i);
  } catch (...) {
    if (!failed_.exchange(true)) failure_ = std::current_exception();
  }
  helping = was_helping;
}

void ThreadPool::run(int count, int threads, const std::function<void(int)>& call) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    call_ = &call;
    count_ = count;
    next_ = 0;
    failed_ = false;
    failure_ = nullptr;
    wanted_ = std::min({threads - 1, count - 1, static_cast<int>(helpers_.size())});
    ++job_;
  }
  wake_.notify_all();
  work();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    wanted_ = 0;  // who has not come yet is not needed any more
  }
  lookOut([this] { return running_ == 0; });
  std::unique_lock<std::mutex> lock(mutex_);
  done_.wait(lock, [this] { return running_ == 0; });
  if (failure_) std::rethrow_exception(failure_);
}

void ThreadPool::help() {
  unsigned seen = 0;
  for (;;) {
    lookOut([&] { return stop_ || job_ != seen; });
    std::unique_lock<std::mutex> lock(mutex_);
    if (job_ != seen && wanted_ == 0) {  // a job that has no need of this thread
      seen = job_;
      continue;
    }
    wake_.wait(lock, [&] { return stop_ || (job_ != seen && wanted_ > 0); });
    if (stop_) return;
    seen = job_;
    --wanted_;
    ++running_;
    lock.unlock();
    work();
    lock.lock();
    if (--running_ == 0) done_.notify_all();
  }
}

}  // namespace objectness
