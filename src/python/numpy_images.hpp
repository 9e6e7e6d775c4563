// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/numpy.h>

#include <opencv2/core.hpp>

namespace objectness::python {

/// The pixels of an array as a depth image, H x W of uint16 or float32. A view: the array must outlive it and stay as
/// it is. std::invalid_argument for other arrays, and for arrays whose rows or pixels are not side by side in memory.
cv::Mat depthView(const pybind11::array& depth);

/// The same of a picture, H x W x 3 of uint8, RGB, as the core has it: a copy in BGR. Empty for an empty array.
cv::Mat_<cv::Vec3b> bgrOf(const pybind11::array& rgb);

/// H x W of uint16: a copy that is NumPy's own.
pybind11::array_t<std::uint16_t> labelArray(const cv::Mat_<ushort>& labels);

}  // namespace objectness::python
