// SPDX-License-Identifier: BSD-3-Clause
#include "frame_methods.hpp"

#include <stdexcept>

#include "baselines/baselines.hpp"
#include "objectness_segmentation/io/config_yaml.hpp"
#include "objectness_segmentation/pipeline.hpp"

namespace objectness::benchmarks {
namespace {

constexpr int kTopK = 1000;
constexpr char kStrict[] = REPOSITORY_DIR "/cfg/strict.yaml";

Config withThreads() {
  Config config;
  config.runtime.threads = kThreads;
  return config;
}

void require(const Status& status) {
  if (!status.ok()) throw std::runtime_error(status.message);
}

FrameMethod ownMethod(const std::string& name, const std::string& volume, const Config& config) {
  return {name, volume, [config](const Frame& frame) { return segment(frame, config); }};
}

/// pcl_normals: normals by PCL, too, in the place of the package's faster ones.
FrameMethod baselineMethod(Baseline baseline, bool pcl_normals) {
  Config config = withThreads();
  config.normals.pcl = pcl_normals;
  const auto run = [baseline, config](const Frame& frame) { return segmentWithBaseline(baseline, frame, config); };
  return {std::string(toString(baseline)) + (pcl_normals ? "_pcl_normals" : ""), "none", run, true};
}

}  // namespace

std::vector<VolumeOfInterest> volumesOfInterest() {
  Config tight = withThreads(), wide = withThreads();
  tight.pipeline.method = SegmentationMethod::kPaper;
  require(loadConfig(REPOSITORY_DIR "/cfg/wide_volume.yaml", wide));
  return {{"tight", tight}, {"wide", wide}};
}

std::vector<VolumeOfInterest> strictVolumes() {
  std::vector<VolumeOfInterest> volumes = volumesOfInterest();
  for (VolumeOfInterest& volume : volumes) require(loadConfig(kStrict, volume.config));
  return volumes;
}

std::vector<FrameMethod> frameMethods() {
  std::vector<FrameMethod> methods{ownMethod("objectness", "none", withThreads())};
  for (const auto& [volume, config] : volumesOfInterest()) methods.push_back(ownMethod("paper", volume, config));
  for (auto [volume, config] : volumesOfInterest()) {
    config.search.top_k = kTopK;
    methods.push_back(ownMethod("paper_top_k", volume, config));
  }
  for (const auto& [volume, config] : strictVolumes()) methods.push_back(ownMethod("paper_strict", volume, config));
  for (const bool pcl_normals : {false, true}) {
    methods.push_back(baselineMethod(Baseline::kMps, pcl_normals));
    methods.push_back(baselineMethod(Baseline::kLccp, pcl_normals));
  }
  for (const Baseline baseline : {Baseline::kEuclidean, Baseline::kOrganized})
    methods.push_back(baselineMethod(baseline, false));
  return methods;
}

}  // namespace objectness::benchmarks
