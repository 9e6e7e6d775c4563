// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "common/parallel.hpp"

namespace objectness {

/// What add(i, values) appends for every stride-th i of 0..count-1, in their order; on several threads.
template <class Add>
std::vector<float> sampledValues(int count, int stride, int threads, Add&& add) {
  constexpr int kParts = 16;
  std::vector<float> parts[kParts];
  const int samples = (count + stride - 1) / stride;
  parallelFor(kParts, threads, [&](int part) {
    for (int k = samples * part / kParts; k < samples * (part + 1) / kParts; ++k) add(k * stride, parts[part]);
  });
  std::vector<float> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace objectness
