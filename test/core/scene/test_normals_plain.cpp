// SPDX-License-Identifier: BSD-3-Clause
// The normals' kernels beside what they compute written down pixel by pixel: equal to the last bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "fixtures/random_frame.hpp"
#include "objectness_segmentation/scene/normals.hpp"
#include "scene/depth_discontinuities.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

struct Size {
  int width, height;
};
constexpr Size kSizes[] = {{1, 1}, {1, 9}, {9, 1}, {2, 2}, {7, 5}, {33, 17}, {131, 77}, {320, 240}};

class PlainNormals {
 public:
  PlainNormals(const Frame& frame, const NormalsConfig& config, const DepthNoise& noise)
      : frame_(frame), config_(config), noise_(noise) {}

  bool apart(int pixel, int other) const {
    const float a = frame_.points[pixel].z(), b = frame_.points[other].z(), z = std::min(a, b);
    const float noise = static_cast<float>(config_.jump_sigmas * noise_.constant_m) +
                        static_cast<float>(config_.jump_sigmas * noise_.quadratic_per_m) * z * z;
    return !(std::abs(a - b) <= std::max(noise, static_cast<float>(config_.jump_slope / frame_.camera.focal()) * z));
  }

  /// Whether the two pixels, 8-neighbours, see one surface: there is a way without a jump along rows and columns.
  bool joined(int u, int v, int x, int y) const {
    const auto at = [&](int column, int row) { return row * frame_.width() + column; };
    if (u == x || v == y) return !apart(at(u, v), at(x, y));
    return (!apart(at(u, v), at(x, v)) && !apart(at(x, v), at(x, y))) ||
           (!apart(at(u, v), at(u, y)) && !apart(at(u, y), at(x, y)));
  }

  cv::Mat_<uchar> clear() const {
    cv::Mat_<uchar> result(frame_.height(), frame_.width(), uchar(0));
    for (int v = 1; v + 1 < frame_.height(); ++v) {
      for (int u = 1; u + 1 < frame_.width(); ++u) {
        bool all = true;
        for (int y = v - 1; y <= v + 1; ++y) {
          for (int x = u - 1; x <= u + 1; ++x) all = all && ((x == u && y == v) || joined(u, v, x, y));
        }
        result(v, u) = all ? 255 : 0;
      }
    }
    return result;
  }

  int radius(const cv::Mat_<uchar>& clear, int u, int v) const {
    int nearest = 255;
    for (int y = 0; y < clear.rows; ++y) {
      for (int x = 0; x < clear.cols; ++x) {
        if (clear(y, x) == 0) nearest = std::min(nearest, std::max(std::abs(x - u), std::abs(y - v)));
      }
    }
    return nearest;
  }

  /// 1/z = a (u - u0) + b (v - v0) + c, summed up pixel by pixel.
  bool fit(int u0, int v0, int radius, Eigen::Vector3f& normal, float& residual_m, float& depth_m) const {
    constexpr double kScale = 1048576;
    std::int64_t w_sum = 0, uw = 0, vw = 0, ww = 0;
    for (int v = v0 - radius; v <= v0 + radius; ++v) {
      for (int u = u0 - radius; u <= u0 + radius; ++u) {
        const float z = frame_.points[v * frame_.width() + u].z();
        const auto w = static_cast<std::int64_t>(kScale * (1.0f / z) + 0.5);
        w_sum += w, uw += w * (u - u0), vw += w * (v - v0), ww += w * w;
      }
    }
    const PinholeCamera& k = frame_.camera;
    const double n = (2 * radius + 1) * (2 * radius + 1), moment = n * radius * (radius + 1) / 3.0;
    const double a = uw / moment, b = vw / moment, c = w_sum / n;
    const Eigen::Vector3d away(a * k.fx, b * k.fy, a * (k.cx - u0) + b * (k.cy - v0) + c);
    const double norm = away.norm();
    const double variance = std::max(0.0, (double(ww) - c * double(w_sum) - a * double(uw) - b * double(vw)) / n);
    const double z = kScale / c, depth_residual = std::sqrt(variance) / kScale * z * z;
    normal = (-away / norm).cast<float>();
    residual_m = static_cast<float>(depth_residual * c / norm);
    depth_m = static_cast<float>(z);
    return normal.dot(frame_.points[v0 * frame_.width() + u0]) < 0;
  }

 private:
  const Frame& frame_;
  const NormalsConfig& config_;
  const DepthNoise noise_;
};

bool sameBits(float a, float b) { return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b)); }

}  // namespace

TEST(PlainNormals, JumpsAndWindowsAreTheSame) {
  for (const Size size : kSizes) {
    if (size.width > 200) continue;  // the plain distance looks at all pixels for each
    const Frame frame = randomFrame(size.width, size.height, 10 * size.width + size.height);
    const NormalsConfig config;
    const PlainNormals plain(frame, config, {});
    const cv::Mat_<uchar> plain_clear = plain.clear();
    for (const int threads : {1, 3}) {
      const std::vector<unsigned char> jump = findDepthDiscontinuities(frame, config, {}, threads);
      const cv::Mat_<uchar> clear = clearRadius(frame, jump, threads),
                            short_sighted = clearRadius(frame, jump, threads, 6);
      for (int v = 0, i = 0; v < size.height; ++v) {
        for (int u = 0; u < size.width; ++u, ++i) {
          const int right = u + 1 < size.width && plain.apart(i, i + 1);
          const int down = v + 1 < size.height && plain.apart(i, i + size.width);
          ASSERT_EQ(jump[i], right + 2 * down) << u << ", " << v << " of " << size.width;
          ASSERT_EQ(clear(v, u), plain.radius(plain_clear, u, v)) << u << ", " << v << " of " << size.width;
          ASSERT_EQ(short_sighted(v, u), std::min<int>(6, clear(v, u))) << u << ", " << v << " of " << size.width;
        }
      }
    }
  }
}

TEST(PlainNormals, FitsAreTheSame) {
  for (const Size size : kSizes) {
    const Frame frame = randomFrame(size.width, size.height, size.width + size.height);
    NormalsConfig config;
    config.window_m = 0.02;
    const PlainNormals plain(frame, config, {});
    for (const int threads : {1, 2}) {
      const Normals normals = estimateNormals(frame, config, {}, threads);
      const cv::Mat_<uchar> clear = clearRadius(frame, normals.jump);
      for (int v = 0, i = 0; v < size.height; ++v) {
        for (int u = 0; u < size.width; ++u, ++i) {
          int radius = 0;
          if (clear(v, u) > 0) {
            const float window = static_cast<float>(config.window_m * frame.camera.focal());
            const int wanted = static_cast<int>(std::min(window / frame.points[i].z() + 0.5f, 255.0f));
            radius = std::min<int>(std::max(config.min_window_px, std::min(wanted, config.max_window_px)), clear(v, u));
          }
          Eigen::Vector3f normal;
          float residual_m, depth_m;
          if (radius == 0 || !plain.fit(u, v, radius, normal, residual_m, depth_m)) {
            ASSERT_EQ(normals.radius_px[i], 0);
            ASSERT_FALSE(normals.normal[i].allFinite());
            continue;
          }
          ASSERT_EQ(normals.radius_px[i], radius);
          for (int k = 0; k < 3; ++k) ASSERT_TRUE(sameBits(normals.normal[i][k], normal[k])) << u << ", " << v;
          ASSERT_TRUE(sameBits(normals.residual_m[i], residual_m)) << u << ", " << v;
          ASSERT_TRUE(sameBits(normals.depth_m[i], depth_m)) << u << ", " << v;
        }
      }
    }
  }
}
