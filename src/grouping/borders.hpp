// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "grouping/pieces.hpp"

namespace objectness {

// Lengths are Manhattan steps along rows and columns, each as long as a pixel there: up to sqrt(2) too long for an
// oblique line. All cues of lengths are ratios, and the model was trained on these.

/// What the outline of a piece lies against, each a length on the surface in metres.
struct Outline {
  float table = 0;    ///< it stands on the table, or goes on as table
  float front = 0;    ///< it is in front of something that is no piece (the table behind it, the wall)
  float behind = 0;   ///< it is behind something that is no piece
  float unknown = 0;  ///< missing depth on and on
  float outside = 0;  ///< the border of the picture
  float pieces = 0;   ///< any other piece

  float total() const { return table + front + behind + unknown + outside + pieces; }
};

/// Pixels of two pieces next to each other, in the image and in space.
struct ContactSample {
  int first, second;
};

/// The common border of two pieces, first < second.
struct PairBorder {
  float contact = 0;  ///< lengths in metres
  float first_in_front = 0;
  float second_in_front = 0;
  std::vector<ContactSample> samples;  ///< of the contact

  float total() const { return contact + first_in_front + second_in_front; }
};

struct Borders {
  std::vector<Outline> outlines;                    ///< one per piece
  std::map<std::pair<int, int>, PairBorder> pairs;  ///< ordered, so that all that follows is deterministic
};

/// Walks along rows and columns from every pixel of a piece to the next valid pixel (a few missing ones are stepped
/// over) and notes what lies there.
Borders findBorders(const Frame& frame, const ObjectPoints& object_points, const Pieces& pieces);

}  // namespace objectness
