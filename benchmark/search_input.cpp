// SPDX-License-Identifier: BSD-3-Clause
#include "search_input.hpp"

#include <ctime>
#include <stdexcept>

#include "objectness_segmentation/pipeline.hpp"

namespace objectness::benchmarks {
namespace {

double threadSeconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// The scene as the paper's method sees it. What is searched and chosen after that is not looked at: one angle will do.
Segmentation seeScene(const Frame& frame, Config config) {
  config.search.angle_step_deg = 90;
  return segment(frame, config);
}

}  // namespace

SearchInput::SearchInput(const Frame& frame, const Config& config)
    : frame_(frame),
      scene_(seeScene(frame, config)),
      points_(collectCuePoints(frame, scene_.table, scene_.object_points, scene_.edges, scene_.superpixels)),
      settings_{config.volume, config.search, config.objectness, config.filter.threshold, config.runtime.threads},
      task_{samplingOf(config.search, config.volume.voxel_m), ringOf(config.objectness, config.volume.voxel_m),
            config.objectness, config.filter.threshold} {
  if (!scene_.status.ok()) throw std::runtime_error(scene_.status.message);
  const SearchOutcome outcome = searchAll();
  if (!outcome.status.ok()) throw std::runtime_error(outcome.status.message);
  grids_ = outcome.grids;
}

SearchTimes SearchInput::run(Search search, SearchResult& result) const {
  SearchTimes times;
  // As in the pipeline, memory outlives a frame.
  static Voxelizer::Scratch scratch;
  static CueVoxels voxels;
  static CueVolumes volumes;
  const double begin = threadSeconds();
  Voxelizer marker(points_, settings_.volume);
  marker.prepare(frame_, scene_.table, grids_, 1);
  times.volumes = threadSeconds() - begin;
  for (int angle = 0; angle < static_cast<int>(grids_.size()); ++angle) {
    const double start = threadSeconds();
    marker.mark(grids_[angle], scratch, voxels);
    integrate(voxels, scene_.table, task_.ring.z, volumes);
    const double built = threadSeconds();
    times.volumes += built - start;
    if (!search) continue;
    const SearchResult found = search(volumes, angle, task_);
    times.search += threadSeconds() - built;
    result.boxes.insert(result.boxes.end(), found.boxes.begin(), found.boxes.end());
    result.sampled += found.sampled;
    result.scored += found.scored;
    result.nodes += found.nodes;
  }
  return times;
}

}  // namespace objectness::benchmarks
