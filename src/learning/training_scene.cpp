// SPDX-License-Identifier: BSD-3-Clause
#include "learning/training_scene.hpp"

#include <algorithm>

#include "common/true_labels.hpp"
#include "front_end.hpp"
#include "objectness_segmentation/learning/cue_list.hpp"
#include "scene/resolution.hpp"

namespace objectness {
namespace {

/// Pixels that pieces and objects have in common; fills the rest of what is known of the truth from it.
void compare(const cv::Mat_<ushort>& truth, TrainingScene& scene) {
  int objects = 0;
  for (const ushort label : truth) objects = std::max(objects, trueObject(label) + 1);
  scene.object_size.assign(objects, 0);
  const int pieces = scene.graph.pieces.count();
  scene.shared = cv::Mat_<int>::zeros(pieces, std::max(1, objects));
  std::vector<int> labelled(pieces, 0);
  for (int i = 0; i < scene.frame.size(); ++i) {
    const int object = trueObject(truth(i)), piece = scene.graph.pieces.label(i);
    if (object >= 0) ++scene.object_size[object];
    if (piece < 0 || truth(i) == 0) continue;
    ++labelled[piece];
    if (object >= 0) ++scene.shared(piece, object);
  }
  scene.object.assign(pieces, -1);
  scene.purity.assign(pieces, 0);
  for (int k = 0; k < pieces; ++k) {
    for (int o = 0; o < objects; ++o) {
      const double share = scene.shared(k, o) / std::max(1.0, double(labelled[k]));
      if (share > scene.purity[k]) scene.purity[k] = share, scene.object[k] = o;
    }
  }
}

double bestOverlap(const TrainingScene& scene, const std::vector<int>& group) {
  double best = 0;
  for (std::size_t o = 0; o < scene.object_size.size(); ++o) {
    int shared = 0, size = 0;
    for (const int k : group) {
      shared += scene.shared(k, static_cast<int>(o));
      size += static_cast<int>(scene.graph.pieces.pieces[k].pixels.size());
    }
    best = std::max(best, shared / std::max(1.0, double(size) + scene.object_size[o] - shared));
  }
  return best;
}

}  // namespace

template <class Cues>
Samples samplesOf() {
  Samples samples;
  samples.cues = cueNames<Cues>();
  return samples;
}
template Samples samplesOf<ContactCues>();
template Samples samplesOf<GapCues>();
template Samples samplesOf<GroupCues>();

TrainingScene observe(const Frame& frame, const cv::Mat_<ushort>& truth, const Config& config) {
  TrainingScene scene;
  const int factor = averagedPixels(frame, config.resolution);  // as segment() sees it
  scene.frame = factor == 1 ? frame : averageBlocks(frame, factor);
  Config grouping = config;
  grouping.pipeline.method = SegmentationMethod::kObjectness;  // it is for this method that scenes are learned from
  Report report;
  observeScene(scene.frame, grouping, Stages(nullptr, report), scene);
  if (!scene.status.ok()) return scene;
  scene.graph = findPieceGraph(scene.frame, scene.normals, scene.table, scene.object_points, scene.superpixels,
                               config.pieces, config.links, config.runtime.threads);
  compare(labelsOfBlocks(truth, factor), scene);
  return scene;
}

void addPairSamples(const TrainingScene& scene, const TrainingConfig& config, Samples& contact, Samples& gap) {
  for (const PairEvidence& pair : scene.graph.pairs) {
    if (std::min(scene.purity[pair.first], scene.purity[pair.second]) < config.min_purity) continue;
    const float target = scene.object[pair.first] == scene.object[pair.second] ? 1.f : 0.f;
    if (const auto* cues = std::get_if<ContactCues>(&pair.cues)) {
      contact.add(cueValues(*cues), target);
    } else {
      gap.add(cueValues(std::get<GapCues>(pair.cues)), target);
    }
  }
}

void addGroupSamples(const TrainingScene& scene, const LearnedObjectness& model, const Config& config,
                     const TrainingConfig& training, Samples& group) {
  const std::vector<Link> links = judgePairs(scene.graph.pairs, scene.graph.borders, model);
  const std::vector<GroupHypothesis> groups = proposeObjects(scene.frame, scene.table, scene.edges, scene.graph, links,
                                                             config.grouping, config.runtime.threads);
  const std::size_t kept = std::min<std::size_t>(training.max_groups_per_scene, groups.size());
  for (std::size_t k = 0; k < kept; ++k) {
    const GroupHypothesis& drawn = groups[k * groups.size() / kept];
    group.add(cueValues(drawn.cues), static_cast<float>(bestOverlap(scene, drawn.pieces)));
  }
}

}  // namespace objectness
