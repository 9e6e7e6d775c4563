// SPDX-License-Identifier: BSD-3-Clause
#include "cues/watershed.hpp"

#include <algorithm>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "cues/radix_order.hpp"

namespace objectness {
namespace {

constexpr double kPartSize =
    3;  // times the smallest piece: only parts larger than a speck are separated at a narrow place

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
  Grower(const Frame& frame, const SmoothSurface& surface, const SuperpixelsConfig& config)
      : frame_(frame),
        surface_(surface),
        config_(config),
        min_area_(config.min_area_m2 * frame.camera.fx * frame.camera.fy),
        tree_(surface.smooth.total(), kNotYet) {}

  cv::Mat_<int> run() {
    const cv::Mat_<float> room = roomOf(surface_.smooth);
    std::vector<int> pixels;
    std::vector<float> rooms;
    for (int i = 0; i < frame_.size(); ++i) {
      if (!surface_.smooth.data[i]) continue;
      pixels.push_back(i);
      rooms.push_back(room(i));
    }
    for (const int k : descendingOrder(rooms)) add(pixels[k], rooms[k]);

    cv::Mat_<int> name(surface_.smooth.size(), -1);
    for (const int pixel : pixels) {
      const Piece& piece = pieces_[pieceOf(root(pixel))];
      if (largeEnough(piece)) name(pixel) = piece.first;
    }
    return name;
  }

 private:
  // A pixel of the tree has its parent, a root its piece as ~index.
  static constexpr int kNotYet = std::numeric_limits<int>::min();

  struct Piece {
    int first;  ///< of its pixels
    int pixels;
    float room;   ///< in its middle
    double area;  ///< as seen: a pixel spans (z / f)^2; here without 1 / f^2
  };

  void add(int pixel, float room) {
    const int width = surface_.smooth.cols, u = pixel % width, v = pixel / width;
    const double z = frame_.points[pixel].z();
    int own = -1;
    const auto meet = [&](int neighbour) {
      if (tree_[neighbour] == kNotYet) return;
      const int other = root(neighbour);
      own = own < 0 ? joinAlone(pixel, z * z, other) : join(own, other, room);
    };
    const uchar* ways = surface_.ways.data + pixel;
    if (v > 0) {
      if (u > 0 && (ways[-width - 1] & SmoothSurface::kLowerRight)) meet(pixel - width - 1);
      if (ways[-width] & SmoothSurface::kDown) meet(pixel - width);
      if (u + 1 < width && (ways[-width + 1] & SmoothSurface::kLowerLeft)) meet(pixel - width + 1);
    }
    if (u > 0 && (ways[-1] & SmoothSurface::kRight)) meet(pixel - 1);
    if (*ways & SmoothSurface::kRight) meet(pixel + 1);
    if (*ways & SmoothSurface::kLowerLeft) meet(pixel + width - 1);
    if (*ways & SmoothSurface::kDown) meet(pixel + width);
    if (*ways & SmoothSurface::kLowerRight) meet(pixel + width + 1);
    if (own >= 0) return;
    tree_[pixel] = ~static_cast<int>(pieces_.size());
    pieces_.push_back({pixel, 1, room, z * z});
  }

  /// A pixel by itself is no part that a narrow place keeps apart. Returns the root.
  int joinAlone(int pixel, double area, int to) {
    tree_[pixel] = to;
    Piece& piece = pieces_[pieceOf(to)];
    piece.first = std::min(piece.first, pixel);
    ++piece.pixels;
    piece.area += area;
    return to;
  }

  /// Joins the pieces of two roots, unless the place of this room between them is narrow; the root of the first.
  int join(int a, int b, float room) {
    if (a == b) return a;
    Piece &piece_a = pieces_[pieceOf(a)], &piece_b = pieces_[pieceOf(b)];
    if (narrow(piece_a, piece_b, room)) return a;
    const bool keep_a = piece_a.pixels >= piece_b.pixels;
    Piece &to = keep_a ? piece_a : piece_b, &from = keep_a ? piece_b : piece_a;
    to.first = std::min(to.first, from.first);
    to.pixels += from.pixels;
    to.area += from.area;
    to.room = std::max(to.room, from.room);
    const int root = keep_a ? a : b;
    tree_[keep_a ? b : a] = root;
    return root;
  }

  bool largeEnough(const Piece& piece, double times = 1) const {
    return piece.pixels >= times * config_.min_pixels && piece.area >= times * min_area_;
  }

  bool narrow(const Piece& a, const Piece& b, float room) const {
    return room < config_.narrow_share * std::min(a.room, b.room) && largeEnough(a, kPartSize) &&
           largeEnough(b, kPartSize);
  }

  int pieceOf(int root) const { return ~tree_[root]; }

  int root(int pixel) {
    for (;;) {
      const int parent = tree_[pixel];
      if (parent < 0) return pixel;
      const int above = tree_[parent];
      if (above < 0) return parent;
      pixel = tree_[pixel] = above;
    }
  }

  const Frame& frame_;
  const SmoothSurface& surface_;
  const SuperpixelsConfig& config_;
  const double min_area_;      ///< as Piece::area
  std::vector<int> tree_;      ///< by pixel
  std::vector<Piece> pieces_;  ///< valid for roots
};

}  // namespace

cv::Mat_<int> growRegions(const Frame& frame, const SmoothSurface& surface, const SuperpixelsConfig& config) {
  return Grower(frame, surface, config).run();
}

}  // namespace objectness
