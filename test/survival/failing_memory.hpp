// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>

namespace objectness_test {

/// What operator new, which failing_memory.cpp replaces in the whole process, does in the place of an allocation.
enum class Failure { kNone, kBadAlloc, kException, kNoException };

/// Lets one allocation of `least_bytes` or more fail in any thread but the one that armed it, after `passes` that are
/// served as usual.
struct FailingMemory {
  static void arm(Failure failure, std::size_t least_bytes, int passes, bool other_threads);
  static void disarm();
  /// Has it failed since it was armed?
  static bool fired();
};

}  // namespace objectness_test
