// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace objectness {

/// The set bits of `words` words.
int countBits(const std::uint64_t* set, std::size_t words);

/// The bits set in both.
int countCommonBits(const std::uint64_t* a, const std::uint64_t* b, std::size_t words);

}  // namespace objectness
