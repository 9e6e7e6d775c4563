// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstring>

#include "fixtures/ray_cast.hpp"
#include "objectness_segmentation/scene/normals.hpp"
#include "scene/refined_normals.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

const float kNan = std::numeric_limits<float>::quiet_NaN();

double angleDeg(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / M_PI;
}

Scene bareTable() {
  Scene scene;
  scene.surfaces = {slab(-5, -5, 5, 5, 0)};
  return scene;
}

bool sameBits(const std::vector<Eigen::Vector3f>& a, const std::vector<Eigen::Vector3f>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
}

}  // namespace

TEST(Normals, ExactOnAPlane) {
  Scene scene = bareTable();
  const Frame frame = scene.render();
  const Normals normals = estimateNormals(frame, {});
  const Eigen::Vector3f up = (scene.T_world_camera.linear().transpose() * Eigen::Vector3d::UnitZ()).cast<float>();
  int count = 0;
  for (int i = 0; i < frame.size(); ++i) {
    if (normals.radius_px[i] == 0) continue;
    ++count;
    ASSERT_LT(angleDeg(normals.normal[i], up), 0.1) << i % 640 << ", " << i / 640;
    ASSERT_LT(normals.residual_m[i], 2e-5f);
  }
  EXPECT_EQ(count, 638 * 478);  // all but the image border
}

TEST(Normals, WindowFollowsTheDepth) {
  Scene scene = bareTable();
  const Frame frame = scene.render();
  NormalsConfig config;
  config.window_m = 0.01, config.min_window_px = 4, config.max_window_px = 8;
  const Normals normals = estimateNormals(frame, config);
  for (const int i : {100 * 640 + 320, 300 * 640 + 320, 440 * 640 + 320}) {
    const int wanted = static_cast<int>(std::lround(0.01 * 525 / frame.points[i].z()));
    EXPECT_EQ(normals.radius_px[i], std::min(8, std::max(4, wanted)));
  }
  EXPECT_EQ(normals.radius_px[640 * 2 + 320], 2) << "the window may not reach over the image border";
}

TEST(Normals, CloseToTheTruthOnANoisySphere) {
  Scene scene;
  const Eigen::Vector3d centre(0, 0, 0.1);
  scene.surfaces = {sphere(centre, 0.1)};
  scene.s0 = 0.0005;
  const Frame frame = scene.render();
  const Normals normals = estimateNormals(frame, {});
  const Eigen::Vector3f centre_camera = (scene.T_world_camera.inverse() * centre).cast<float>();
  std::vector<double> errors;
  for (int i = 0; i < frame.size(); ++i) {
    if (normals.radius_px[i] == 0) continue;
    EXPECT_LT(normals.normal[i].dot(frame.points[i]), 0) << "towards the camera";
    errors.push_back(angleDeg(normals.normal[i], frame.points[i] - centre_camera));
  }
  ASSERT_GT(errors.size(), 5000u);
  std::nth_element(errors.begin(), errors.begin() + errors.size() / 2, errors.end());
  EXPECT_LT(errors[errors.size() / 2], 3.0);
}

TEST(Normals, AgreeWithPcl) {
  Scene scene = bareTable();
  scene.surfaces.push_back(box({-0.1, -0.1, 0}, {0.1, 0.1, 0.1}));
  const Frame frame = scene.render();
  NormalsConfig config;
  const Normals own = estimateNormals(frame, config);
  config.pcl = true;
  const Normals pcl = estimateNormals(frame, config);
  int both = 0, close = 0;
  for (int i = 0; i < frame.size(); ++i) {
    if (pcl.radius_px[i] == 0) continue;
    ++both;
    close += angleDeg(own.normal[i], pcl.normal[i]) < 3;
  }
  EXPECT_GT(both, 250000);
  EXPECT_GT(close, 0.97 * both);
}

TEST(Normals, JumpBitsMarkAStepAndAHole) {
  const PinholeCamera camera{500, 500, 4, 4, 9, 9};
  Frame frame;
  frame.camera = camera;
  for (int i = 0; i < 81; ++i) {
    const int u = i % 9, v = i / 9;
    frame.points.push_back((camera.ray(u, v) * (u < 5 ? 1.0 : 1.1)).cast<float>());
  }
  frame.points[7 * 9 + 2].setConstant(kNan);
  const Normals normals = estimateNormals(frame, {});
  for (int v = 0; v < 9; ++v) {
    for (int u = 0; u < 9; ++u) {
      const bool right = u == 4 || (v == 7 && (u == 1 || u == 2));
      const bool down = u == 2 && (v == 6 || v == 7);
      EXPECT_EQ(normals.jump[v * 9 + u], (right ? 1 : 0) | (down ? 2 : 0)) << u << ", " << v;
    }
  }
}

TEST(Normals, NoiseAndSlopeSetTheJump) {
  NormalsConfig config;
  Frame frame;
  frame.camera = {500, 500, 0, 0, 2, 1};
  const auto jumps = [&](double dz, const DepthNoise& noise) {
    frame.points = {Eigen::Vector3f(0, 0, 1), Eigen::Vector3f(0.002f, 0, static_cast<float>(1 + dz))};
    return estimateNormals(frame, config, noise).jump[0] == 1;
  };
  EXPECT_FALSE(jumps(0.0155, {0.0001, 0})) << "8 z / f = 16 mm";
  EXPECT_TRUE(jumps(0.0165, {0.0001, 0}));
  EXPECT_FALSE(jumps(0.0295, {0.001, 0.004})) << "6 sigma = 30 mm";
  EXPECT_TRUE(jumps(0.0305, {0.001, 0.004}));
}

TEST(Normals, WindowsStayOnTheirSurface) {
  Scene scene = bareTable();
  scene.surfaces.push_back(slab(-0.2, -0.2, 0.2, 0.2, 0.2));  // floats: all its border is a depth jump
  const Frame frame = scene.render();
  const Normals normals = estimateNormals(frame, {});
  const Eigen::Vector3f up = (scene.T_world_camera.linear().transpose() * Eigen::Vector3d::UnitZ()).cast<float>();
  int wrong = 0, count = 0;
  for (int i = 0; i < frame.size(); ++i) {
    if (normals.radius_px[i] == 0) continue;
    ++count;
    wrong += angleDeg(normals.normal[i], up) > 1;
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(count, 0.97 * frame.size());
}

TEST(Normals, NothingFromNothing) {
  for (const bool pcl : {false, true}) {
    NormalsConfig config;
    config.pcl = pcl;
    for (const cv::Size size : {cv::Size(1, 1), cv::Size(1, 50), cv::Size(64, 48)}) {
      Frame frame;
      frame.camera = {500, 500, 0, 0, size.width, size.height};
      frame.points.assign(frame.size(), Eigen::Vector3f(kNan, kNan, kNan));
      if (size.width == 1) frame.points[0] = Eigen::Vector3f(0, 0, 1);
      const Normals normals = estimateNormals(frame, config);
      ASSERT_EQ(normals.normal.size(), frame.points.size());
      for (const auto& n : normals.normal) EXPECT_FALSE(n.allFinite());
      for (const auto r : normals.radius_px) EXPECT_EQ(r, 0);
    }
  }
}

TEST(Normals, SameTwice) {
  Scene scene = bareTable();
  scene.s0 = 0.001;
  const Frame frame = scene.render();
  EXPECT_TRUE(sameBits(estimateNormals(frame, {}).normal, estimateNormals(frame, {}).normal));
}

TEST(Normals, FittedDepthIsThePlanes) {
  Scene scene = bareTable();
  scene.s0 = 0.002;
  const Frame noisy = scene.render();
  scene.s0 = 0;
  const Frame exact = scene.render();
  const Normals normals = estimateNormals(noisy, {});
  double fitted = 0, raw = 0;
  int count = 0;
  for (int i = 0; i < noisy.size(); ++i) {
    if (normals.radius_px[i] == 0) {
      EXPECT_TRUE(std::isnan(normals.depth_m[i]));
      continue;
    }
    fitted += std::pow(normals.depth_m[i] - exact.points[i].z(), 2);
    raw += std::pow(noisy.points[i].z() - exact.points[i].z(), 2);
    ++count;
  }
  ASSERT_GT(count, 100000);
  EXPECT_NEAR(std::sqrt(raw / count), 0.002, 0.0002);
  EXPECT_LT(std::sqrt(fitted / count), 0.0006);
}

TEST(Normals, AreRefinedWhereTheTablesOwnArePoor) {
  for (const double noise : {0.0005, 0.004}) {
    Scene scene;
    scene.surfaces = {slab(-0.5, -0.4, 0.5, 0.4, 0), box({-0.1, -0.1, 0}, {0.1, 0, 0.12})};
    scene.s0 = noise;
    const Frame frame = scene.render();
    NormalsConfig config;
    const Normals first = estimateNormals(frame, config);
    const Result<Table> table = findTable(frame, first, {});
    ASSERT_TRUE(table.ok()) << table.status.message;
    const double before = tableNormalError(frame, first, table.value);
    const Normals refined = refineNormals(frame, first, table.value, config);
    const double after = tableNormalError(frame, refined, table.value);
    if (before <= config.max_error_deg) {
      EXPECT_LT(noise, 0.001);
      EXPECT_TRUE(sameBits(first.normal, refined.normal));
    } else {
      EXPECT_GT(noise, 0.001) << before << " degrees";
      EXPECT_LT(after, 0.8 * before);
    }
  }
}
