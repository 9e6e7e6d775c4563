// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "sim/time_of_flight.hpp"

using namespace objectness;
using namespace objectness::sim;
using Eigen::Vector3d;

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kPhasePerMetre = 4 * kPi * 100e6 / 299792458;

/// A board whose face goes through (x, 0, z), turned about the vertical, seen by a camera in the origin of the world.
Body board(double width, double x, double z, double turn_deg, int label) {
  Body body{sim::Box{{width, 20, 0.001}}, Eigen::Isometry3d::Identity(), {200, 200, 200}, static_cast<ushort>(label)};
  body.T_world_body = Eigen::Translation3d(x, 0, z) * Eigen::AngleAxisd(turn_deg * kPi / 180, Vector3d::UnitY());
  return body;
}

DepthSensor sensorWithout(double wiggle_m = 0) {
  DepthSensor sensor = DepthSensor::timeOfFlight({160, 160, 79.5, 59.5, 160, 120});
  sensor.wiggle_m = wiggle_m;
  return sensor;
}

SurfaceView view(const std::vector<Body>& bodies, const DepthSensor& sensor) {
  return viewSurfaces(bodies, Eigen::Isometry3d::Identity(), sensor);
}

}  // namespace

TEST(TimeOfFlight, ABoardSeenStraightIsWhereItIs) {
  const std::vector<Body> bodies{board(20, 0, 1.2, 0, 1)};
  const DepthSensor sensor = sensorWithout();
  const cv::Mat_<double> depth = timeOfFlightDepths(view(bodies, sensor), sensor, 2);
  for (const double z : depth) EXPECT_NEAR(z, 1.2, 1e-9);
}

TEST(TimeOfFlight, PhaseIsOffByAWaveOfTheDistance) {
  for (const double z : {0.7, 0.8, 0.9, 1.0}) {
    const std::vector<Body> bodies{board(20, 0, z, 0, 1)};
    const DepthSensor sensor = sensorWithout(0.003);
    const double depth = timeOfFlightDepths(view(bodies, sensor), sensor, 1)(60, 80);
    EXPECT_NEAR(depth - z, 0.003 * std::sin(4 * kPhasePerMetre * z), 1e-4) << z;
  }
}

TEST(TimeOfFlight, PixelsOnAnEdgeLieBetweenItsSides) {
  const std::vector<Body> bodies{board(0.4, -0.2, 0.9, 0, 20), board(20, 0, 1.1, 0, 1)};
  const DepthSensor sensor = sensorWithout();
  const SurfaceView seen = view(bodies, sensor);
  const cv::Mat_<double> depth = timeOfFlightDepths(seen, sensor, 2);
  int flying = 0;
  for (int v = 2; v < 118; ++v) {
    for (int u = 2; u < 158; ++u) {
      const bool near_edge = seen.at(v, u - 1).body != seen.at(v, u + 1).body;
      if (!near_edge) {
        EXPECT_NEAR(depth(v, u), seen.at(v, u).depth_m, 1e-3);
        continue;
      }
      // By hand: three columns with weights of 1, 2 and 1, of light that falls with the square of the distance.
      std::complex<double> sum = 0;
      for (int k = -1; k <= 1; ++k) {
        for (int j = -1; j <= 1; ++j) {
          const Vector3d p = seen.camera.ray(u + k, v + j) * seen.at(v + j, u + k).depth_m;
          const double cosine = p.z() / p.norm();
          sum += std::polar((k == 0 ? 2 : 1) * (j == 0 ? 2 : 1) * cosine / p.squaredNorm(),
                            kPhasePerMetre * p.z() * seen.camera.ray(u, v).norm());
        }
      }
      const double phase = std::arg(sum) + (std::arg(sum) < 0 ? 2 * kPi : 0);
      const double distance = phase / kPhasePerMetre, along = seen.camera.ray(u, v).norm();
      EXPECT_NEAR(depth(v, u), distance / along, 1e-6);
      flying += depth(v, u) > 0.93 && depth(v, u) < 1.07;
    }
  }
  EXPECT_GT(flying, 100);
}

TEST(TimeOfFlight, LightThatContradictsItselfGivesNoDepth) {
  // Half a turn of phase apart, and as bright: 0.75 m and what is 1.5 m less than a turn behind.
  const std::vector<Body> bodies{board(0.4, -0.2, 1.0, 0, 20), board(20, 0, 1.75, 0, 1)};
  const DepthSensor sensor = sensorWithout();
  const SurfaceView seen = view(bodies, sensor);
  const cv::Mat_<double> depth = timeOfFlightDepths(seen, sensor, 2);
  int lost = 0;
  for (int v = 2; v < 118; ++v) {
    for (int u = 2; u < 158; ++u) {
      if (depth(v, u) == 0) {
        ++lost;
        EXPECT_NE(seen.at(v, u - 1).body, seen.at(v, u + 1).body) << u;
      }
    }
  }
  EXPECT_GT(lost, 50);
}

TEST(TimeOfFlight, ConcaveCornersAreRounderAndFarther) {
  const std::vector<Body> corner{board(2, 0.7071, 1.2 - 0.7071, 45, 1), board(2, -0.7071, 1.2 - 0.7071, -45, 2)};
  const DepthSensor sensor = sensorWithout();
  const SurfaceView seen = view(corner, sensor);
  const cv::Mat_<double> depth = timeOfFlightDepths(seen, sensor, 2);
  const auto farther = [&](int u) { return depth(60, u) - seen.at(60, u).depth_m; };
  ASSERT_NE(seen.at(60, 60).body, seen.at(60, 100).body);
  EXPECT_GT(farther(72), 0.001) << "light comes by way of the other side";
  EXPECT_LT(farther(72), 0.03);
  EXPECT_GT(farther(72), 2 * farther(40));
  EXPECT_NEAR(farther(72), farther(159 - 72), 5e-4) << "both sides alike";
}

TEST(TimeOfFlight, DoesNotDependOnTheNumberOfThreads) {
  const std::vector<Body> corner{board(2, 0.7071, 1.2 - 0.7071, 45, 1), board(2, -0.7071, 1.2 - 0.7071, -45, 2)};
  const DepthSensor sensor = sensorWithout(0.001);
  const SurfaceView seen = view(corner, sensor);
  const cv::Mat_<double> one = timeOfFlightDepths(seen, sensor, 1), four = timeOfFlightDepths(seen, sensor, 4);
  EXPECT_EQ(cv::countNonZero(one != four), 0);
}

TEST(TimeOfFlight, NoiseGrowsWithTheDistanceAndTheAngle) {
  for (const auto& [z, turn_deg] : {std::pair(1.0, 0.0), std::pair(2.0, 0.0), std::pair(1.2, 60.0)}) {
    const std::vector<Body> bodies{board(20, 0, z, turn_deg, 1)};
    const DepthSensor sensor = sensorWithout();
    const SurfaceView seen = view(bodies, sensor);
    const cv::Mat_<double> exact = timeOfFlightDepths(seen, sensor, 2);
    double squares = 0, expected = 0;
    int count = 0;
    for (std::uint32_t seed = 0; seed < 4; ++seed) {
      const SceneImages image = takePicture(seen, sensor, seed);
      for (int v = 0; v < 120; ++v) {
        for (int u = 60; u < 100; ++u) {
          if (image.depth_mm(v, u) == 0) continue;
          const double theta = std::acos(-seen.at(v, u).normal.dot(seen.camera.ray(u, v).normalized()));
          const double cosine = std::cos(theta), sigma = 0.001 * seen.at(v, u).depth_m / std::sqrt(cosine);
          const double error = image.depth_mm(v, u) / 1000.0 - exact(v, u);
          squares += error * error;
          expected += sigma * sigma + 0.001 * 0.001 / 12;  // rounded to a millimetre
          ++count;
        }
      }
    }
    ASSERT_GT(count, 10000);
    EXPECT_NEAR(std::sqrt(squares / count), std::sqrt(expected / count), 0.06 * std::sqrt(expected / count)) << z;
  }
}
