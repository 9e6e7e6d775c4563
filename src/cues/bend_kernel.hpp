// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace objectness {

/// What one side of a run of pixels looks like: arrays at the first of them, x, y, z one after the other.
struct SideRow {
  const float *normals, *points, *depths;  ///< depths of the fitted planes
  const unsigned char *radius_px, *where;
};

/// Largest bends so far, and in which direction the largest of both was.
struct BendRow {
  float *convex, *concave;
  unsigned char* direction;
};

/// Compares the sides a and b of `count` pixels that lie next to each other, all with windows of this radius: where
/// `waiting` is set and the windows of both sides are as large. Clears `waiting` there.
void bendRun(const SideRow& a, const SideRow& b, int count, int radius, int direction, unsigned char* waiting,
             const BendRow& bends);

/// The same for steps between the sides: `largest` so far. Only between pixels where `where` is set on both sides.
void stepRun(const SideRow& a, const SideRow& b, int count, int radius, float min_cosine, unsigned char* waiting,
             float* largest);

}  // namespace objectness
