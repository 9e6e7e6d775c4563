// SPDX-License-Identifier: BSD-3-Clause
#include "scene/view_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "common/upper_median.hpp"
#include "scene/frame_axes.hpp"

namespace objectness {
namespace {

// A view of the camera has its points on the rays of pixel centres. Points from elsewhere (merged, another camera) are
// spread evenly over the pixels, and a disk of this radius holds only 79 % of a pixel.
constexpr float kOnPixelRadiusPx = 0.5F;
constexpr double kMinShareOnPixels = 0.9;
// Averages of several points lie anywhere between pixels, those of one point on its centre: with more than this share
// of points off their centres and this share of empty pixels around them, a cloud was averaged. Either alone is no sign
// of it: coordinates may be rounded, and pixels may have no depth.
constexpr float kCentreRadiusPx = 0.1F;
constexpr double kMinShareOnCentres = 0.9;
constexpr double kMinFilledOfAveraged = 0.85;
// With fewer pixels filled around its points than this, a cloud is too thin for its surfaces to hold together.
constexpr double kMinFilled = 0.35;
// A camera that is slightly wrong, or a lens, moves points that are close together alike.
constexpr int kBlockPx = 32;
// Steps that files and drivers round coordinates to.
constexpr std::array<double, 2> kRoundingSteps{1e-3, 1e-4};
constexpr double kMinShareRounded = 0.99;

bool isMultiple(float value, double step) {
  const double multiple = value / step;
  return std::abs(multiple - std::round(multiple)) * step <= 1e-7 + 1e-6 * std::abs(value);
}

/// The step that coordinates were rounded to, 0 when they were not.
double roundingStep(const std::vector<Eigen::Vector3f>& points) {
  for (const double step : kRoundingSteps) {
    std::size_t finite = 0, rounded = 0;
    for (const Eigen::Vector3f& p : points) {
      if (!p.allFinite()) continue;
      ++finite;
      rounded += isMultiple(p.x(), step) && isMultiple(p.y(), step) && isMultiple(p.z(), step);
    }
    if (rounded >= kMinShareRounded * finite) return step;
  }
  return 0;
}

/// The share of a list's points that lie near the nearest pixel's centre, as near as `radius` says.
double shareOnPixels(const std::vector<Eigen::Vector3f>& points, const PinholeCamera& camera,
                     const Eigen::Matrix3f& rotation) {
  std::size_t finite = 0, on_pixel = 0;
  for (const Eigen::Vector3f& p : points) {
    finite += p.allFinite();
    const SeenAt seen = lookAt(rotation * p, camera);
    on_pixel += seen.inside && seen.offset.norm() <= kOnPixelRadiusPx;
  }
  return finite > 0 ? static_cast<double>(on_pixel) / finite : 0;
}

/// The points of a list where the camera sees them.
class View {
 public:
  View(const std::vector<Eigen::Vector3f>& points, const PinholeCamera& camera)
      : camera_(camera), filled_(camera.height, camera.width, uchar(0)) {
    const double step = roundingStep(points);
    for (const Eigen::Vector3f& p : points) {
      const SeenAt seen = lookAt(p, camera);
      if (!seen.inside) continue;
      filled_(seen.v, seen.u) = 1;
      const int block = seen.v / kBlockPx * blocksPerRow() + seen.u / kBlockPx;
      const double tangent = std::max(std::abs(p.x()), std::abs(p.y())) / p.z();
      const double rounding = 0.5 * step * camera.focal() / p.z() * (1 + tangent);
      seen_.push_back({block, seen.offset, static_cast<float>(kCentreRadiusPx + rounding)});
    }
  }

  /// The share of points that are where most of their neighbours are within the pixel.
  double onCentres() const {
    const int blocks = blocksPerRow() * ((camera_.height + kBlockPx - 1) / kBlockPx);
    std::vector<std::vector<float>> xs(blocks), ys(blocks);
    for (const Seen& seen : seen_) {
      xs[seen.block].push_back(seen.offset.x());
      ys[seen.block].push_back(seen.offset.y());
    }
    std::vector<Eigen::Vector2f> common(blocks, Eigen::Vector2f::Zero());
    for (int block = 0; block < blocks; ++block) {
      if (!xs[block].empty()) common[block] = {upperMedian(xs[block]), upperMedian(ys[block])};
    }
    const auto on_centre = std::count_if(seen_.begin(), seen_.end(), [&](const Seen& seen) {
      return (seen.offset - common[seen.block]).cwiseAbs().maxCoeff() <= seen.tolerance;
    });
    return static_cast<double>(on_centre) / seen_.size();
  }

  /// The share of filled ones among the eight pixels around each filled one.
  double filledAround() const {
    std::size_t filled = 0, around = 0;
    for (int v = 0; v < camera_.height; ++v) {
      for (int u = 0; u < camera_.width; ++u) {
        if (!filled_(v, u)) continue;
        for (int y = std::max(0, v - 1); y <= std::min(v + 1, camera_.height - 1); ++y) {
          for (int x = std::max(0, u - 1); x <= std::min(u + 1, camera_.width - 1); ++x) {
            around += x != u || y != v;
            filled += (x != u || y != v) && filled_(y, x);
          }
        }
      }
    }
    return around > 0 ? static_cast<double>(filled) / around : 1;
  }

 private:
  struct Seen {
    int block;
    Eigen::Vector2f offset;
    float tolerance;
  };

  int blocksPerRow() const { return (camera_.width + kBlockPx - 1) / kBlockPx; }

  const PinholeCamera& camera_;
  cv::Mat_<uchar> filled_;
  std::vector<Seen> seen_;
};

int percent(double share) { return static_cast<int>(100 * share); }

Status notOfThisCamera(const RawCloud& cloud, const PinholeCamera& camera, double on_pixels, std::ostringstream& why) {
  for (const FrameAxes& axes : otherAxes()) {
    if (shareOnPixels(cloud.points, camera, axes.R_optical_cloud) < kMinShareOnPixels) continue;
    why << ": " << notOptical(cloud, axes.name);
    return Status::error(StatusCode::kNotOrganized, why.str());
  }
  why << ", and only " << percent(on_pixels) << " % of its points lie on pixels of the given camera (" << camera.width
      << " x " << camera.height << ", fx " << camera.fx << ", cx " << camera.cx << ", cy " << camera.cy
      << "): give the camera that took it, and its points " << kInOpticalFrame;
  if (!cloud.frame_id.empty()) why << " (they are in '" << cloud.frame_id << "')";
  const double filled = View(cloud.points, camera).filledAround();
  if (filled < kMinFilledOfAveraged) {
    why << "; if this is the one, the cloud was down-sampled, as by a voxel grid (" << percent(1 - filled)
        << " % of the pixels around its points are empty): give it as it was before";
  }
  return Status::error(StatusCode::kNotOrganized, why.str());
}

}  // namespace

SeenAt lookAt(const Eigen::Vector3f& point, const PinholeCamera& camera) {
  if (!point.allFinite() || point.z() <= 0) return {};
  const Eigen::Vector2d pixel = camera.project(point.cast<double>());
  const Eigen::Vector2d centre(std::round(pixel.x()), std::round(pixel.y()));
  if (!(centre.x() >= 0 && centre.y() >= 0 && centre.x() < camera.width && centre.y() < camera.height)) return {};
  return {true, static_cast<int>(centre.x()), static_cast<int>(centre.y()), (pixel - centre).cast<float>()};
}

Status checkIsView(const RawCloud& cloud, const PinholeCamera& camera) {
  const bool any_finite =
      std::any_of(cloud.points.begin(), cloud.points.end(), [](const auto& p) { return p.allFinite(); });
  if (!any_finite) {
    return Status::error(StatusCode::kNoValidPoints,
                         "none of the cloud's " + std::to_string(cloud.points.size()) + " points is finite");
  }
  std::ostringstream why;
  why << "cloud is " << cloud.width << " x " << cloud.height << ", not organized";
  // First, as the memory that the camera asks for may be much more than the cloud's.
  const double on_pixels = shareOnPixels(cloud.points, camera, Eigen::Matrix3f::Identity());
  if (on_pixels < kMinShareOnPixels) return notOfThisCamera(cloud, camera, on_pixels, why);

  const View view(cloud.points, camera);
  const double on_centres = view.onCentres(), filled = view.filledAround();
  if (on_centres < kMinShareOnCentres && filled < kMinFilledOfAveraged) {
    why << ", and was down-sampled: " << percent(1 - on_centres) << " % of its points lie between pixels and "
        << percent(1 - filled)
        << " % of the pixels around its points are empty, as a voxel grid leaves them; give the cloud as it was before "
           "(cutting points out, by pass-through or crop box, does no harm)";
    return Status::error(StatusCode::kNotOrganized, why.str());
  }
  if (filled < kMinFilled) {
    why << ", and was down-sampled: " << percent(1 - filled)
        << " % of the pixels around its points are empty; give the cloud as it was before, or where whole rows and "
           "columns were left out, the camera of what is left (binning_x, binning_y)";
    return Status::error(StatusCode::kNotOrganized, why.str());
  }
  return {};
}

}  // namespace objectness
