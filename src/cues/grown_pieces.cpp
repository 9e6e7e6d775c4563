// SPDX-License-Identifier: BSD-3-Clause
#include "grown_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "crease.hpp"

namespace objectness {
namespace {

constexpr double kMinGap = 0.004;  // metres
constexpr double kGapSigmas = 4.0;
constexpr double kPartSize = 3;  // times the smallest piece: what is parted at a narrow place shows more than a speck

class Grower {
 public:
  Grower(const Frame& frame, const Normals& normals, const DepthNoise& noise, const SuperpixelsConfig& config)
      : frame_(frame),
        normals_(normals),
        noise_(noise),
        config_(config),
        min_cosine_(static_cast<float>(std::cos(config.neighbor_deg * M_PI / 180))) {}

  std::vector<int> run(const cv::Mat_<uchar>& smooth) {
    cv::Mat_<float> room;  // to the nearest cut, pixels
    cv::distanceTransform(smooth, room, cv::DIST_L2, 3);
    std::vector<int> order;
    for (int i = 0; i < frame_.size(); ++i) {
      if (smooth(i)) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return room(a) > room(b); });
    parent_.assign(frame_.size(), -1);
    pieces_.assign(frame_.size(), {});
    for (const int pixel : order) add(pixel, room(pixel));
    std::vector<int> piece(frame_.size(), -1);
    for (const int pixel : order) {
      if (largeEnough(root(pixel))) piece[pixel] = root(pixel);
    }
    return piece;
  }

 private:
  struct Piece {
    int pixels = 0;
    double area = 0;  ///< as seen: a pixel spans (z / f)^2; here without 1 / f^2
    float room = 0;   ///< in its middle
  };

  void add(int pixel, float room) {
    const int width = frame_.width(), u = pixel % width, v = pixel / width;
    parent_[pixel] = pixel;
    const double z = frame_.points[pixel].z();
    pieces_[pixel] = {1, z * z, room};
    for (int y = std::max(0, v - 1); y <= std::min(frame_.height() - 1, v + 1); ++y) {
      for (int x = std::max(0, u - 1); x <= std::min(width - 1, u + 1); ++x) {
        const int other = y * width + x;
        if (other == pixel || parent_[other] < 0 || !connected(pixel, other)) continue;
        const int a = root(pixel), b = root(other);
        if (a == b || narrow(a, b, room)) continue;
        const int to = std::min(a, b), from = std::max(a, b);
        parent_[from] = to;
        pieces_[to].pixels += pieces_[from].pixels;
        pieces_[to].area += pieces_[from].area;
        pieces_[to].room = std::max(pieces_[to].room, pieces_[from].room);
      }
    }
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

  int root(int pixel) {
    while (parent_[pixel] != pixel) pixel = parent_[pixel] = parent_[parent_[pixel]];
    return pixel;
  }

  bool connected(int a, int b) const {
    if (!(normals_.normal[a].dot(normals_.normal[b]) > min_cosine_)) return false;
    const double z_a = frame_.points[a].z(), z_b = frame_.points[b].z(), z = std::min(z_a, z_b);
    const double step = std::abs(z_a - z_b);
    return step < kMinGap || step < std::max(kGrazingSlope * z / frame_.camera.focal(), kGapSigmas * noise_.sigma(z));
  }

  const Frame& frame_;
  const Normals& normals_;
  const DepthNoise noise_;
  const SuperpixelsConfig& config_;
  const float min_cosine_;
  std::vector<int> parent_;    ///< -1: not in a piece
  std::vector<Piece> pieces_;  ///< valid at roots
};

}  // namespace

std::vector<int> growPieces(const Frame& frame, const Normals& normals, const DepthNoise& noise,
                            const cv::Mat_<uchar>& smooth, const SuperpixelsConfig& config) {
  return Grower(frame, normals, noise, config).run(smooth);
}

}  // namespace objectness
