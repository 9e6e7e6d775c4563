// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/scene/frame.hpp"

namespace objectness {

/// Standard deviation of a depth reading, sigma_z(z) = constant_m + quadratic_per_m * z^2 (Khoshelham & Elberink 2012).
/// The defaults are a prior for any structured-light or stereo camera; findTable() replaces them by this frame's own
/// noise.
struct DepthNoise {
  double constant_m = 0.0008;
  double quadratic_per_m = 0.0016;

  double sigma(double z) const { return constant_m + quadratic_per_m * z * z; }
};

struct NormalsConfig {
  double window_m = 0.010;
  int min_window_px = 3;
  int max_window_px = 30;
  double max_error_deg = 4.0;
  double max_widening = 2.0;
  double jump_sigmas = 6.0;
  double jump_slope = 8.0;
  bool pcl = false;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("window_m", self.window_m, Range{0.002, 0.1}, "radius of the fitting window on the surface");
    visit("min_window_px", self.min_window_px, Range{1, 50}, "smallest window radius in the image");
    visit("max_window_px", self.max_window_px, Range{1, 50}, "largest window radius in the image");
    visit("max_error_deg", self.max_error_deg, Range{0.1, 90},
          "the window is widened when the normals of the bare table are worse than this in the median");
    visit("max_widening", self.max_widening, Range{1, 10}, "but never by more than this factor");
    visit("jump_sigmas", self.jump_sigmas, Range{0, 100},
          "depth jump: neighbours differ by more than this many sigma_z");
    visit("jump_slope", self.jump_slope, Range{0, 100},
          "and by more than this times z / f: the slope of a surface seen at grazing angle (8: about 83 deg)");
    visit("pcl", self.pcl,
          "use pcl::IntegralImageNormalEstimation (COVARIANCE_MATRIX) instead of the inverse-depth fit");
  }
};

/// Per pixel, all of size width * height:
struct Normals {
  std::vector<Eigen::Vector3f> normal;  ///< unit, optical frame, towards the camera; NaN where there is none
  std::vector<float>
      residual_m;              ///< RMS distance of the window's points to the fitted plane, metres; NaN where no normal
  std::vector<float> depth_m;  ///< z of the fitted plane at the pixel; NaN where no normal
  std::vector<unsigned char> jump;  ///< bit 0: depth jump or hole between (u, v) and (u + 1, v); bit 1: and (u, v + 1)
  std::vector<unsigned char> radius_px;  ///< window radius used, 0 where no normal
};

/// Surface normals. On a plane 1/z is linear in the pixel coordinates: it is fitted by integral images in a square
/// window of window_m, shrunk to the distance from the nearest depth jump or hole. Does not depend on the number of
/// threads.
Normals estimateNormals(const Frame& frame, const NormalsConfig& config, const DepthNoise& noise = {}, int threads = 1);

}  // namespace objectness
