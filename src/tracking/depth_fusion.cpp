// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/tracking/depth_fusion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "objectness_segmentation/common/angles.hpp"
#include "objectness_segmentation/common/parallel.hpp"

namespace objectness {
namespace {

constexpr int kMostFrames = 100;

// Of the camera: more is a movement.
constexpr double kMaxShift_m = 0.001, kMaxTurn_rad = 0.1 * kDegree;

// Of inverse depth, 1 / metres: steps of the sensor are not below this.
constexpr float kLeastSigma = 0.0015f;
constexpr double kMostDisparity_px = 0.2, kLeastBaseline_m = 0.05;  // more noise than that is none

constexpr double kOneSigma = 0.683;  // share of a normal distribution within it
constexpr float kBin = 0.0001f;
constexpr int kBins = 400;
constexpr float kGrowth = 1.1f;         // of the noise a frame, at most
constexpr float kMovedSigmas = 2;       // deviations that grew by this much from one frame to the next
constexpr double kMinMoved = 0.3;       // of the picture, in blocks that deviate
constexpr double kMovedTogether = 0.6;  // share of the deviations that whole blocks have in common
constexpr int kBlock_px = 64;
constexpr int kMinInBlock = 256;

constexpr float kJumpSigmas = 4, kDriftSigmas = 3;
constexpr int kNear_px = 3, kMinNear = 5;  // of 9 pixels that jump, the scene has changed
constexpr int kDrift_px = 11;              // side of the square over which a drift is averaged
constexpr int kHole_px = 21;               // holes that are wider are no flicker
constexpr double kMaxHoleShare = 0.7;      // of such a square
constexpr uchar kMaxOutliers = 2;          // that follow one another
constexpr uchar kMinKnown = 2;             // frames that speak against one

enum Kind : uchar { kNothing, kNew, kAgrees, kJumps, kMissing };

/// The largest noise of inverse depth that is taken for noise.
float mostSigma(const PinholeCamera& camera) {
  return static_cast<float>(kMostDisparity_px / (camera.focal() * kLeastBaseline_m));
}

/// Standard deviation of one frame from the mean of so many others, in those of one frame.
const std::array<float, kMostFrames + 1> kOfMean = [] {
  std::array<float, kMostFrames + 1> table{};
  for (int count = 1; count <= kMostFrames; ++count) table[count] = std::sqrt(1 + 1 / static_cast<float>(count));
  return table;
}();

/// Deviations as sizes, counted.
class DeviationCounts {
 public:
  void add(float size) { ++bins_[std::min(kBins - 1, static_cast<int>(size / kBin))]; }
  void add(const DeviationCounts& other) {
    for (int i = 0; i < kBins; ++i) bins_[i] += other.bins_[i];
  }
  /// The size that `share` are not above; kBins * kBin or more counts as that.
  float quantile(double share) const {
    std::int64_t all = 0, below = 0;
    for (const std::int64_t count : bins_) all += count;
    for (int i = 0; i < kBins; ++i) {
      below += bins_[i];
      if (below > 0 && static_cast<double>(below) >= share * static_cast<double>(all))
        return kBin * static_cast<float>(i + 1);
    }
    return 0;
  }

 private:
  std::array<std::int64_t, kBins> bins_{};
};

}  // namespace

/// A frame beside what was known before it.
struct DepthFusion::Change {
  cv::Mat_<float> inverse_m;  ///< of the frame, 0: not measured
  cv::Mat_<float> deviation;  ///< from what was known, 0 where either is missing
  cv::Mat_<uchar> kind;
  float sigma = 0;  ///< of the deviations, reduced to those of one frame
  bool moved_together = false;
  float most_sigma;

  Change(const Frame& frame, const cv::Mat_<float>& known, const cv::Mat_<uchar>& count, int threads)
      : inverse_m(known.size()),
        deviation(known.size()),
        kind(known.size(), kNothing),
        most_sigma(mostSigma(frame.camera)) {
    for (int v = 0; v < frame.height(); ++v) {
      float* row = inverse_m[v];
      const Eigen::Vector3f* points = &frame.points[static_cast<std::size_t>(v) * frame.width()];
      for (int u = 0; u < frame.width(); ++u) row[u] = points[u].z() > 0 ? 1 / points[u].z() : 0;
    }
    for (const int i : frame.bridged) inverse_m(i / frame.width(), i % frame.width()) = 0;  // not measured either

    const int bands = (frame.height() + kBlock_px - 1) / kBlock_px;
    std::vector<DeviationCounts> counts(bands);
    std::vector<std::array<double, 2>> sums(bands, {0, 0});  // of pixels: by what they have in common, and all
    parallelFor(bands, threads, [&](int band) { measure(known, count, band, counts[band], sums[band]); });
    double together = 0, all = 0;
    for (int band = 0; band < bands; ++band) {
      if (band > 0) counts[0].add(counts[band]);
      together += sums[band][0];
      all += sums[band][1];
    }
    sigma = counts[0].quantile(kOneSigma);
    moved_together = together > kMovedTogether * all && all > kMinMoved * frame.size();
  }

  void measure(const cv::Mat_<float>& known, const cv::Mat_<uchar>& count, int band, DeviationCounts& counts,
               std::array<double, 2>& sums) {
    const int last = std::min(known.rows, (band + 1) * kBlock_px);
    for (int left = 0; left < known.cols; left += kBlock_px) {
      const int right = std::min(known.cols, left + kBlock_px);
      double sum = 0, sizes = 0;
      int pixels = 0;
      for (int v = band * kBlock_px; v < last; ++v) {
        const float *now = inverse_m[v], *before = known[v];
        for (int u = left; u < right; ++u) {
          const bool both = now[u] > 0 && before[u] > 0;
          const float d = both ? now[u] - before[u] : 0;
          deviation(v, u) = d;
          kind(v, u) = both ? kAgrees : now[u] > 0 ? kNew : before[u] > 0 ? kMissing : kNothing;
          if (!both) continue;
          const float size = std::abs(d);
          counts.add(size / kOfMean[count(v, u)]);
          const float limit = kJumpSigmas * most_sigma;
          sum += std::clamp(d, -limit, limit);
          sizes += std::min(size, limit);
          ++pixels;
        }
      }
      if (pixels < kMinInBlock || sizes < 0.5 * kLeastSigma * pixels) continue;
      sums[0] += pixels * std::abs(sum) / sizes;
      sums[1] += pixels;
    }
  }
};

DepthFusion::DepthFusion(int frames) : frames_(std::clamp(frames, 1, kMostFrames)) {}

void DepthFusion::clear() {
  inverse_m_.release();
  count_.release();
  missed_.release();
  T_fixed_camera_.reset();
  sigma_ = 0;
}

std::size_t DepthFusion::memoryBytes() const { return inverse_m_.total() * (sizeof(float) + 2 * sizeof(uchar)); }

bool DepthFusion::isAnother(const Frame& frame, const std::optional<Eigen::Isometry3d>& T_fixed_camera) const {
  const PinholeCamera& c = frame.camera;
  if (inverse_m_.empty() || inverse_m_.rows != c.height || inverse_m_.cols != c.width) return true;
  // Recovered intrinsics differ a little from cloud to cloud.
  if (std::abs(c.fx - camera_.fx) + std::abs(c.fy - camera_.fy) > 0.01 * c.fx) return true;
  if (std::abs(c.cx - camera_.cx) + std::abs(c.cy - camera_.cy) > 1) return true;
  if (T_fixed_camera.has_value() != T_fixed_camera_.has_value()) return true;
  if (!T_fixed_camera) return false;
  const Eigen::Isometry3d moved = T_fixed_camera_->inverse() * *T_fixed_camera;
  return moved.translation().norm() > kMaxShift_m || Eigen::AngleAxisd(moved.linear()).angle() > kMaxTurn_rad;
}

void DepthFusion::restart(const Frame& frame, const std::optional<Eigen::Isometry3d>& T_fixed_camera) {
  camera_ = frame.camera;
  T_fixed_camera_ = T_fixed_camera;
  inverse_m_.create(frame.height(), frame.width());
  for (int i = 0; i < frame.size(); ++i) inverse_m_(i) = frame.points[i].z() > 0 ? 1 / frame.points[i].z() : 0;
  for (const int i : frame.bridged) inverse_m_(i) = 0;
  count_.create(inverse_m_.size());
  count_.setTo(1);
  missed_.create(inverse_m_.size());
  missed_.setTo(0);
}

/// Tells the pixels that jump from those that agree, and sums up around every pixel.
struct DepthFusion::Surroundings {
  cv::Mat_<uchar> jumps, agrees;  ///< in a square of kNear_px, of kDrift_px
  cv::Mat_<float> drift;          ///< sum of the deviations of those that agree
  cv::Mat_<int> missing;          ///< in a square of kHole_px

  Surroundings(Change& change, const cv::Mat_<uchar>& count, float sigma, int threads) {
    const cv::Size size = count.size();
    cv::Mat_<uchar> jump(size), agree(size), miss(size);
    parallelFor(size.height, threads, [&](int v) {
      for (int u = 0; u < size.width; ++u) {
        uchar& kind = change.kind(v, u);
        if (kind == kAgrees && std::abs(change.deviation(v, u)) > kJumpSigmas * sigma * kOfMean[count(v, u)]) {
          kind = kJumps;
          change.deviation(v, u) = 0;
        }
        jump(v, u) = kind == kJumps;
        agree(v, u) = kind == kAgrees;
        miss(v, u) = kind == kMissing;
      }
    });
    const auto sumOver = [](const cv::Mat& image, int side_px, int depth, cv::Mat& sums) {
      cv::boxFilter(image, sums, depth, {side_px, side_px}, {-1, -1}, false, cv::BORDER_CONSTANT);
    };
    sumOver(jump, kNear_px, CV_8U, jumps);
    sumOver(agree, kDrift_px, CV_8U, agrees);
    sumOver(change.deviation, kDrift_px, CV_32F, drift);
    sumOver(miss, kHole_px, CV_32S, missing);
  }
};

bool DepthFusion::hasChanged(const Change& change, const Surroundings& around, int v, int u) const {
  const uchar count = count_(v, u);
  switch (change.kind(v, u)) {
    case kAgrees:
      return std::abs(around.drift(v, u)) > kDriftSigmas * sigma_ * kOfMean[count] * around.agrees(v, u);
    case kJumps:
      return around.jumps(v, u) >= kMinNear || missed_(v, u) >= kMaxOutliers || count < kMinKnown;
    case kMissing:
      return around.missing(v, u) > kMaxHoleShare * kHole_px * kHole_px;
    default:
      return false;
  }
}

FusedDepth DepthFusion::fuseRow(const Change& change, const Surroundings& around, int v, Frame& frame) {
  FusedDepth row;
  Eigen::Vector3f* points = &frame.points[static_cast<std::size_t>(v) * frame.width()];
  for (int u = 0; u < frame.width(); ++u) {
    const uchar kind = change.kind(v, u);
    if (kind == kNothing) continue;
    float& known = inverse_m_(v, u);
    uchar &count = count_(v, u), &missed = missed_(v, u);
    const bool changed = hasChanged(change, around, v, u);
    if (kind == kNew || changed) {
      known = change.inverse_m(v, u);
      count = 1;
      missed = 0;
      row.changed += changed;
    } else if (kind == kAgrees) {
      count = static_cast<uchar>(std::min<int>(count + 1, frames_));
      missed = 0;
      known += change.deviation(v, u) / static_cast<float>(count);
      points[u] *= 1 / (known * points[u].z());
      ++row.averaged;
    } else if (++missed > frames_ && kind == kMissing) {
      known = 0;
    } else if (count >= kMinKnown) {
      points[u] = (frame.camera.ray(u, v) / known).cast<float>();
      row.filled += kind == kMissing;
      row.averaged += kind == kJumps;
    }
  }
  return row;
}

FusedDepth DepthFusion::fuse(const std::optional<Eigen::Isometry3d>& T_fixed_camera, int threads, Frame& frame) {
  FusedDepth fused;
  if (frames_ == 1) return fused;
  if (isAnother(frame, T_fixed_camera))
    sigma_ = 0;
  else {
    Change change(frame, inverse_m_, count_, threads);
    const bool noisier = sigma_ > 0 && change.sigma > kMovedSigmas * sigma_;
    if (!change.moved_together && !noisier && change.sigma <= mostSigma(camera_)) {
      const float measured = std::max(kLeastSigma, change.sigma);
      sigma_ = sigma_ > 0 ? std::min(measured, kGrowth * sigma_) : measured;
      const Surroundings around(change, count_, sigma_, threads);
      std::vector<FusedDepth> rows(frame.height());
      parallelFor(frame.height(), threads, [&](int v) { rows[v] = fuseRow(change, around, v, frame); });
      for (const FusedDepth& row : rows) {
        fused.averaged += row.averaged;
        fused.filled += row.filled;
        fused.changed += row.changed;
      }
      const auto is_filled = [&](int i) {
        return change.kind(i) == kMissing && inverse_m_(i) > 0 && count_(i) >= kMinKnown;
      };
      frame.bridged.erase(std::remove_if(frame.bridged.begin(), frame.bridged.end(), is_filled), frame.bridged.end());
      return fused;
    }
  }
  restart(frame, T_fixed_camera);
  fused.restarted = true;
  return fused;
}

}  // namespace objectness
