// SPDX-License-Identifier: BSD-3-Clause
// A model of your own in the place of the built-in one: own_model MODEL.json SCENE_FOLDER|FILE.pcd
// The tool learn_objectness writes such a model from scenes whose objects are known.
#include <iostream>

#include "objectness_segmentation/io/input_file.hpp"
#include "objectness_segmentation/learning/learned_objectness.hpp"
#include "objectness_segmentation/pipeline.hpp"

int main(int argc, char** argv) {
  if (argc != 3) return std::cerr << "usage: own_model MODEL.json SCENE\n", 2;
  // A model of other cues than this version's is refused, and the message names the cues.
  const auto model = objectness::loadModel(argv[1]);
  if (!model.ok()) return std::cerr << argv[1] << ": " << model.status.message << '\n', 1;
  std::cout << "learned from " << model.value.trained_on << '\n';

  const objectness::Config config;
  const auto frame = objectness::loadInput(argv[2], {}, config.input);
  if (!frame.ok()) return std::cerr << argv[2] << ": " << frame.status.message << '\n', 1;
  const auto result = objectness::segment(frame.value, config, model.value);
  if (!result.status.ok()) return std::cerr << argv[2] << ": " << result.status.message << '\n', 1;
  for (const objectness::Segment& object : result.segments) std::cout << "objectness " << object.objectness << '\n';
}
