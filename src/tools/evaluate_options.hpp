// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evaluation/scores.hpp"
#include "objectness_segmentation/common/status.hpp"
#include "objectness_segmentation/config.hpp"
#include "objectness_segmentation/learning/learned_objectness.hpp"

namespace objectness::evaluation {

/// What the command line of `evaluate` asks for.
struct EvaluateOptions {
  bool merge = false;                ///< inputs are report folders of shards, not scenes
  std::vector<std::string> methods;  ///< names that makeMethods() knows
  std::vector<Level> levels;
  Config config;                           ///< of every method, as far as it heeds it
  std::optional<LearnedObjectness> model;  ///< of the method objectness, none: the built-in one
  int jobs = 1, threads = 2;
  int fuse_frames = 0;  ///< 0: every frame for itself
  bool still = false;   ///< data sets are sequences of a still scene
  int shard = 1, shards = 1;
  std::string groups_file, report;
  std::vector<std::string> inputs;
  std::string print;  ///< text to print instead of evaluating anything (--help)
};

/// An error is one that a look at `evaluate --help` helps with.
Result<EvaluateOptions> parseEvaluateOptions(int argc, const char* const* argv);

}  // namespace objectness::evaluation
