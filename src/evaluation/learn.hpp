// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "evaluation/scenes.hpp"
#include "evaluation/scores.hpp"
#include "learning/training_scene.hpp"

namespace objectness::evaluation {

struct LearnSettings {
  Config config;  ///< its cue switches and links.gaps hold for the model: use it with the same
  TrainingConfig training;
  int folds = 5;
  /// How often the samples of a scene count, by its folder; 1 where it has no entry. A few recorded scenes would not be
  /// heard among many simulated ones.
  std::map<std::string, int> weights;
  int threads = 2;
  std::function<void(const std::string& stage, std::size_t done, std::size_t of)> progress;
};

/// How a scene is segmented by a model that was learned without it. Where no table is found, nothing is.
struct HeldOutScores {
  std::string scene, group;
  Scores scores;
};

struct LearnedModel {
  LearnedObjectness model;  ///< of all scenes
  std::vector<HeldOutScores> held_out;
  std::size_t contacts = 0, gaps = 0, groups = 0;  ///< samples
  std::vector<std::string> notes;  ///< scenes that taught nothing, and why; unreadable ones are in no score
};

/// Learns the forests of LearnedObjectness. Scenes are dealt into folds, group by group. The forest of groups learns
/// from links as forests of pairs that did not see the scene judge them: links look as uncertain in training as they
/// will be. Does not depend on the number of threads. kBadInput: fewer than two folds, fewer scenes than folds, or
/// scenes that lack pairs of a kind.
Result<LearnedModel> learn(const std::vector<Scene>& scenes, const LearnSettings& settings);

}  // namespace objectness::evaluation
