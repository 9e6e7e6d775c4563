// SPDX-License-Identifier: BSD-3-Clause
#include "cues/bend_kernel.hpp"

#include "common/target_clones.hpp"

namespace objectness {
namespace {

struct Vector {
  float x, y, z;
};

inline Vector at(const float* xyz, int i) { return {xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]}; }
inline Vector minus(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector times(const Vector& a, float s) { return {a.x * s, a.y * s, a.z * s}; }
inline float dot(const Vector& a, const Vector& b) { return a.x * b.x + (a.y * b.y + a.z * b.z); }
inline float larger(float a, float b) { return a < b ? b : a; }
inline float magnitude(float a) { return a < 0 ? -a : a; }

}  // namespace

OBJECTNESS_CLONES("avx2")
void bendRun(const SideRow& a, const SideRow& b, int count, int radius, int direction, unsigned char* waiting,
             const BendRow& bends) {
  const SideRow s = a, t = b;
  float *convex = bends.convex, *concave = bends.concave;
  unsigned char* directions = bends.direction;
#pragma GCC ivdep
  for (int i = 0; i < count; ++i) {
    const bool compared = (waiting[i] != 0) & (s.radius_px[i] >= radius) & (t.radius_px[i] >= radius);
    const Vector n_a = at(s.normals, i), n_b = at(t.normals, i);
    const float bend = compared ? 1.f - dot(n_a, n_b) : 0.f;
    const bool is_convex = dot(minus(n_b, n_a), minus(at(t.points, i), at(s.points, i))) > 0;
    const float most = larger(convex[i], concave[i]);
    directions[i] = bend > most ? static_cast<unsigned char>(direction) : directions[i];
    convex[i] = is_convex ? larger(convex[i], bend) : convex[i];
    concave[i] = is_convex ? concave[i] : larger(concave[i], bend);
    waiting[i] = compared ? 0 : waiting[i];
  }
}

OBJECTNESS_CLONES("avx2")
void stepRun(const SideRow& a, const SideRow& b, int count, int radius, float min_cosine, unsigned char* waiting,
             float* largest) {
  const SideRow s = a, t = b;
#pragma GCC ivdep
  for (int i = 0; i < count; ++i) {
    const bool compared = (waiting[i] != 0) & (s.radius_px[i] >= radius) & (t.radius_px[i] >= radius);
    const Vector n_a = at(s.normals, i), n_b = at(t.normals, i), p_a = at(s.points, i), p_b = at(t.points, i);
    const bool counts = compared & (s.where[i] != 0) & (t.where[i] != 0) & (dot(n_a, n_b) >= min_cosine);
    // The points of the fitted planes in the direction of the pixels.
    const Vector between = minus(times(p_b, t.depths[i] / p_b.z), times(p_a, s.depths[i] / p_a.z));
    const float from_a = dot(n_a, between), from_b = dot(n_b, between);
    const float smaller = magnitude(from_b) < magnitude(from_a) ? magnitude(from_b) : magnitude(from_a);
    const float step = counts & (from_a * from_b > 0) ? smaller : 0.f;
    largest[i] = larger(largest[i], step);
    waiting[i] = compared ? 0 : waiting[i];
  }
}

}  // namespace objectness
