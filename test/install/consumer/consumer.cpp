// SPDX-License-Identifier: BSD-3-Clause
// How many objects there are in a scene folder or PCD file, by the installed library.
#include <iostream>
#include <objectness_segmentation/io/input_file.hpp>
#include <objectness_segmentation/pipeline.hpp>

int main(int argc, char** argv) {
  const objectness::Config config;
  const auto frame = objectness::loadInput(argc > 1 ? argv[1] : "", {}, config.input);
  if (!frame.ok()) return 1;
  const auto result = objectness::segment(frame.value, config);
  if (result.status.ok()) std::cout << result.segments.size() << '\n';
  return result.status.ok() ? 0 : 1;
}
