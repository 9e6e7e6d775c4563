// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/metrics.hpp"

#include <algorithm>
#include <map>

namespace objectness::evaluation {
namespace {

constexpr const char* kObjects = "boxed_objects";

}  // namespace

Metrics toMetrics(const ProposalMetrics& proposals) {
  Metrics metrics{{kObjects, proposals.objects},
                  {"proposals", proposals.proposals},
                  {"best_P", proposals.best_box_precision},
                  {"best_R", proposals.best_box_recall}};
  const auto add = [&](const std::string& name, const auto& recalls) {
    for (std::size_t k = 0; k < kKeptBoxes.size(); ++k) {
      metrics.emplace_back(name + "_" + std::to_string(kKeptBoxes[k]), recalls[k]);
    }
  };
  add("box50", proposals.objectness.at_50);
  add("box70", proposals.objectness.at_70);
  add("fixed50", proposals.fixed.at_50);
  add("fixed70", proposals.fixed.at_70);
  return metrics;
}

Metrics poolProposals(const std::vector<Metrics>& scenes) {
  Metrics pooled;
  double count = 0;
  for (const Metrics& scene : scenes) {
    if (scene.empty()) continue;
    ++count;
    if (pooled.empty()) {
      pooled = scene;
    } else {
      for (std::size_t i = 0; i < pooled.size(); ++i) pooled[i].second += scene[i].second;
    }
  }
  for (auto& [name, value] : pooled) {
    if (name != kObjects) value /= count;
  }
  return pooled;
}

Metrics poolGaps(const std::vector<Metrics>& scenes) {
  struct Pool {
    double sum = 0, largest = 0;
    int count = 0;
  };
  std::map<std::string, Pool> pools;
  for (const Metrics& scene : scenes) {
    for (const auto& [name, value] : scene) {
      Pool& pool = pools[name];
      pool.sum += value;
      pool.largest = std::max(pool.largest, value);
      ++pool.count;
    }
  }
  Metrics pooled;
  for (const auto& [name, pool] : pools) {
    pooled.emplace_back(name, pool.sum / pool.count);
    pooled.emplace_back(name + "_max", pool.largest);
  }
  return pooled;
}

}  // namespace objectness::evaluation
