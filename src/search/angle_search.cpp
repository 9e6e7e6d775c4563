// SPDX-License-Identifier: BSD-3-Clause
#include "search/angle_search.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>

#include "common/object_pool.hpp"
#include "common/parallel.hpp"
#include "integral/cue_volumes.hpp"
#include "integral/voxelizer.hpp"
#include "search/bounded_search.hpp"
#include "search/ranking.hpp"

namespace objectness {
namespace {

/// About 100 MB of tables a thread: a scene that needs more is no table top.
constexpr long kMaxVoxels = 8'000'000;

Status checkSize(const Grid& grid) {
  if (grid.voxels() <= kMaxVoxels) return {};
  char message[256];
  std::snprintf(message, sizeof(message),
                "the volume of interest is %.2f x %.2f x %.2f m, %ld voxels of %.3f m, over the limit of %ld: lower "
                "input.max_depth_m or raise volume.voxel_m",
                grid.nx * grid.voxel_m, grid.ny * grid.voxel_m, grid.nz * grid.voxel_m, grid.voxels(), grid.voxel_m,
                kMaxVoxels);
  return Status::error(StatusCode::kVolumeTooLarge, message);
}

/// What the angles of a frame are searched in: each thread takes one that is free.
struct AngleMemory {
  Voxelizer::Scratch scratch;
  CueVoxels voxels;
  CueVolumes volumes;
};

double highestObjectness(const ObjectnessConfig& o) {
  return std::max(o.weight_edges, 0.0) * o.max_edge_density + std::max(o.weight_outer, 0.0) + o.constant;
}

/// One angle after the other, on several threads.
class AngleSearch {
 public:
  AngleSearch(const Voxelizer& marker, const Table& table, const std::vector<Grid>& grids,
              const SearchSettings& settings, const std::atomic<bool>* cancel)
      : marker_(marker), table_(table), grids_(grids), settings_(settings), cancel_(cancel) {
    const double voxel_m = settings.volume.voxel_m;
    task_ = {samplingOf(settings.search, voxel_m), ringOf(settings.objectness, voxel_m), settings.objectness, 0,
             nullptr};
  }

  bool cancelled() const { return cancel_ && *cancel_; }

  /// All boxes that reach the threshold and, with `running`, what that rises to.
  std::vector<SearchResult> run(double threshold, RunningThreshold* running) {
    task_.threshold = threshold;
    task_.running = running;
    std::vector<SearchResult> results(grids_.size());
    parallelFor(static_cast<int>(grids_.size()), settings_.threads, [&](int angle) {
      if (cancelled()) return;
      std::unique_ptr<AngleMemory> memory = memory_.take();
      marker_.mark(grids_[angle], memory->scratch, memory->voxels);
      integrate(memory->voxels, table_, task_.ring.z, memory->volumes);
      results[angle] = searchBounded(memory->volumes, angle, task_);
      memory_.put(std::move(memory));
    });
    return results;
  }

 private:
  const Voxelizer& marker_;
  const Table& table_;
  const std::vector<Grid>& grids_;
  const SearchSettings& settings_;
  const std::atomic<bool>* cancel_;
  SearchTask task_;
  ObjectPool<AngleMemory> memory_;
};

/// The boxes of all angles in one list, best first.
void gather(std::vector<SearchResult>& results, std::size_t most_per_angle, int threads, SearchOutcome& outcome) {
  std::vector<std::vector<ScoredBox>> lists;
  for (SearchResult& result : results) {
    outcome.sampled += result.sampled;
    outcome.scored += result.scored;
    outcome.nodes += result.nodes;
    outcome.passed += static_cast<std::int64_t>(result.boxes.size());
    if (outcome.unbounded.empty()) outcome.unbounded = result.unbounded;
    if (result.boxes.size() > most_per_angle) result.boxes.resize(most_per_angle);
    lists.push_back(std::move(result.boxes));
  }
  outcome.boxes = mergeBestFirst(lists, threads);
}

std::size_t countBoxesOf(const std::vector<SearchResult>& results) {
  std::size_t boxes = 0;
  for (const SearchResult& result : results) boxes += result.boxes.size();
  return boxes;
}

}  // namespace

SearchOutcome searchAllAngles(const Frame& frame, const Table& table, const CuePoints& points,
                              const SearchSettings& settings, const std::atomic<bool>* cancel) {
  SearchOutcome outcome;
  outcome.threshold = settings.threshold;
  const Sampling sampling = samplingOf(settings.search, settings.volume.voxel_m);
  // A margin of one step on either side: a box can then enclose what lies at the border tightly, in every phase of the
  // steps.
  const int margin = std::max({sampling.corner_step, sampling.size_step_xy, sampling.min_size});
  Voxelizer marker(points, settings.volume);
  const std::vector<double> angles = sampledAngles(settings.search);
  outcome.grids.resize(angles.size());
  parallelFor(static_cast<int>(angles.size()), settings.threads, [&](int i) {
    outcome.grids[i] = marker.gridAt(angles[i], margin, sampling.min_size, sampling.max_size);
  });
  for (const Grid& grid : outcome.grids) {
    outcome.status = checkSize(grid);
    if (!outcome.status.ok()) return outcome;
  }
  if (points.points.empty()) return outcome;
  marker.prepare(frame, table, outcome.grids, settings.threads);

  AngleSearch search(marker, table, outcome.grids, settings, cancel);
  const std::size_t top_k = settings.search.top_k;
  std::vector<SearchResult> results;
  if (top_k == 0) {
    results = search.run(settings.threshold, nullptr);
  } else {
    const auto best = [&](double start) {
      RunningThreshold running(settings.search.top_k, start, highestObjectness(settings.objectness));
      results = search.run(start, &running);
    };
    const double start = std::max(settings.threshold, settings.search.top_k_start);
    best(start);
    if (countBoxesOf(results) < top_k && start > settings.threshold) best(settings.threshold);
  }
  if (search.cancelled()) outcome.status = Status::error(StatusCode::kCancelled, "cancelled while searching boxes");

  gather(results, settings.search.max_boxes_per_angle, settings.threads, outcome);
  if (top_k > 0 && outcome.boxes.size() >= top_k) {
    outcome.boxes.resize(top_k);
    outcome.threshold = outcome.boxes.back().objectness;
  }
  return outcome;
}

}  // namespace objectness
