// SPDX-License-Identifier: BSD-3-Clause
// From a file to its objects: segment_file SCENE_FOLDER|FILE.pcd
#include <iostream>

#include "objectness_segmentation/io/input_file.hpp"
#include "objectness_segmentation/pipeline.hpp"

int main(int argc, char** argv) {
  const objectness::Config config;
  const auto frame = objectness::loadInput(argc > 1 ? argv[1] : "", {}, config.input);
  if (!frame.ok()) return std::cerr << frame.status.message << '\n', 1;
  const auto result = objectness::segment(frame.value, config);
  if (!result.status.ok()) return std::cerr << result.status.message << '\n', 1;
  for (const objectness::Segment& object : result.segments) {
    std::cout << object.pixels.size() << " pixels, objectness " << object.objectness << ", box at "
              << object.box.T_camera_box.translation().transpose() << " m\n";
  }
}
