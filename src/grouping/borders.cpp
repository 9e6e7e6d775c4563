// SPDX-License-Identifier: BSD-3-Clause
#include "grouping/borders.hpp"

#include <algorithm>
#include <cmath>

namespace objectness {
namespace {

constexpr float kMaxContact_m = 0.012;  // between neighbouring pixels, over missing ones too
constexpr float kMaxHole_m = 0.05;      // missing depth beside an outline: the shadow of the projector

class BorderWalk {
 public:
  BorderWalk(const Frame& frame, const ObjectPoints& object_points, const Pieces& pieces)
      : frame_(frame), object_points_(object_points), pieces_(pieces) {
    borders_.outlines.resize(pieces.count());
  }

  Borders run() {
    for (int v = 0; v < frame_.height(); ++v) {
      for (int u = 0; u < frame_.width(); ++u) {
        if (pieces_.label(v, u) < 0 || surrounded(u, v)) continue;
        walk(u, v, 1, 0);
        walk(u, v, -1, 0);
        walk(u, v, 0, 1);
        walk(u, v, 0, -1);
      }
    }
    return std::move(borders_);
  }

 private:
  /// Whether a pixel has nothing but its own piece beside it: most have.
  bool surrounded(int u, int v) const {
    if (u == 0 || v == 0 || u + 1 == frame_.width() || v + 1 == frame_.height()) return false;
    const int width = frame_.width();
    const int* label = &pieces_.label(v, u);
    return label[-1] == *label && label[1] == *label && label[-width] == *label && label[width] == *label;
  }

  /// From a pixel of a piece to the next valid one in a direction. Pairs of pieces are noted when seen from the first.
  void walk(int u, int v, int du, int dv) {
    const int pixel = v * frame_.width() + u, own = pieces_.label(v, u);
    const float z = frame_.points[pixel].z(), step_m = z / static_cast<float>(frame_.camera.focal());
    const int reach = 1 + static_cast<int>(kMaxHole_m / step_m);
    Outline& outline = borders_.outlines[own];
    int x = u + du, y = v + dv;
    for (int k = 1; k <= reach; ++k, x += du, y += dv) {
      if (x < 0 || y < 0 || x >= frame_.width() || y >= frame_.height()) {
        outline.outside += step_m;
        return;
      }
      const int other = y * frame_.width() + x;
      if (std::isnan(frame_.points[other].z())) continue;
      if (pieces_.label(y, x) == own) return;
      if (pieces_.label(y, x) >= 0) {
        outline.pieces += step_m;
        if (own < pieces_.label(y, x)) note(own, pieces_.label(y, x), pixel, other);
      } else {
        const float gap = (frame_.points[other] - frame_.points[pixel]).norm();
        float& kind = object_points_.on_table(y, x) && gap < kMaxContact_m ? outline.table
                      : frame_.points[other].z() > z                       ? outline.front
                                                                           : outline.behind;
        kind += step_m;
      }
      return;
    }
    outline.unknown += step_m;
  }

  void note(int first, int second, int pixel, int other) {
    PairBorder& pair = borders_.pairs[{first, second}];
    const float gap = (frame_.points[other] - frame_.points[pixel]).norm();
    // A border is the edge of what is nearer: as long as there, whichever piece comes first.
    const float step_m =
        std::min(frame_.points[pixel].z(), frame_.points[other].z()) / static_cast<float>(frame_.camera.focal());
    if (gap < kMaxContact_m) {
      pair.contact += step_m;
      pair.samples.push_back({pixel, other});
    } else if (frame_.points[pixel].z() < frame_.points[other].z()) {
      pair.first_in_front += step_m;
    } else {
      pair.second_in_front += step_m;
    }
  }

  const Frame& frame_;
  const ObjectPoints& object_points_;
  const Pieces& pieces_;
  Borders borders_;
};

}  // namespace

Borders findBorders(const Frame& frame, const ObjectPoints& object_points, const Pieces& pieces) {
  return BorderWalk(frame, object_points, pieces).run();
}

}  // namespace objectness
