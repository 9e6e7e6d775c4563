// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/search/angle_search.hpp"

#include <algorithm>
#include <cstdio>

#include "objectness_segmentation/common/parallel.hpp"
#include "objectness_segmentation/integral/cue_volumes.hpp"
#include "objectness_segmentation/integral/voxel_marker.hpp"
#include "objectness_segmentation/search/search.hpp"

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

/// What one angle after the other works in.
struct AngleMemory {
  VoxelMarker::Scratch scratch;
  CueVoxels voxels;
  CueVolumes volumes;
};

}  // namespace

SearchOutcome searchAllAngles(const Frame& frame, const Table& table, const CuePoints& points,
                              const SearchSettings& settings, const std::atomic<bool>* cancel) {
  SearchOutcome outcome;
  const SearchTask task{samplingOf(settings.search, settings.volume.voxel_m),
                        ringOf(settings.objectness, settings.volume.voxel_m), settings.objectness, settings.threshold};
  // A margin of one step on either side: a box can then enclose what lies at the border tightly, in every phase of the
  // steps.
  const int margin = std::max({task.sampling.corner_step, task.sampling.size_step_xy, task.sampling.min_size});
  VoxelMarker marker(points, settings.volume);
  for (const double angle : sampledAngles(settings.search)) {
    outcome.grids.push_back(marker.gridAt(angle, margin, task.sampling.min_size, task.sampling.max_size));
    outcome.status = checkSize(outcome.grids.back());
    if (!outcome.status.ok()) return outcome;
  }
  if (points.points.empty()) return outcome;

  marker.prepare(frame, table, outcome.grids, settings.threads);
  const int angles = static_cast<int>(outcome.grids.size());
  std::vector<SearchResult> results(angles);
  std::vector<std::int64_t> passed(angles, 0);
  parallelFor(angles, settings.threads, [&](int angle) {
    if (cancel && *cancel) return;
    thread_local AngleMemory memory;
    marker.mark(outcome.grids[angle], memory.scratch, memory.voxels);
    integrate(memory.voxels, table, task.ring.z, memory.volumes);
    results[angle] = searchBounded(memory.volumes, angle, task);
    passed[angle] = static_cast<std::int64_t>(results[angle].boxes.size());
    const std::size_t most = settings.search.max_boxes_per_angle;
    if (results[angle].boxes.size() > most) results[angle].boxes.resize(most);
  });
  if (cancel && *cancel) outcome.status = Status::error(StatusCode::kCancelled, "cancelled while searching boxes");

  for (int angle = 0; angle < angles; ++angle) {
    const SearchResult& result = results[angle];
    outcome.boxes.insert(outcome.boxes.end(), result.boxes.begin(), result.boxes.end());
    outcome.sampled += result.sampled;
    outcome.scored += result.scored;
    outcome.nodes += result.nodes;
    if (outcome.unbounded.empty()) outcome.unbounded = result.unbounded;
    outcome.passed += passed[angle];
  }
  sortBestFirst(outcome.boxes);
  return outcome;
}

}  // namespace objectness
