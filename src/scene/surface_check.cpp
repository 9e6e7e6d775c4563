// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/scene/surface_check.hpp"

#include <sstream>

namespace objectness {
namespace {

// Of clutter in front of a wall it is an eighth, on a recording of each of twelve cameras a twentieth.
constexpr double kMaxShareWithoutNormal = 0.5;

}  // namespace

Status checkSurfaces(const Frame& frame, const Normals& normals) {
  std::size_t with_depth = 0, with_normal = 0;
  // Pixels at the border of the image have no normal in any frame.
  for (int v = 1; v + 1 < frame.height(); ++v) {
    const std::size_t row = static_cast<std::size_t>(v) * frame.width();
    for (int u = 1; u + 1 < frame.width(); ++u) {
      with_depth += frame.points[row + u].z() > 0;
      with_normal += normals.radius_px[row + u] > 0;
    }
  }
  if (with_normal >= (1 - kMaxShareWithoutNormal) * with_depth) return {};
  std::ostringstream why;
  why << "depth is torn: " << 100 * (with_depth - with_normal) / with_depth
      << " % of the pixels that have depth lie beside a hole or a jump, which leaves no surfaces to segment; where "
         "depth "
         "is registered to a finer camera, fill it (fill_upsampling_holes of depth_image_proc/register), take the "
         "unregistered depth, or raise input.max_gap_px";
  return Status::error(StatusCode::kBadInput, why.str());
}

}  // namespace objectness
