// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "sim/depth_sensor.hpp"

using namespace objectness;
using namespace objectness::sim;
using Eigen::Vector3d;

namespace {

constexpr double kPi = 3.14159265358979323846;

/// A board one millimetre thick whose face goes through (0, 0, z), turned about the vertical; the camera stands in the
/// origin of the world and has its axes.
Body board(double width, double height, double z, double turn_deg, int label) {
  Body body{
      sim::Box{{width, height, 0.001}}, Eigen::Isometry3d::Identity(), {200, 200, 200}, static_cast<ushort>(label)};
  body.T_world_body = Eigen::Translation3d(0, 0, z) * Eigen::AngleAxisd(turn_deg * kPi / 180, Vector3d::UnitY());
  return body;
}

SceneImages picture(const std::vector<Body>& bodies, const DepthSensor& sensor, std::uint32_t seed = 1) {
  return takePicture(bodies, Eigen::Isometry3d::Identity(), sensor, seed);
}

double incidenceOf(const SurfaceView& view, int v, int u) {
  return std::acos(std::min(1.0, -view.at(v, u).normal.dot(view.camera.ray(u, v).normalized())));
}

struct Moments {
  double count = 0, sum = 0, squares = 0;
  void add(double value) { ++count, sum += value, squares += value * value; }
  double mean() const { return sum / count; }
  double deviation() const { return std::sqrt(squares / count - mean() * mean()); }
};

/// Measured minus true depth, metres, of pixels near that depth and incidence.
Moments axialError(double z, double theta_deg) {
  const std::vector<Body> bodies{board(20, 20, z, theta_deg, 1)};
  const DepthSensor sensor;
  const SurfaceView view = viewSurfaces(bodies, Eigen::Isometry3d::Identity(), sensor);
  Moments error;
  for (std::uint32_t seed = 0; seed < 3; ++seed) {
    const SceneImages image = takePicture(view, sensor, seed);
    for (int v = 0; v < 480; ++v) {
      for (int u = 0; u < 640; ++u) {
        const double depth = view.at(v, u).depth_m;
        if (std::abs(depth - z) > 0.03 * z || std::abs(incidenceOf(view, v, u) * 180 / kPi - theta_deg) > 3) continue;
        if (image.depth_mm(v, u) > 0) error.add(image.depth_mm(v, u) / 1000.0 - depth);
      }
    }
  }
  EXPECT_GT(error.count, 5000);
  return error;
}

}  // namespace

TEST(DepthSensor, AxialNoiseIsThePublishedOneWithItsSteps) {
  // Nguyen, Izadi and Lovell 2012: 1.2 mm + 1.9 mm (z - 0.4)^2 + 0.1 mm / sqrt(z) (theta / (pi / 2 - theta))^2.
  EXPECT_NEAR(axialError(1, 5).deviation(), 0.001884, 0.0001);
  EXPECT_NEAR(axialError(2, 5).deviation(), 0.006064, 0.0003);
  EXPECT_NEAR(axialError(1, 60).deviation(), 0.002284, 0.00012);
  EXPECT_NEAR(axialError(2, 60).deviation(), 0.006347, 0.0004);
  EXPECT_NEAR(axialError(1, 5).mean(), 0, 0.0002) << "no bias";
  EXPECT_NEAR(axialError(2, 60).mean(), 0, 0.0006);
}

TEST(DepthSensor, NeighboursShareTheirNoise) {
  const SceneImages image = picture({board(20, 20, 1.2, 0, 1)}, DepthSensor());
  const auto correlation = [&](int distance) {
    double products = 0, squares = 0;
    for (int v = 0; v < 480; ++v) {
      for (int u = 0; u + distance < 640; ++u) {
        const double here = image.depth_mm(v, u) - 1200.0, there = image.depth_mm(v, u + distance) - 1200.0;
        products += here * there, squares += here * here;
      }
    }
    return products / squares;
  };
  EXPECT_NEAR(correlation(1), 0.55, 0.1) << "two of three columns are shared; the steps take some of it";
  EXPECT_NEAR(correlation(4), 0, 0.03);
}

TEST(DepthSensor, DepthComesInStepsOfDisparity) {
  const DepthSensor sensor;
  const SceneImages image = picture({board(20, 20, 2, 0, 1)}, sensor);
  std::set<ushort> depths(image.depth_mm.begin(), image.depth_mm.end());
  ASSERT_GE(depths.size(), 3u);
  for (const ushort depth : depths) {
    const double disparity_steps = 525 * 0.075 / (depth / 1000.0) * 8;
    EXPECT_NEAR(disparity_steps, std::round(disparity_steps), 0.06) << depth << " mm";
  }
  EXPECT_NEAR(sensor.depthStep(2), 0.0127, 0.0001);
  EXPECT_LE(*depths.rbegin() - *depths.begin(), 13.5 * (depths.size() - 1) * 1.05) << "every step is used";
}

TEST(DepthSensor, EdgesAreDisplacedByThePublishedDeviation) {
  Moments edge;
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    const SceneImages image = picture({board(0.4, 20, 1, 0, 20), board(20, 20, 1.2, 0, 1)}, DepthSensor(), seed);
    for (int v = 0; v < 480; ++v) edge.add(cv::countNonZero(image.true_labels.row(v).colRange(320, 640) == 20));
  }
  EXPECT_NEAR(edge.mean(), 0.2 * 525, 0.3);
  EXPECT_NEAR(edge.deviation(), 0.8, 0.08) << "sigma_L at 0 deg";
  EXPECT_NEAR(DepthSensor::lateralSigma(kPi / 3), 0.87, 1e-9) << "0.8 + 0.035 * 2";
}

TEST(DepthSensor, TheShadowIsAsWideAsTheDisparityDiffers) {
  const SceneImages image = picture({board(0.3, 20, 0.8, 0, 20), board(20, 20, 1.6, 0, 1)}, DepthSensor());
  const auto lost = [&](int from, int to) {
    return cv::countNonZero(image.depth_mm.colRange(from, to) == 0) / double(image.depth_mm.rows);
  };
  EXPECT_NEAR(lost(0, 320), 525 * 0.075 * (1 / 0.8 - 1 / 1.6), 1) << "the projector stands right of the camera";
  EXPECT_NEAR(lost(320, 640), 0, 0.01);
}

TEST(DepthSensor, MeasuresWithinItsRangeOnly) {
  for (const auto& [z, share] :
       {std::pair(0.37, 0.0), std::pair(0.42, 1.0), std::pair(3.6, 1.0), std::pair(4.4, 0.0)}) {
    const SceneImages image = picture({board(20, 20, z, 0, 1)}, DepthSensor());
    EXPECT_NEAR(cv::countNonZero(image.depth_mm) / (640.0 * 480), share, 0.01) << z << " m";
    EXPECT_EQ(cv::countNonZero(image.depth_mm), cv::countNonZero(image.true_labels));
  }
}

TEST(DepthSensor, LosesMorePixelsTheFlatterItSees) {
  const std::vector<Body> bodies{board(20, 20, 1, 75, 1)};
  const DepthSensor sensor;
  const SurfaceView view = viewSurfaces(bodies, Eigen::Isometry3d::Identity(), sensor);
  std::map<int, Moments> kept;  // by incidence, in classes of 2 deg
  for (std::uint32_t seed = 0; seed < 4; ++seed) {
    const SceneImages image = takePicture(view, sensor, seed);
    for (int v = 0; v < 480; ++v) {
      for (int u = 0; u < 640; ++u) {
        const double depth = view.at(v, u).depth_m;
        if (depth < 0.6 || depth > 3) continue;
        kept[static_cast<int>(incidenceOf(view, v, u) * 90 / kPi)].add(image.depth_mm(v, u) > 0);
      }
    }
  }
  ASSERT_GE(kept.size(), 5u);
  for (const auto& [two_deg, share] : kept) {
    if (share.count < 5000) continue;
    const double expected = 1 - std::min(1.0, std::max(0.0, (2 * two_deg + 1 - 70) / 14.0));
    EXPECT_NEAR(share.mean(), expected, 0.04) << 2 * two_deg << " deg";
  }
}

TEST(DepthSensor, TheIdealOneIsExact) {
  DepthSensor sensor;
  sensor.ideal = true;
  const std::vector<Body> bodies{board(0.3, 0.4, 0.2, 0, 20), board(20, 20, 5, 80, 1)};
  const SurfaceView view = viewSurfaces(bodies, Eigen::Isometry3d::Identity(), sensor);
  const SceneImages image = takePicture(view, sensor, 9);
  for (int v = 0; v < 480; ++v) {
    for (int u = 0; u < 640; ++u) {
      const SurfacePixel& pixel = view.at(v, u);
      ASSERT_EQ(image.depth_mm(v, u), pixel.body ? std::lround(1000 * pixel.depth_m) : 0);
      ASSERT_EQ(image.true_labels(v, u), pixel.body ? pixel.body->label : 0);
    }
  }
}

TEST(DepthSensor, SeedDecidesEverythingAndThreadsNothing) {
  const std::vector<Body> bodies{board(0.3, 0.4, 0.8, 20, 20), board(20, 20, 1.5, 30, 1)};
  const DepthSensor sensor;
  const Vector3d projector(sensor.baseline_m, 0, 0);
  const Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  const SceneImages one = takePicture(viewSurfaces(bodies, pose, sensor.camera, projector, 1), sensor, 4, 1);
  const SceneImages many = takePicture(viewSurfaces(bodies, pose, sensor.camera, projector, 5), sensor, 4, 3);
  EXPECT_EQ(cv::countNonZero(one.depth_mm != many.depth_mm), 0);
  EXPECT_EQ(cv::countNonZero(one.true_labels != many.true_labels), 0);
  EXPECT_GT(cv::countNonZero(one.depth_mm != picture(bodies, sensor, 5).depth_mm), 10000);
}

TEST(DepthSensor, StereoHasThePublishedNoise) {
  const PinholeCamera camera{615, 615, 319.5, 239.5, 640, 480};
  const DepthSensor sensor = DepthSensor::stereo(camera);
  EXPECT_DOUBLE_EQ(sensor.axialSigma(1), sensor.subpixel_px / (615 * sensor.baseline_m));
  for (const double z : {0.6, 1.2}) {
    const std::vector<Body> bodies{board(20, 20, z, 0, 1)};
    Moments error;
    for (std::uint32_t seed = 0; seed < 8; ++seed) {
      for (const ushort depth : picture(bodies, sensor, seed).depth_mm) {
        if (depth > 0) error.add(depth / 1000.0 - z);
      }
    }
    EXPECT_GT(error.count, 8 * 250000);
    EXPECT_NEAR(error.mean(), -0.0005, 0.0005) << "the board's face is half its thickness nearer";
    const double rounding = 1.0 / 12 * (1e-6 + sensor.depthStep(z) * sensor.depthStep(z));
    EXPECT_NEAR(error.deviation(), std::sqrt(sensor.axialSigma(z) * sensor.axialSigma(z) + rounding),
                0.06 * sensor.axialSigma(z));
  }
}

TEST(DepthSensor, StereoBlendsASmallStepAndKeepsALargeOne) {
  DepthSensor sensor = DepthSensor::stereo({615, 615, 319.5, 239.5, 640, 480});
  sensor.subpixel_px = 0;
  // The step's disparity is 615 * 0.05 * step / z^2: 0.31 px for 1 cm at 1 m, 6.8 px for 18 cm.
  for (const double step : {0.01, 0.18}) {
    std::vector<Body> bodies{board(20, 20, 1, 0, 1), board(10, 20, 1 - step, 0, 2)};
    bodies[1].T_world_body = Eigen::Translation3d(5, 0, 1 - step);
    const SceneImages image = picture(bodies, sensor);
    int between = 0;
    for (int u = 300; u < 340; ++u) {
      const double depth = image.depth_mm(240, u) / 1000.0;
      if (depth > 0 && depth > 1 - step + 0.0025 && depth < 1 - 0.0025) ++between;
    }
    if (step < 0.1) {
      EXPECT_GE(between, 3) << "no ramp";
      EXPECT_LE(between, 16);
    } else {
      EXPECT_EQ(between, 0) << "a ramp from one thing to another";
    }
  }
}
