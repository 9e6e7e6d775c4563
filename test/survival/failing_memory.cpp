// SPDX-License-Identifier: BSD-3-Clause
#include "failing_memory.hpp"

#include <cstdlib>
#include <new>
#include <stdexcept>

namespace objectness_test {
namespace {

std::atomic<Failure> armed{Failure::kNone};
std::atomic<std::size_t> least{0};
std::atomic<int> left{0};
std::atomic<bool> others_only{false}, has_fired{false};
thread_local bool own_thread = false;

/// An exception is an allocation, too, but not one of operator new.
void failWhenDue(std::size_t bytes) {
  if (armed.load(std::memory_order_relaxed) == Failure::kNone || bytes < least || own_thread == others_only) return;
  if (left.fetch_sub(1) != 0) return;
  has_fired = true;
  switch (armed.exchange(Failure::kNone)) {
    case Failure::kBadAlloc:
      throw std::bad_alloc();
    case Failure::kException:
      throw std::runtime_error("injected");
    case Failure::kNoException:
      throw 42;
    case Failure::kNone:
      break;
  }
}

void* allocate(std::size_t bytes) {
  failWhenDue(bytes);
  void* memory = std::malloc(bytes == 0 ? 1 : bytes);
  if (!memory) throw std::bad_alloc();
  return memory;
}

}  // namespace

void FailingMemory::arm(Failure failure, std::size_t least_bytes, int passes, bool other_threads) {
  own_thread = true;
  others_only = other_threads;
  least = least_bytes;
  left = passes;
  has_fired = false;
  armed = failure;
}

void FailingMemory::disarm() { armed = Failure::kNone; }

bool FailingMemory::fired() { return has_fired; }

}  // namespace objectness_test

void* operator new(std::size_t bytes) { return objectness_test::allocate(bytes); }
void* operator new[](std::size_t bytes) { return objectness_test::allocate(bytes); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
