// SPDX-License-Identifier: BSD-3-Clause
#include "scene/bridged_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "objectness_segmentation/scene/normals.hpp"

namespace objectness {
namespace {

constexpr double kMaxSigmas = 6.0, kMaxSlope = 8.0;  // of the two ends of a gap, as NormalsConfig has for neighbours

struct Direction {
  int du, dv;
};
constexpr Direction kDirections[] = {{1, 0}, {0, 1}, {1, 1}, {1, -1}};

// Sensors leave up to 2.5 % of such gaps, and up to 0.3 % in the middle of smooth surfaces: mostly along boundaries,
// where they are worth more than what would fill them. Registration without filling and lost pixels leave them
// everywhere. Measured on recordings of twelve cameras.
constexpr double kMinGaps = 0.04, kMinGapsInSmooth = 0.005;
constexpr int kSampleStep = 7;  // of the pixels that are looked at, for smooth surroundings
constexpr double kMaxSmoothSigmas = 1.5;

class GapBridger {
 public:
  GapBridger(int max_gap_px, const Frame& frame) : frame_(frame), max_gap_px_(max_gap_px) {}

  /// Depth of a pixel without one, 0 where no line leads across. The shortest gap counts, of equal ones the one whose
  /// ends differ the least.
  float depthAt(int u, int v) const {
    float best_z = 0, best_length = 0, best_difference = 0;
    for (const Direction& d : kDirections) {
      const int ahead = stepsToDepth(u, v, d.du, d.dv, max_gap_px_);
      if (ahead == 0) continue;
      const int behind = stepsToDepth(u, v, -d.du, -d.dv, max_gap_px_ + 1 - ahead);
      if (behind == 0) continue;
      const float a = depth(u + ahead * d.du, v + ahead * d.dv), b = depth(u - behind * d.du, v - behind * d.dv);
      const float length = (ahead + behind) * (d.du != 0 && d.dv != 0 ? std::sqrt(2.0f) : 1.0f);
      const float difference = std::abs(a - b);
      if (difference > largestDifference(std::min(a, b), length)) continue;
      if (best_z > 0 && (length > best_length || (length == best_length && difference >= best_difference))) continue;
      best_z = (ahead + behind) / (ahead / b + behind / a);
      best_length = length, best_difference = difference;
    }
    return best_z;
  }

  /// The four lines through a pixel meet in one depth, by the ends two pixels away.
  bool isInSmooth(int u, int v) const {
    if (u < 2 || v < 2 || u >= frame_.width() - 2 || v >= frame_.height() - 2) return false;
    float least = 0, most = 0;
    for (const Direction& d : kDirections) {
      const float a = depth(u + 2 * d.du, v + 2 * d.dv), b = depth(u - 2 * d.du, v - 2 * d.dv);
      if (!(a > 0 && b > 0)) return false;
      const float middle = 2 / (1 / a + 1 / b);
      least = least == 0 ? middle : std::min(least, middle);
      most = std::max(most, middle);
    }
    return most - least <= kMaxSmoothSigmas * DepthNoise().sigma(least);
  }

  /// Holes in the middle of smooth surfaces, as a share of all pixels there.
  double gapsInSmooth() const {
    std::size_t smooth = 0, gaps = 0;
    for (int i = 0; i < frame_.size(); i += kSampleStep) {
      if (!isInSmooth(i % frame_.width(), i / frame_.width())) continue;
      ++smooth;
      gaps += !(frame_.points[i].z() > 0);
    }
    return smooth == 0 ? 0 : static_cast<double>(gaps) / smooth;
  }

 private:
  float depth(int u, int v) const { return frame_.points[static_cast<std::size_t>(v) * frame_.width() + u].z(); }

  /// 0: none within max_steps.
  int stepsToDepth(int u, int v, int du, int dv, int max_steps) const {
    for (int step = 1; step <= max_steps; ++step) {
      u += du, v += dv;
      if (u < 0 || v < 0 || u >= frame_.width() || v >= frame_.height()) return 0;
      if (depth(u, v) > 0) return step;
    }
    return 0;
  }

  float largestDifference(float z, float length_px) const {
    const double noise = kMaxSigmas * DepthNoise().sigma(z),
                 grazing = kMaxSlope * z * length_px / frame_.camera.focal();
    return static_cast<float>(std::max(noise, grazing));
  }

  const Frame& frame_;
  int max_gap_px_;
};

/// In steps of 5 %, as a sentence that changes with each frame is a new one to whoever logs it.
std::string remarkOnGaps(double share) {
  const int percent = 5 * static_cast<int>(std::lround(20 * share));
  return (percent == 0 ? "up to 2" : "about " + std::to_string(percent)) +
         " % of the surface in view are small holes between points of one surface, which were bridged: the result is "
         "better without them; where depth is registered to a finer camera, fill it (fill_upsampling_holes of "
         "depth_image_proc/register) or take the unregistered depth";
}

}  // namespace

void bridgeGaps(int max_gap_px, Frame& frame) {
  frame.bridged.clear();
  if (max_gap_px <= 0) return;
  const GapBridger bridger(max_gap_px, frame);
  std::size_t measured = 0;
  std::vector<float> depths;
  for (int v = 0, i = 0; v < frame.height(); ++v) {
    for (int u = 0; u < frame.width(); ++u, ++i) {
      if (frame.points[i].z() > 0) {
        ++measured;
        continue;
      }
      const float z = bridger.depthAt(u, v);
      if (z <= 0) continue;
      frame.bridged.push_back(i);
      depths.push_back(z);
    }
  }
  const double share = static_cast<double>(depths.size()) / std::max<std::size_t>(1, depths.size() + measured);
  if (depths.empty() || (share < kMinGaps && bridger.gapsInSmooth() < kMinGapsInSmooth)) {
    frame.bridged.clear();
    return;
  }
  frame.remarks.push_back(remarkOnGaps(share));
  // Only now, as what is bridged is no end for other gaps.
  for (std::size_t k = 0; k < depths.size(); ++k) {
    const int i = frame.bridged[k];
    frame.points[i] = frame.camera.ray(i % frame.width(), i / frame.width()).cast<float>() * depths[k];
  }
}

}  // namespace objectness
