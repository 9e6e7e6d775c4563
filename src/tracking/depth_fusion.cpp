// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/tracking/depth_fusion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "common/angles.hpp"
#include "common/parallel.hpp"
#include "tracking/depth_difference.hpp"

namespace objectness {
namespace {

// Of the camera: more is a movement.
constexpr double kMaxShift_m = 0.001, kMaxTurn_rad = 0.1 * kDegree;

constexpr float kGrowth = 1.1f;    // of the noise a frame, at most
constexpr float kMovedSigmas = 2;  // deviations that grew by this much from one frame to the next

constexpr float kDriftSigmas = 3;
constexpr int kBlock_px = 8;           // side of the squares over which a drift is averaged
constexpr int kMinNear = 5;            // of 3 x 3 pixels that jump, the scene has changed
constexpr double kMaxHoleShare = 0.7;  // of 3 x 3 blocks: holes that are wider are no flicker
constexpr uchar kMaxOutliers = 2;      // that follow one another
constexpr uchar kMinKnown = 2;         // frames that speak against one

enum Kind : uchar { kNothing, kNew, kAgrees, kJumps, kMissing };

}  // namespace

/// What every pixel is beside what was known of it, with sums over blocks.
struct DepthFusion::Change {
  struct Block {
    float drift = 0;  ///< sum of the deviations of the pixels that agree
    float noise = 0;  ///< of their standard deviations
    int missing = 0;
    bool has_drifted = false;  ///< the mean of its pixels is no longer what it was
  };
  cv::Mat_<float> deviation;  ///< of those that agree and that jump
  cv::Mat_<uchar> kind;
  cv::Mat_<uchar> is_bridged;  ///< empty when none is
  int across;
  std::vector<Block> blocks;

  Change(const Frame& frame, const cv::Mat_<float>& known, const cv::Mat_<uchar>& count, float sigma, int threads)
      : deviation(known.size()),
        kind(known.size()),
        across((known.cols + kBlock_px - 1) / kBlock_px),
        blocks(static_cast<std::size_t>(across) * ((known.rows + kBlock_px - 1) / kBlock_px)) {
    if (!frame.bridged.empty()) {
      is_bridged = cv::Mat_<uchar>(known.size(), static_cast<uchar>(0));
      for (const int i : frame.bridged) is_bridged(i) = 1;
    }
    std::array<float, kMostFused + 1> sigmas;
    for (int c = 0; c <= kMostFused; ++c) sigmas[c] = sigma * sigmasOfMean(c);
    const int bands = static_cast<int>(blocks.size()) / across;
    parallelFor(bands, threads, [&](int band) {
      for (int v = band * kBlock_px; v < std::min(known.rows, (band + 1) * kBlock_px); ++v) {
        compareRow(frame, known[v], count[v], sigmas, v, &blocks[static_cast<std::size_t>(band) * across]);
      }
      for (int b = 0; b < across; ++b) {
        Block& block = blocks[static_cast<std::size_t>(band) * across + b];
        block.has_drifted = std::abs(block.drift) > kDriftSigmas * block.noise;
      }
    });
  }

  void compareRow(const Frame& frame, const float* known, const uchar* count,
                  const std::array<float, kMostFused + 1>& sigmas, int v, Block* row) {
    const Eigen::Vector3f* points = &frame.points[static_cast<std::size_t>(v) * kind.cols];
    const uchar* bridged = is_bridged.empty() ? nullptr : is_bridged[v];
    uchar* kinds = kind[v];
    float* deviations = deviation[v];
    for (int b = 0; b < across; ++b) {
      Block block = row[b];
      for (int u = b * kBlock_px; u < std::min(kind.cols, (b + 1) * kBlock_px); ++u) {
        const float now = bridged && bridged[u] ? 0 : inverseOf(points[u]), before = known[u];
        if (now == 0 || before == 0) {
          kinds[u] = now > 0 ? kNew : before > 0 ? kMissing : kNothing;
          block.missing += kinds[u] == kMissing;
          continue;
        }
        const float d = now - before, s = sigmas[count[u]];
        deviations[u] = d;
        const bool agrees = std::abs(d) <= kJumpSigmas * s;
        kinds[u] = agrees ? kAgrees : kJumps;
        block.drift += agrees ? d : 0;
        block.noise += agrees ? s : 0;
      }
      row[b] = block;
    }
  }

  const Block& blockOf(int v, int u) const { return blocks[v / kBlock_px * across + u / kBlock_px]; }

  bool jumpsWithNeighbours(int v, int u) const {
    int jumping = 0;
    for (int y = std::max(0, v - 1); y <= std::min(kind.rows - 1, v + 1); ++y) {
      for (int x = std::max(0, u - 1); x <= std::min(kind.cols - 1, u + 1); ++x) jumping += kind(y, x) == kJumps;
    }
    return jumping >= kMinNear;
  }

  bool isWideHole(int v, int u) const {
    const int down = static_cast<int>(blocks.size()) / across, y = v / kBlock_px, x = u / kBlock_px;
    int missing = 0, all = 0;
    for (int j = std::max(0, y - 1); j <= std::min(down - 1, y + 1); ++j) {
      for (int i = std::max(0, x - 1); i <= std::min(across - 1, x + 1); ++i) {
        missing += blocks[j * across + i].missing;
        all += kBlock_px * kBlock_px;
      }
    }
    return missing > kMaxHoleShare * all;
  }
};

DepthFusion::DepthFusion(int frames) : frames_(std::clamp(frames, 1, kMostFused)) {}

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
  for (int i = 0; i < frame.size(); ++i) inverse_m_(i) = inverseOf(frame.points[i]);
  for (const int i : frame.bridged) inverse_m_(i) = 0;
  count_.create(inverse_m_.size());
  count_.setTo(1);
  missed_.create(inverse_m_.size());
  missed_.setTo(0);
}

/// Of a pixel that does not agree.
bool DepthFusion::hasChanged(const Change& change, int v, int u) const {
  switch (change.kind(v, u)) {
    case kJumps:
      return missed_(v, u) >= kMaxOutliers || count_(v, u) < kMinKnown || change.jumpsWithNeighbours(v, u);
    case kMissing:
      return change.isWideHole(v, u);
    default:
      return false;
  }
}

FusedDepth DepthFusion::fuseRow(const Change& change, int v, Frame& frame) {
  FusedDepth row;
  Eigen::Vector3f* points = &frame.points[static_cast<std::size_t>(v) * frame.width()];
  const uchar* kinds = change.kind[v];
  const float* deviations = change.deviation[v];
  float* knowns = inverse_m_[v];
  uchar *counts = count_[v], *misses = missed_[v];
  const Change::Block* blocks = &change.blockOf(v, 0);
  for (int u = 0; u < frame.width(); ++u) {
    const uchar kind = kinds[u];
    if (kind == kNothing) continue;
    const bool changed = kind == kAgrees ? blocks[u / kBlock_px].has_drifted : hasChanged(change, v, u);
    if (kind == kNew || changed) {
      knowns[u] = kind == kMissing ? 0 : inverseOf(points[u]);
      counts[u] = 1;
      misses[u] = 0;
      row.changed += changed;
    } else if (kind == kAgrees) {
      if (counts[u] < frames_) ++counts[u];
      misses[u] = 0;
      knowns[u] += deviations[u] / static_cast<float>(counts[u]);
      points[u] *= 1 / (knowns[u] * points[u].z());
      ++row.averaged;
    } else if (++misses[u] > frames_ && kind == kMissing) {
      knowns[u] = 0;
    } else if (counts[u] >= kMinKnown) {
      points[u] = (frame.camera.ray(u, v) / knowns[u]).cast<float>();
      row.filled += kind == kMissing;
      row.averaged += kind == kJumps;
    }
  }
  return row;
}

/// False when the camera moved.
bool DepthFusion::measureNoise(const DepthDifference& difference) {
  if (difference.moved_together || difference.sigma > mostNoise(camera_)) return false;
  if (sigma_ > 0 && difference.sigma > kMovedSigmas * sigma_) return false;
  const float measured = std::max(kLeastNoise, difference.sigma);
  sigma_ = sigma_ > 0 ? std::min(measured, kGrowth * sigma_) : measured;
  return true;
}

FusedDepth DepthFusion::fuse(const std::optional<Eigen::Isometry3d>& T_fixed_camera, int threads, Frame& frame) {
  FusedDepth fused;
  if (frames_ == 1) return fused;
  const bool is_another = isAnother(frame, T_fixed_camera);
  if (is_another) sigma_ = 0;
  if (is_another || !measureNoise(compareDepth(frame, inverse_m_, count_))) {
    restart(frame, T_fixed_camera);
    fused.restarted = true;
    return fused;
  }
  const Change change(frame, inverse_m_, count_, sigma_, threads);
  std::vector<FusedDepth> rows(frame.height());
  parallelFor(frame.height(), threads, [&](int v) { rows[v] = fuseRow(change, v, frame); });
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

}  // namespace objectness
