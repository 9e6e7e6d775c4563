// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace objectness::evaluation {
namespace {

constexpr double kTolerancePerDiagonal = 0.003;

int countAll(const std::vector<cv::Mat_<uchar>>& lines) {
  int count = 0;
  for (const auto& line : lines) count += cv::countNonZero(line);
  return std::max(1, count);
}

}  // namespace

cv::Mat_<uchar> outline(const cv::Mat_<uchar>& mask) {
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(mask.clone(), contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  cv::Mat_<uchar> line(mask.size(), uchar{0});
  cv::drawContours(line, contours, -1, 1, 1);
  return line;
}

BoundaryFit compareBoundaries(const std::vector<cv::Mat_<uchar>>& objects, const std::vector<cv::Mat_<uchar>>& segments,
                              const std::vector<std::pair<int, int>>& pairs) {
  if (objects.empty() || segments.empty()) return {};
  const int radius = static_cast<int>(std::ceil(kTolerancePerDiagonal * std::hypot(objects[0].rows, objects[0].cols)));
  const cv::Mat disk = cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * radius + 1, 2 * radius + 1});
  const auto countNear = [&](const cv::Mat& line, const cv::Mat& other) {
    cv::Mat near;
    cv::dilate(other, near, disk);
    return cv::countNonZero(line & near);
  };
  double of_segments = 0, of_objects = 0;
  for (const auto& [i, j] : pairs) {
    of_segments += countNear(segments[j], objects[i]);
    of_objects += countNear(objects[i], segments[j]);
  }
  return {of_segments / countAll(segments), of_objects / countAll(objects)};
}

}  // namespace objectness::evaluation
