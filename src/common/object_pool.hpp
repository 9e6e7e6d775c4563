// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace objectness {

/// What calls of a parallelFor() need each for itself but may take over from one another: made when there is none to
/// spare, so that there are no more than threads. Thread safe.
template <class T>
class ObjectPool {
 public:
  std::unique_ptr<T> take() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (spare_.empty()) return std::make_unique<T>();
    std::unique_ptr<T> taken = std::move(spare_.back());
    spare_.pop_back();
    return taken;
  }
  void put(std::unique_ptr<T> spare) {
    const std::lock_guard<std::mutex> lock(mutex_);
    spare_.push_back(std::move(spare));
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<T>> spare_;
};

}  // namespace objectness
