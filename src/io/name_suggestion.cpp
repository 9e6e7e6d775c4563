// SPDX-License-Identifier: BSD-3-Clause
#include "io/name_suggestion.hpp"

#include <algorithm>
#include <numeric>

namespace objectness {
namespace {

/// Levenshtein distance.
std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

}  // namespace

std::string didYouMean(const std::string& name, const std::vector<std::string>& candidates) {
  constexpr std::size_t kLongestName = 100;  // longer ones are no slips of a finger
  if (name.empty() || name.size() > kLongestName) return "";
  const std::string* nearest = nullptr;
  std::size_t least = std::max<std::size_t>(2, name.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t dot = candidate.rfind('.');
    const bool lacks_group = dot != std::string::npos && candidate.compare(dot + 1, std::string::npos, name) == 0;
    // No nearer than their lengths differ.
    const std::size_t differ = std::max(name.size(), candidate.size()) - std::min(name.size(), candidate.size());
    if (!lacks_group && differ >= least) continue;
    const std::size_t distance = lacks_group ? 0 : editDistance(name, candidate);
    if (distance < least) {
      least = distance;
      nearest = &candidate;
    }
  }
  return nearest ? " (did you mean " + *nearest + "?)" : "";
}

}  // namespace objectness
