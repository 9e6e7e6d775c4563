// SPDX-License-Identifier: BSD-3-Clause
#include "python/numpy_images.hpp"

#include <algorithm>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace objectness::python {
namespace py = pybind11;
namespace {

/// rows x columns of an OpenCV type over the array's own memory.
cv::Mat view(const py::array& array, int type) {
  constexpr py::ssize_t kLongestSide = std::numeric_limits<int>::max();
  if (array.shape(0) > kLongestSide || array.shape(1) > kLongestSide) throw std::invalid_argument("image too large");
  return {static_cast<int>(array.shape(0)), static_cast<int>(array.shape(1)), type, const_cast<void*>(array.data())};
}

void requireRows(const py::array& array) {
  if ((array.flags() & py::array::c_style) == 0) throw std::invalid_argument("array must be C-contiguous");
}

}  // namespace

cv::Mat depthView(const py::array& depth) {
  requireRows(depth);
  const bool is_float = py::isinstance<py::array_t<float>>(depth);
  if (depth.ndim() != 2 || !(is_float || py::isinstance<py::array_t<std::uint16_t>>(depth))) {
    throw std::invalid_argument("depth must be H x W of float32 or uint16");
  }
  return view(depth, is_float ? CV_32FC1 : CV_16UC1);
}

cv::Mat_<cv::Vec3b> bgrOf(const py::array& rgb) {
  if (rgb.size() == 0) return {};
  requireRows(rgb);
  if (rgb.ndim() != 3 || rgb.shape(2) != 3 || !py::isinstance<py::array_t<std::uint8_t>>(rgb)) {
    throw std::invalid_argument("color must be H x W x 3 of uint8");
  }
  cv::Mat bgr;
  cv::cvtColor(view(rgb, CV_8UC3), bgr, cv::COLOR_RGB2BGR);
  return bgr;
}

py::array_t<std::uint16_t> labelArray(const cv::Mat_<ushort>& labels) {
  py::array_t<std::uint16_t> array({labels.rows, labels.cols});
  if (!labels.empty()) std::copy(labels.begin(), labels.end(), array.mutable_data());  // OpenCV divides by columns
  return array;
}

}  // namespace objectness::python
