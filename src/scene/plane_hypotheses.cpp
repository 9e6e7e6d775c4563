// SPDX-License-Identifier: BSD-3-Clause
#include "plane_hypotheses.hpp"

#include <algorithm>
#include <cmath>
#include <random>

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

using Sample = SurfaceSamples::Sample;

bool fits(const FastPlane& plane, const Sample& sample, float tolerances) {
  return std::abs(plane.height(sample.point)) <= tolerances * sample.tolerance() &&
         sample.normal.dot(plane.normal) >= kMinNormalCosine;
}

bool refit(const std::vector<const Sample*>& samples, float tolerances, Plane& plane) {
  const FastPlane current(plane);
  PlaneFitter fitter;
  for (const Sample* sample : samples) {
    if (fits(current, *sample, tolerances))
      fitter.add(sample->point, 1.0 / (double(sample->sigma_m) * sample->sigma_m));
  }
  return fitter.solve(plane);
}

int countInliers(const std::vector<const Sample*>& samples, const Plane& plane) {
  const FastPlane fast(plane);
  return static_cast<int>(
      std::count_if(samples.begin(), samples.end(), [&](const Sample* sample) { return fits(fast, *sample, 1); }));
}

/// The best of some planes through a random sample and its normal; false when there is none.
bool searchPlane(const std::vector<const Sample*>& samples, std::mt19937& random, Plane& best) {
  std::vector<const Sample*> counted;
  const std::size_t step = 1 + samples.size() / kCountedSamples;
  for (std::size_t i = 0; i < samples.size(); i += step) counted.push_back(samples[i]);
  int best_count = 0;
  for (int attempt = 0; attempt < kTries; ++attempt) {
    const Sample& seed = *samples[random() % samples.size()];
    Plane plane;
    plane.normal = seed.normal.cast<double>();
    plane.d = -plane.normal.dot(seed.point.cast<double>());
    if (!refit(counted, kWideTolerances, plane)) continue;
    const int count = countInliers(counted, plane);
    if (count > best_count) best_count = count, best = plane;
  }
  for (int i = 0; i < kRefits && best_count > 0; ++i) {
    if (!refit(samples, 1, best)) return false;
  }
  return best_count > 0;
}

/// Whether the inliers of one plane also lie on the other.
bool samePlane(const Plane& a, const Plane& b, const std::vector<const Sample*>& inliers_of_b) {
  if (a.normal.dot(b.normal) < kSamePlaneCosine) return false;
  const FastPlane fast(a);
  double distance = 0, tolerance = 0;
  for (const Sample* sample : inliers_of_b) {
    distance += std::abs(fast.height(sample->point));
    tolerance += sample->tolerance();
  }
  return distance < 2 * tolerance;
}

}  // namespace

std::vector<Plane> findPlanes(const SurfaceSamples& all) {
  std::vector<const Sample*> left;
  for (const Sample& sample : all.samples) {
    if (sample.valid() && sample.hasNormal()) left.push_back(&sample);
  }
  const std::size_t min_inliers = std::max<std::size_t>(10, static_cast<std::size_t>(kMinShare * left.size()));

  std::vector<Plane> planes;
  std::mt19937 random(1);
  for (int i = 0; i < kMaxPlanes && left.size() >= min_inliers; ++i) {
    Plane plane;
    if (!searchPlane(left, random, plane)) break;
    const FastPlane fast(plane);
    std::vector<const Sample*> inliers, others;
    for (const Sample* sample : left) (fits(fast, *sample, 1) ? inliers : others).push_back(sample);
    if (inliers.size() < min_inliers) break;
    const bool known =
        std::any_of(planes.begin(), planes.end(), [&](const Plane& other) { return samePlane(other, plane, inliers); });
    if (!known) planes.push_back(plane);
    left = std::move(others);
  }
  return planes;
}

}  // namespace objectness
