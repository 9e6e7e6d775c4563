// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace objectness {

/// A pinhole camera and the size of its image, pixels.
struct PixelCamera {
  float fx, fy, cx, cy;
  int width, height;
};

/// The index of the pixel that each point of the optical frame is seen at, -1 out of view. Plain types only: compiled
/// for several instruction sets, chosen at run time.
void findPixels(const PixelCamera& camera, const float* x, const float* y, const float* z, int count, int* pixels);

}  // namespace objectness
