// SPDX-License-Identifier: BSD-3-Clause
// The kernels of table and heights beside the same with Eigen, point by point: equal to the last bit.
#include <gtest/gtest.h>

#include <cstring>
#include <opencv2/imgproc.hpp>

#include "fixtures/random_frame.hpp"
#include "fixtures/ray_cast.hpp"
#include "scene/height_map.hpp"
#include "scene/plane_grid.hpp"
#include "scene/plane_hypotheses.hpp"
#include "scene/plane_samples.hpp"
#include "scene/surface_samples.hpp"
#include "scene/table_evidence.hpp"
#include "scene/wall_patches.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

template <class Value>
bool sameBits(const Value& a, const Value& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

bool samePixels(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && std::memcmp(a.data, b.data, a.total() * a.elemSize()) == 0;
}

/// A table with the rear wall of a bin, which runs out of the picture, and a box before it.
Frame binView() {
  Scene scene;
  scene.surfaces = {slab(-0.5, -0.4, 0.5, 0.4, 0), box({-2, 0.4, -0.2}, {2, 0.5, 0.4}),
                    box({-0.1, 0.1, 0}, {0.1, 0.2, 0.12})};
  scene.s0 = 0.001;
  return scene.render();
}

/// Clears walls plane by plane, patch by patch.
void plainRemoveWalls(const Frame& frame, const Normals& normals, const Table& table, const HeightMap& map,
                      const ObjectPointsConfig& config, cv::Mat_<uchar>& mask) {
  const Eigen::Matrix<double, 2, 3> axes = table.T_table_camera.linear().topRows<2>();
  for (const Plane& plane : table.other_planes) {
    const FastPlane fast(plane);
    cv::Mat_<uchar> candidates(mask.size(), uchar(0));
    for (int i = 0; i < frame.size(); ++i) {
      const Eigen::Vector3f& p = frame.points[i];
      candidates(i) = mask(i) && std::abs(fast.height(p)) <= std::max(0.008f, 4 * float(table.noise.sigma(p.z()))) &&
                      !(normals.radius_px[i] > 0 && normals.normal[i].dot(fast.normal) < 0.866f);
    }
    cv::Mat_<int> label;
    const int count = cv::connectedComponents(candidates, label, 8, CV_32S);
    for (int k = 1; k < count; ++k) {
      int pixels = 0, inside = 0, border = 0, too_high = 0;
      double area = 0;
      for (int v = 0; v < mask.rows; ++v) {
        for (int u = 0; u < mask.cols; ++u) {
          if (label(v, u) != k) continue;
          const Eigen::Vector3d p = frame.points[v * mask.cols + u].cast<double>();
          const Eigen::Vector2d foot = axes * p;
          ++pixels;
          inside += table.extent.at(foot.x(), foot.y()) == TableExtent::kCore;
          border += u == 0 || v == 0 || u + 1 == mask.cols || v + 1 == mask.rows;
          too_high += map.height_m(v, u) > config.max_height_m;
          area += std::pow(p.z() / frame.camera.focal(), 2);
        }
      }
      if (area > 0.004 && inside < 0.5 * pixels && (border > 0.5 * std::sqrt(pixels) || too_high > 0.05 * pixels)) {
        mask.setTo(0, label == k);
      }
    }
  }
}

}  // namespace

TEST(PlaneKernel, CountsAndSumsWhatFits) {
  const Frame frame = randomFrame(120, 90, 3);
  const Normals normals = estimateNormals(frame, {});
  const SurfaceSamples all = sampleSurface(frame, normals, {}, frame.size(), 2);
  PlaneSamples samples;
  for (const auto& sample : all.samples) {
    if (sample.valid() && sample.hasNormal()) samples.add(sample);
  }
  ASSERT_GT(samples.size(), 1000u);
  std::vector<unsigned char> fits(samples.size());
  int total = 0;
  for (std::size_t seed = 0; seed < samples.size(); seed += 501) {
    for (const float tolerances : {1.f, 4.f}) {
      const Eigen::Vector3f n = samples.normal(seed);
      const float d = -n.dot(samples.point(seed));
      const PlaneTest test{n.x(), n.y(), n.z(), d, tolerances, 0.94f};
      const int count = markFitting(samples.columns(), test, fits.data());
      const PlaneSums sums = sumFitting(samples.columns(), fits.data());
      int expected = 0;
      double weight = 0;
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
      for (const auto& sample : all.samples) {
        if (!sample.valid() || !sample.hasNormal()) continue;
        if (!(std::abs(n.dot(sample.point) + d) <= tolerances * sample.tolerance())) continue;
        if (!(sample.normal.dot(n) >= 0.94f)) continue;
        const double w = 1.0 / (double(sample.sigma_m) * sample.sigma_m);
        const Eigen::Vector3d p = sample.point.cast<double>();
        ++expected;
        weight += w;
        sum += w * p;
        products += w * p * p.transpose();
      }
      total += expected;
      ASSERT_EQ(count, expected);
      ASSERT_EQ(sums.count, expected);
      EXPECT_TRUE(sameBits(sums.weight, weight));
      EXPECT_TRUE(sameBits(Eigen::Vector3d(sums.x, sums.y, sums.z), sum));
      EXPECT_TRUE(sameBits(Eigen::Vector3d(sums.xx, sums.yx, sums.zx), Eigen::Vector3d(products.col(0))));
      EXPECT_TRUE(sameBits(Eigen::Vector2d(sums.yy, sums.zy), Eigen::Vector2d(products.col(1).tail<2>())));
      EXPECT_TRUE(sameBits(sums.zz, products(2, 2)));
    }
  }
  EXPECT_GT(total, 1000);
}

TEST(Table, DoesNotDependOnTheNumberOfThreads) {
  const Frame frame = binView();
  const Normals normals = estimateNormals(frame, {});
  const Result<Table> one = findTable(frame, normals, {}, 1), three = findTable(frame, normals, {}, 3);
  ASSERT_TRUE(one.ok()) << one.status.message;
  ASSERT_TRUE(three.ok()) << three.status.message;
  EXPECT_TRUE(sameBits(one.value.normal, three.value.normal));
  EXPECT_TRUE(sameBits(one.value.d, three.value.d));
  EXPECT_TRUE(samePixels(one.value.extent.cells, three.value.extent.cells));
  EXPECT_TRUE(sameBits(one.value.noise.quadratic_per_m, three.value.noise.quadratic_per_m));
  EXPECT_EQ(one.value.other_planes.size(), three.value.other_planes.size());
}

/// findTable() leaves out planes by it.
TEST(TableEvidence, WhatIsQuickToTellOfAPlaneIsABoundOfItsScore) {
  int planes = 0, far_below = 0;
  for (const bool bin : {true, false}) {
    Scene scene;
    scene.surfaces = {slab(-0.5, -0.4, 0.5, 0.4, 0), box({-0.1, 0.1, 0}, {0.1, 0.2, 0.12}), slab(-3, -3, 3, 3, -0.7)};
    const Frame frame = bin ? binView() : scene.render();
    const SurfaceSamples samples = sampleSurface(frame, estimateNormals(frame, {}), DepthNoise(), 40000);
    for (const Plane& plane : findPlanes(samples, 1)) {
      const SeenPlane seen = seePlane(samples, plane);
      const double bound = seen.evidence.score(plane);
      const TableEvidence all = judgeTable(samples, plane, seen, frame.camera.focal());
      EXPECT_LE(all.score(plane), bound);
      EXPECT_EQ(all.area_m2, seen.evidence.area_m2);
      far_below += all.score(plane) < 0.5 * bound;
      ++planes;
    }
  }
  EXPECT_GE(planes, 4);
  EXPECT_GT(far_below, 0) << "the rest of the evidence must count";
}

TEST(PlaneGrid, IsTheSameForAnyNumberOfThreads) {
  const Frame frame = binView();
  const SurfaceSamples samples = sampleSurface(frame, estimateNormals(frame, {}), DepthNoise(), 40000);
  for (const Plane& plane : findPlanes(samples, 1)) {
    const PlaneGrid grid = makePlaneGrid(samples, plane, 0.01);
    ASSERT_FALSE(grid.empty());
    EXPECT_EQ(grid.on_plane.size(), cv::Size(grid.columns, grid.rows));
    EXPECT_EQ(cv::countNonZero(grid.on_plane & grid.seen_through), 0);
    for (const int threads : {2, 7}) {
      const PlaneGrid other = makePlaneGrid(samples, plane, 0.01, threads);
      EXPECT_EQ(other.samples_on_plane, grid.samples_on_plane);
      EXPECT_EQ(other.origin, grid.origin);
      EXPECT_TRUE(samePixels(other.on_plane, grid.on_plane)) << threads;
      EXPECT_TRUE(samePixels(other.seen_through, grid.seen_through)) << threads;
      EXPECT_TRUE(samePixels(other.covered, grid.covered)) << threads;
    }
  }
}

TEST(PlaneSamples, ThoseThatAreLeftStayInTheirOrder) {
  const Frame frame = binView();
  PlaneSamples samples;
  for (const auto& sample : sampleSurface(frame, estimateNormals(frame, {}), DepthNoise(), 1000).samples) {
    if (sample.valid() && sample.hasNormal()) samples.add(sample);
  }
  std::vector<uchar> which(samples.size());
  PlaneSamples expected;
  std::size_t removed = 0;
  for (std::size_t i = 0; i < which.size(); ++i) {
    which[i] = i % 3 == 0 || i > which.size() - 20;
    if (which[i]) {
      ++removed;
    } else {
      expected.add(samples, i);
    }
  }
  samples.remove(which, removed);
  ASSERT_EQ(samples.size(), expected.size());
  ASSERT_GT(expected.size(), 100u);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ASSERT_EQ(samples.point(i), expected.point(i));
    ASSERT_EQ(samples.normal(i), expected.normal(i));
    ASSERT_EQ(samples.columns().weight[i], expected.columns().weight[i]);
  }
}

TEST(HeightMap, IsThatOfEveryPointByItself) {
  Frame frame = binView();
  for (int i = 0; i < frame.size(); i += 13) frame.points[i].setConstant(std::numeric_limits<float>::quiet_NaN());
  const Result<Table> table = findTable(frame, estimateNormals(frame, {}), {});
  ASSERT_TRUE(table.ok()) << table.status.message;
  const ObjectPointsConfig config;
  const HeightMap map = makeHeightMap(frame, table.value, config, 2);
  const FastPlane plane(table.value);
  const Eigen::Matrix<float, 2, 3> axes = table.value.T_table_camera.linear().topRows<2>().cast<float>();
  const TableExtent& extent = table.value.extent;
  ASSERT_GT(cv::countNonZero(extent.cells == TableExtent::kBeyond), 0) << "something to tell apart";
  for (int i = 0; i < frame.size(); ++i) {
    const Eigen::Vector3f& p = frame.points[i];
    if (!(p.z() > 0)) {
      ASSERT_TRUE(std::isnan(map.height_m(i)) && std::isnan(map.threshold_m(i)) && map.inside(i) == 0);
      continue;
    }
    const float h = plane.height(p), cosine = std::abs((h - plane.d) / p.z());
    const float sigma = static_cast<float>(table.value.noise.constant_m) +
                        static_cast<float>(table.value.noise.quadratic_per_m) * p.z() * p.z();
    const float threshold = std::min(
        static_cast<float>(config.max_threshold_m),
        std::max(static_cast<float>(config.min_threshold_m), static_cast<float>(config.noise_sigmas) * sigma * cosine));
    const Eigen::Vector2f cell = (axes * p - extent.origin.cast<float>()) * static_cast<float>(1 / extent.cell_m);
    const bool within = cell.x() >= 0 && cell.y() >= 0 && cell.x() < extent.cells.cols && cell.y() < extent.cells.rows;
    ASSERT_TRUE(sameBits(map.height_m(i), h)) << i;
    ASSERT_TRUE(sameBits(map.threshold_m(i), threshold)) << i;
    const uchar value = within ? extent.cells(int(cell.y()), int(cell.x())) : uchar(0);
    ASSERT_EQ(map.inside(i), value >= TableExtent::kMargin ? 255 : 0) << i;
    ASSERT_EQ(map.beyond(i), value == TableExtent::kBeyond ? 255 : 0) << i;
  }
}

TEST(Walls, AreThoseOfPlaneByPlane) {
  const Frame frame = binView();
  const Normals normals = estimateNormals(frame, {});
  const Result<Table> table = findTable(frame, normals, {});
  ASSERT_TRUE(table.ok()) << table.status.message;
  ASSERT_FALSE(table.value.other_planes.empty());
  const HeightMap map = makeHeightMap(frame, table.value, {});
  const cv::Mat_<uchar> all = aboveTable(map);
  cv::Mat_<uchar> plain = all.clone(), mask = all.clone();
  plainRemoveWalls(frame, normals, table.value, map, {}, plain);
  removeWalls(frame, normals, table.value, map, {}, mask, 2);
  EXPECT_LT(cv::countNonZero(plain), cv::countNonZero(all));
  EXPECT_TRUE(samePixels(mask, plain));
}
