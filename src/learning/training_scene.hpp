// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grouping/bottom_up.hpp"
#include "learning/forest_trainer.hpp"
#include "objectness_segmentation/config.hpp"
#include "objectness_segmentation/scene_observation.hpp"

namespace objectness {

/// Which samples a training scene gives.
struct TrainingConfig {
  double min_purity = 0.85;       ///< pieces of which less belongs to one object teach nothing about pairs
  int max_groups_per_scene = 80;  ///< so that a crowded scene does not outweigh all others

  ForestSettings contact{30, 8, 10}, gap{30, 8, 10}, group{45, 9, 15};
};

/// What a scene with known objects looks like to the bottom-up method. Where its status is not ok(), there is nothing
/// to learn.
struct TrainingScene : SceneObservation {
  Frame frame;
  PieceGraph graph;
  std::vector<int> object;       ///< of each piece: the true object with most of its pixels, -1: none
  std::vector<double> purity;    ///< share of the piece's labelled pixels that are this object's
  cv::Mat_<int> shared;          ///< pieces x objects: pixels in common
  std::vector<int> object_size;  ///< pixels of each object
};

/// truth: H x W in the form of SceneImages::true_labels.
TrainingScene observe(const Frame& frame, const cv::Mat_<ushort>& truth, const Config& config);

/// Samples of the pairs of pure pieces; target 1: one object, 0: two.
void addPairSamples(const TrainingScene& scene, const TrainingConfig& config, Samples& contact, Samples& gap);

/// Samples of groups proposed over the links that `model` finds, drawn evenly; target: the overlap (intersection over
/// union) with the object it fits best.
void addGroupSamples(const TrainingScene& scene, const LearnedObjectness& model, const Config& config,
                     const TrainingConfig& training, Samples& group);

/// Empty samples with the names of their cues.
template <class Cues>
Samples samplesOf();

}  // namespace objectness
