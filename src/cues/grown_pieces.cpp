// SPDX-License-Identifier: BSD-3-Clause
#include "grown_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "crease.hpp"
#include "objectness_segmentation/common/row_bands.hpp"
#include "radix_order.hpp"

namespace objectness {
namespace {

constexpr double kMinGap = 0.004;  // metres
constexpr double kGapSigmas = 4.0;
constexpr double kPartSize = 3;  // times the smallest piece: what is parted at a narrow place shows more than a speck

/// Bits: whether a pixel is connected to its neighbour to the right and to those below.
enum Way : uchar { kRight = 1, kLowerLeft = 2, kDown = 4, kLowerRight = 8 };

/// The distance to the nearest cut of each smooth pixel, in pixels.
cv::Mat_<float> roomOf(const cv::Mat_<uchar>& smooth) {
  cv::Mat_<float> room(smooth.size());
  // Beyond the rim around the smooth pixels there is nothing that is nearer.
  const cv::Rect all(0, 0, smooth.cols, smooth.rows), used = cv::boundingRect(smooth);
  const cv::Rect rim = cv::Rect(used.x - 1, used.y - 1, used.width + 2, used.height + 2) & all;
  if (used.empty()) return room;
  cv::distanceTransform(smooth(rim), room(rim), cv::DIST_L2, 3);
  return room;
}

class Grower {
 public:
  Grower(const Frame& frame, const Normals& normals, const DepthNoise& noise, const cv::Mat_<uchar>& smooth,
         const SuperpixelsConfig& config)
      : frame_(frame),
        normals_(normals),
        noise_(noise),
        smooth_(smooth),
        config_(config),
        min_cosine_(static_cast<float>(std::cos(config.neighbor_deg * M_PI / 180))) {}

  cv::Mat_<int> run(int threads) {
    number();
    ways_.create(smooth_.size());
    forRowBands(smooth_.rows, threads, [&](int first, int last) {
      for (int v = first; v < last; ++v) findWays(v);
    });
    const cv::Mat_<float> room = roomOf(smooth_);
    std::vector<float> rooms(pixel_.size());
    for (std::size_t k = 0; k < pixel_.size(); ++k) rooms[k] = room(pixel_[k]);
    parent_.assign(pixel_.size(), -1);
    pieces_.resize(pixel_.size());
    for (const int k : descendingOrder(rooms)) add(k, rooms[k]);
    return named();
  }

 private:
  struct Piece {
    int pixels;
    float room;   ///< in its middle
    double area;  ///< as seen: a pixel spans (z / f)^2; here without 1 / f^2
  };

  /// Smooth pixels are numbered in their order in the image.
  void number() {
    number_.create(smooth_.size());
    for (int i = 0; i < frame_.size(); ++i) {
      if (!smooth_.data[i]) continue;
      number_(i) = static_cast<int>(pixel_.size());
      pixel_.push_back(i);
    }
  }

  void findWays(int v) {
    const int width = smooth_.cols;
    const bool last = v + 1 == smooth_.rows;
    for (int u = 0; u < width; ++u) {
      const int i = v * width + u;
      uchar ways = 0;
      if (smooth_.data[i]) {
        if (u + 1 < width && connected(i, i + 1)) ways |= kRight;
        if (!last && u > 0 && connected(i, i + width - 1)) ways |= kLowerLeft;
        if (!last && connected(i, i + width)) ways |= kDown;
        if (!last && u + 1 < width && connected(i, i + width + 1)) ways |= kLowerRight;
      }
      ways_.data[i] = ways;
    }
  }

  bool connected(int a, int b) const {
    if (!smooth_.data[b] || !(normals_.normal[a].dot(normals_.normal[b]) > min_cosine_)) return false;
    const double z_a = frame_.points[a].z(), z_b = frame_.points[b].z(), z = std::min(z_a, z_b);
    const double step = std::abs(z_a - z_b);
    return step < kMinGap || step < std::max(kGrazingSlope * z / frame_.camera.focal(), kGapSigmas * noise_.sigma(z));
  }

  void add(int k, float room) {
    const int width = smooth_.cols, pixel = pixel_[k], u = pixel % width, v = pixel / width;
    parent_[k] = k;
    const double z = frame_.points[pixel].z();
    pieces_[k] = {1, room, z * z};
    int own = k;
    const auto meet = [&](int neighbour) {
      const int other = number_(neighbour);
      if (parent_[other] >= 0) own = join(own, root(other), room);
    };
    const uchar* ways = ways_.data + pixel;
    if (v > 0) {
      if (u > 0 && (ways[-width - 1] & kLowerRight)) meet(pixel - width - 1);
      if (ways[-width] & kDown) meet(pixel - width);
      if (u + 1 < width && (ways[-width + 1] & kLowerLeft)) meet(pixel - width + 1);
    }
    if (u > 0 && (ways[-1] & kRight)) meet(pixel - 1);
    if (*ways & kRight) meet(pixel + 1);
    if (*ways & kLowerLeft) meet(pixel + width - 1);
    if (*ways & kDown) meet(pixel + width);
    if (*ways & kLowerRight) meet(pixel + width + 1);
  }

  /// Joins the pieces of two roots, unless the place of this room between them is narrow; the root of the first.
  int join(int a, int b, float room) {
    if (a == b || narrow(a, b, room)) return a;
    const int to = std::min(a, b), from = std::max(a, b);
    parent_[from] = to;
    pieces_[to].pixels += pieces_[from].pixels;
    pieces_[to].area += pieces_[from].area;
    pieces_[to].room = std::max(pieces_[to].room, pieces_[from].room);
    return to;
  }

  bool largeEnough(int root, double times = 1) const {
    const Piece& piece = pieces_[root];
    return piece.pixels >= times * config_.min_pixels &&
           piece.area / (frame_.camera.fx * frame_.camera.fy) >= times * config_.min_area_m2;
  }

  bool narrow(int a, int b, float room) const {
    return room < config_.narrow_share * std::min(pieces_[a].room, pieces_[b].room) && largeEnough(a, kPartSize) &&
           largeEnough(b, kPartSize);
  }

  int root(int k) {
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
  }

  cv::Mat_<int> named() {
    cv::Mat_<int> piece(smooth_.size(), -1);
    for (std::size_t k = 0; k < pixel_.size(); ++k) {
      const int first = root(static_cast<int>(k));
      if (largeEnough(first)) piece(pixel_[k]) = pixel_[first];
    }
    return piece;
  }

  const Frame& frame_;
  const Normals& normals_;
  const DepthNoise noise_;
  const cv::Mat_<uchar>& smooth_;
  const SuperpixelsConfig& config_;
  const float min_cosine_;
  cv::Mat_<int> number_;  ///< of a smooth pixel
  cv::Mat_<uchar> ways_;
  // By number:
  std::vector<int> pixel_;
  std::vector<int> parent_;    ///< -1: not yet in a piece
  std::vector<Piece> pieces_;  ///< valid at roots
};

}  // namespace

cv::Mat_<int> growPieces(const Frame& frame, const Normals& normals, const DepthNoise& noise,
                         const cv::Mat_<uchar>& smooth, const SuperpixelsConfig& config, int threads) {
  return Grower(frame, normals, noise, smooth, config).run(threads);
}

}  // namespace objectness
