// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <random>

#include "fixtures/ray_cast.hpp"
#include "fixtures/temporary_folder.hpp"
#include "objectness_segmentation/io/camera_yaml.hpp"
#include "objectness_segmentation/io/input_file.hpp"

using namespace objectness;
using namespace objectness_test;

namespace {

using Points = std::vector<Eigen::Vector3f>;
using Cell = std::array<int, 3>;

Frame view() {
  Scene scene;
  scene.s2 = 0.0015;
  scene.surfaces = {slab(-0.5, -0.4, 0.5, 0.4, 0), box({-0.1, -0.1, 0}, {0.1, 0.1, 0.15}),
                    sphere({0.25, 0.1, 0.05}, 0.05)};
  return scene.render();
}

Points validPoints(const Frame& frame) {
  Points points;
  for (const Eigen::Vector3f& p : frame.points) {
    if (p.allFinite()) points.push_back(p);
  }
  return points;
}

RawCloud listOf(const Points& points) { return {static_cast<int>(points.size()), 1, points, {}}; }

Cell cellOf(const Eigen::Vector3f& p, float leaf) {
  return {static_cast<int>(std::floor(p.x() / leaf)), static_cast<int>(std::floor(p.y() / leaf)),
          static_cast<int>(std::floor(p.z() / leaf))};
}

/// As pcl::VoxelGrid: the mean of the points of every cell.
Points voxelGrid(const Points& points, float leaf) {
  std::map<Cell, std::pair<Eigen::Vector3d, int>> sums;
  for (const Eigen::Vector3f& p : points) {
    auto& [sum, count] = sums.try_emplace(cellOf(p, leaf), Eigen::Vector3d::Zero(), 0).first->second;
    sum += p.cast<double>();
    ++count;
  }
  Points means;
  for (const auto& [cell, of] : sums) means.push_back((of.first / of.second).cast<float>());
  return means;
}

/// As pcl::UniformSampling: one of the points of every cell.
Points uniformSampling(const Points& points, float leaf) {
  std::map<Cell, Eigen::Vector3f> kept;
  for (const Eigen::Vector3f& p : points) kept.emplace(cellOf(p, leaf), p);
  Points sampled;
  for (const auto& [cell, p] : kept) sampled.push_back(p);
  return sampled;
}

template <class Keep>
Points filtered(const Points& points, const Keep& keep) {
  Points kept;
  for (const Eigen::Vector3f& p : points) {
    if (keep(p)) kept.push_back(p);
  }
  return kept;
}

Status statusOf(const Points& points, const PinholeCamera& camera = kinect()) {
  return makeFrame(listOf(points), camera, {}).status;
}

void expectDownSampled(const Status& status, const std::string& what) {
  EXPECT_EQ(status.code, StatusCode::kNotOrganized) << what;
  EXPECT_NE(status.message.find("down-sampled"), std::string::npos) << what << ": " << status.message;
}

}  // namespace

TEST(ViewCheck, AveragesOfVoxelsAreRefused) {
  const Points points = validPoints(view());
  for (const float leaf : {0.003F, 0.004F, 0.005F, 0.01F, 0.02F}) {
    expectDownSampled(statusOf(voxelGrid(points, leaf)), std::to_string(leaf));
  }
}

TEST(ViewCheck, ViewsThatWereThinnedFarAreRefused) {
  const Points points = validPoints(view());
  for (const float leaf : {0.005F, 0.01F}) {
    expectDownSampled(statusOf(uniformSampling(points, leaf)), std::to_string(leaf));
  }
  const Frame frame = view();
  Points every_fourth;
  for (int i = 0; i < frame.size(); ++i) {
    if (i % 640 % 4 == 0 && i / 640 % 4 == 0 && frame.points[i].allFinite()) every_fourth.push_back(frame.points[i]);
  }
  expectDownSampled(statusOf(every_fourth), "rows and columns");
  EXPECT_TRUE(statusOf(every_fourth, thinned(kinect(), 4)).ok()) << "their own camera takes them";
}

TEST(ViewCheck, PointsThatWereCutOutAreAView) {
  const Points points = validPoints(view());
  const auto passes = [](const Points& some, const std::string& what) {
    const Status status = statusOf(some);
    EXPECT_TRUE(status.ok()) << what << ": " << status.message;
  };
  passes(points, "all");
  passes(filtered(points, [](const auto& p) { return p.z() > 0.7F && p.z() < 1.2F; }), "pass-through");
  passes(filtered(points, [](const auto& p) { return p.cwiseAbs().x() < 0.15F && p.cwiseAbs().y() < 0.1F; }),
         "crop box");
  passes(filtered(points, [](const auto& p) { return std::abs(p.x()) < 0.003F; }), "a strip of pixels");
  std::mt19937 random(5);
  for (const double share : {0.9, 0.7, 0.5}) {
    passes(filtered(points, [&](const auto&) { return random() / 4294967296.0 < share; }),
           "a random share of " + std::to_string(share));
  }
}

TEST(ViewCheck, RoundedCoordinatesAndSlightlyWrongCamerasAreAView) {
  const Points points = validPoints(view());
  for (const float step : {0.0001F, 0.001F}) {
    Points rounded = points;
    for (Eigen::Vector3f& p : rounded) p = (p / step).array().round().matrix() * step;
    EXPECT_TRUE(statusOf(rounded).ok()) << step << ": " << statusOf(rounded).message;
  }
  PinholeCamera camera = kinect();
  camera.cx += 0.4;
  EXPECT_TRUE(statusOf(points, camera).ok());
  camera = kinect(), camera.fx *= 1.0005, camera.fy *= 1.0005;
  EXPECT_TRUE(statusOf(points, camera).ok());
}

TEST(ViewCheck, AveragesOfRoundedVoxelsAreRefused) {
  Points points = voxelGrid(validPoints(view()), 0.004F);
  for (Eigen::Vector3f& p : points) p = (p / 0.001F).array().round().matrix() * 0.001F;
  EXPECT_EQ(statusOf(points).code, StatusCode::kNotOrganized);
}

TEST(ViewCheck, ListsInOtherFramesAreNamed) {
  Points body = validPoints(view());
  for (Eigen::Vector3f& p : body) p = Eigen::Vector3f(p.z(), -p.x(), -p.y());
  RawCloud cloud = listOf(body);
  cloud.frame_id = "camera_link";
  const Status status = makeFrame(cloud, kinect(), {}).status;
  EXPECT_EQ(status.code, StatusCode::kNotOrganized);
  for (const char* text : {"'camera_link' is not the camera's optical frame", "x axis points forward"}) {
    EXPECT_NE(status.message.find(text), std::string::npos) << status.message;
  }
  for (Eigen::Vector3f& p : cloud.points) p = Eigen::AngleAxisf(0.7F, Eigen::Vector3f::UnitX()) * p;
  const Status turned = makeFrame(cloud, kinect(), {}).status;
  EXPECT_NE(turned.message.find("optical frame (x right, y down, z forward) (they are in 'camera_link')"),
            std::string::npos)
      << turned.message;
}

TEST(SharedCases, CloudsOfVoxelGridsAreRefused) {
  const std::string cases = sharedData() + "/../cases/voxel_grid";
  if (sharedData().empty() || !std::filesystem::is_directory(cases)) GTEST_SKIP() << "no shared cases";
  for (const std::string name : {"posecnn_0_2mm", "uoc_0_5mm"}) {
    const auto camera = loadCamera(cases + "/" + name.substr(0, name.rfind('_')) + ".yaml");
    ASSERT_TRUE(camera.ok()) << camera.status.message;
    expectDownSampled(loadInput(cases + "/" + name + ".pcd", camera.value, {}).status, name);
  }
}
