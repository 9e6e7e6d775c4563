// SPDX-License-Identifier: BSD-3-Clause
#include "scene/surface_check.hpp"

#include <sstream>

namespace objectness {
namespace {

// On recordings of twelve cameras it is an eighth at most.
constexpr double kMaxShareBesideHoles = 0.5;
constexpr int kSampleStep = 7;

}  // namespace

Status checkSurfaces(const Frame& frame) {
  const int width = frame.width();
  std::size_t with_depth = 0, beside_holes = 0;
  const auto missing = [&](int i) { return !(frame.points[i].z() > 0); };
  for (int i = width; i < frame.size() - width; i += kSampleStep) {
    if (i % width == 0 || i % width == width - 1 || missing(i)) continue;
    ++with_depth;
    beside_holes += missing(i - 1) || missing(i + 1) || missing(i - width) || missing(i + width);
  }
  if (beside_holes <= kMaxShareBesideHoles * with_depth) return {};
  std::ostringstream why;
  why << "depth is torn: " << 100 * beside_holes / with_depth
      << " % of the pixels that have depth lie beside one without, which leaves no surfaces to segment; where depth is "
         "registered to a finer camera, fill it (fill_upsampling_holes of depth_image_proc/register), take the "
         "unregistered depth, or raise input.max_gap_px";
  return Status::error(StatusCode::kBadInput, why.str());
}

}  // namespace objectness
