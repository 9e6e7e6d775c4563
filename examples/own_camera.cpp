// SPDX-License-Identifier: BSD-3-Clause
// A depth image of any camera, as it lies in memory: own_camera DEPTH.png FX FY CX CY UNIT_M LABELS.png
// The intrinsics are those of the rectified image in pixels; UNIT_M is what one step of the 16-bit depth is in metres
// (0.001 of most cameras, 0.00025 or 0.0001 of some). Writes the label image: 0 nothing, 1 table, 2 and above an
// object.
#include <cstdlib>
#include <iostream>
#include <opencv2/imgcodecs.hpp>

#include "objectness_segmentation/pipeline.hpp"

int main(int argc, char** argv) {
  if (argc != 8) return std::cerr << "usage: own_camera DEPTH.png FX FY CX CY UNIT_M LABELS.png\n", 2;
  const auto number = [&](int i) { return std::strtod(argv[i], nullptr); };
  const cv::Mat depth = cv::imread(argv[1], cv::IMREAD_UNCHANGED);  // CV_16U; CV_32F is taken as metres
  const objectness::PinholeCamera camera{number(2), number(3), number(4), number(5), depth.cols, depth.rows};
  objectness::Config config;
  config.input.depth_unit_m = number(6);

  // A depth image that is not rectified comes with an objectness::ImageCamera (imageCamera()), a cloud with a RawCloud.
  const cv::Mat no_color;
  const auto frame = objectness::makeFrame(depth, no_color, camera, config.input);
  if (!frame.ok()) return std::cerr << frame.status.message << '\n', 1;
  const auto result = objectness::segment(frame.value, config);
  if (!result.status.ok()) return std::cerr << result.status.message << '\n', 1;
  // What is unusual about the input, or makes the result doubtful.
  for (const std::string& remark : result.report.remarks) std::cerr << remark << '\n';
  if (!cv::imwrite(argv[7], result.labels)) return std::cerr << "cannot write " << argv[7] << '\n', 1;
  std::cout << result.segments.size() << " objects\n";
}
