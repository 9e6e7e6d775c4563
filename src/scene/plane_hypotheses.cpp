// SPDX-License-Identifier: BSD-3-Clause
#include "scene/plane_hypotheses.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "common/parallel.hpp"
#include "scene/plane_samples.hpp"

namespace objectness {
namespace {

constexpr int kMaxPlanes = 8;
constexpr int kTries = 60;
constexpr int kCountedSamples = 3000;  // a try is judged on a part of the samples, the final fits use all
constexpr double kMinShare = 0.012;    // of the samples; smaller planes are object faces
constexpr int kRefits = 3;
constexpr float kMinNormalCosine = 0.9397f;  // 20 deg: the spread of normals on a noisy table
constexpr float kWideTolerances = 4.0f;      // a plane through one point and its noisy normal is only about right
constexpr double kSamePlaneCosine = 0.9945;  // 6 deg

PlaneTest planeTest(const Plane& plane, float tolerances) {
  const FastPlane fast(plane);
  return {fast.normal.x(), fast.normal.y(), fast.normal.z(), fast.d, tolerances, kMinNormalCosine};
}

bool refit(const SampleColumns& samples, float tolerances, std::vector<uchar>& fits, Plane& plane) {
  fits.resize(samples.count);
  markFitting(samples, planeTest(plane, tolerances), fits.data());
  return PlaneFitter(sumFitting(samples, fits.data())).solve(plane);
}

/// A plane through a sample and its normal, settled on the samples near it.
struct Try {
  Plane plane;
  int count = 0;  ///< of the samples that fit; 0: no plane

  void settle(const SampleColumns& counted) {
    std::vector<uchar> fits;
    if (refit(counted, kWideTolerances, fits, plane)) count = markFitting(counted, planeTest(plane, 1), fits.data());
  }
};

/// The best of some planes through a random sample and its normal; false when there is none.
bool searchPlane(const PlaneSamples& samples, std::mt19937& random, int threads, Plane& best) {
  PlaneSamples counted;
  const std::size_t step = 1 + samples.size() / kCountedSamples;
  for (std::size_t i = 0; i < samples.size(); i += step) counted.add(samples, i);

  std::vector<Try> tries(kTries);
  for (Try& attempt : tries) {
    const std::size_t seed = random() % samples.size();
    attempt.plane.normal = samples.normal(seed).cast<double>();
    attempt.plane.d = -attempt.plane.normal.dot(samples.point(seed).cast<double>());
  }
  parallelFor(kTries, threads, [&](int i) { tries[i].settle(counted.columns()); });
  const Try& most =
      *std::max_element(tries.begin(), tries.end(), [](const Try& a, const Try& b) { return a.count < b.count; });
  if (most.count == 0) return false;
  best = most.plane;
  std::vector<uchar> fits;
  for (int i = 0; i < kRefits; ++i) {
    if (!refit(samples.columns(), 1, fits, best)) return false;
  }
  return true;
}

/// Whether the inliers of one plane also lie on the other.
bool samePlane(const Plane& a, const Plane& b, const PlaneSamples& samples, const std::vector<uchar>& on_b) {
  if (a.normal.dot(b.normal) < kSamePlaneCosine) return false;
  const FastPlane fast(a);
  double distance = 0, tolerance = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!on_b[i]) continue;
    distance += std::abs(fast.height(samples.point(i)));
    tolerance += samples.tolerance_m(i);
  }
  return distance < 2 * tolerance;
}

}  // namespace

std::vector<Plane> findPlanes(const SurfaceSamples& all, int threads) {
  PlaneSamples left;
  left.reserve(all.samples.size());
  for (const auto& sample : all.samples) {
    if (sample.valid() && sample.hasNormal()) left.add(sample);
  }
  const std::size_t min_inliers = std::max<std::size_t>(10, static_cast<std::size_t>(kMinShare * left.size()));

  std::vector<Plane> planes;
  std::vector<uchar> fits;
  std::mt19937 random(1);
  for (int i = 0; i < kMaxPlanes && left.size() >= min_inliers; ++i) {
    Plane plane;
    if (!searchPlane(left, random, threads, plane)) break;
    fits.resize(left.size());
    const std::size_t found = markFitting(left.columns(), planeTest(plane, 1), fits.data());
    if (found < min_inliers) break;
    const bool known = std::any_of(planes.begin(), planes.end(),
                                   [&](const Plane& other) { return samePlane(other, plane, left, fits); });
    if (!known) planes.push_back(plane);
    left.remove(fits, found);
  }
  return planes;
}

}  // namespace objectness
