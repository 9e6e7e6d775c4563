// SPDX-License-Identifier: BSD-3-Clause
#include "front_end.hpp"

#include "cues/surface_cues.hpp"
#include "scene/refined_normals.hpp"
#include "scene/surface_check.hpp"

namespace objectness {

void observeTable(const Frame& frame, const Config& config, const Stages& stage, SceneObservation& scene) {
  const int threads = config.runtime.threads;
  scene.status = checkSurfaces(frame);
  if (!scene.status.ok()) return;
  scene.normals = stage("normals", [&] { return estimateNormals(frame, config.normals, {}, threads); });
  Result<Table> found = stage("table", [&] { return findTable(frame, scene.normals, config.table, threads); });
  scene.status = found.status;
  scene.table = std::move(found.value);
  if (!scene.status.ok()) return;
  scene.normals = stage("refined_normals", [&] {
    return refineNormals(frame, std::move(scene.normals), scene.table, config.normals, threads);
  });
  scene.object_points = stage("object_points", [&] {
    return findObjectPoints(frame, scene.normals, scene.table, config.object_points, threads);
  });
}

void observeScene(const Frame& frame, const Config& config, const Stages& stage, SceneObservation& scene) {
  observeTable(frame, config, stage, scene);
  if (!scene.status.ok()) return;
  const SuperpixelsConfig superpixels = config.pipeline.method == SegmentationMethod::kObjectness
                                            ? config.superpixels
                                            : superpixelsForBoxes(config.superpixels);
  SurfaceCues cues = stage("surface_cues", [&] {
    return findSurfaceCues(frame, scene.normals, scene.table, scene.object_points, config.edges, superpixels,
                           config.runtime.threads);
  });
  scene.edges = std::move(cues.edges);
  scene.superpixels = std::move(cues.superpixels);
  stage.report().superpixels = scene.superpixels.count;
}

}  // namespace objectness
