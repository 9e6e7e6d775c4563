// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace objectness {

// Sets of points, one bit each, in up to 64 groups of `group_words` words; a mask has a bit for every group that is
// looked at. Plain types only: compiled for several instruction sets.

/// The points of a box: those before two faces, not before two others, and under the top. Only the groups of the mask
/// are written. Returns their number; groups: those of the mask that are not empty.
int intersectRows(const std::uint64_t* x_high, const std::uint64_t* x_low, const std::uint64_t* y_high,
                  const std::uint64_t* y_low, const std::uint64_t* z_high, std::uint64_t mask, int group_words,
                  std::uint64_t* points, std::uint64_t& groups);

/// The points in both sets.
int countCommon(const std::uint64_t* a, const std::uint64_t* b, std::uint64_t mask, int group_words);

/// Whether any point is in both.
bool haveCommon(const std::uint64_t* a, const std::uint64_t* b, std::uint64_t mask, int group_words);

/// A number for every point, as bit planes: plane b of `words` words holds bit b of all numbers.
struct Counters {
  const std::uint64_t* planes;
  int count;  ///< of planes
  int words;  ///< of a plane
};

/// The sets of points that are in no, one and two active boxes.
struct HeldSets {
  const std::uint64_t *none, *one, *two;
};

/// The words of the mask's groups of these sets, from the numbers of active boxes.
void findHeld(const Counters& held, std::uint64_t mask, int group_words, std::uint64_t* none, std::uint64_t* one,
              std::uint64_t* two);

/// How many points of a set are in no, one and two active boxes; unexplained: the sum of `beside` over those that are
/// in `exactly` (0 or 1) active boxes; shared: the groups with points in `exactly` + 1 of them.
struct HeldCounts {
  int none, one, two;
  long unexplained;
  std::uint64_t shared;
};
HeldCounts countHeld(const std::uint64_t* set, std::uint64_t mask, int group_words, const HeldSets& held,
                     const Counters& beside, int exactly);

/// The points in all three sets.
int countCommon(const std::uint64_t* a, const std::uint64_t* b, const std::uint64_t* c, std::uint64_t mask,
                int group_words);

/// Adds 1 to (takes 1 from) the numbers of a set's points. The planes must have room.
void increment(const std::uint64_t* set, std::uint64_t mask, int group_words, int count, int words,
               std::uint64_t* planes);
void decrement(const std::uint64_t* set, std::uint64_t mask, int group_words, int count, int words,
               std::uint64_t* planes);

}  // namespace objectness
