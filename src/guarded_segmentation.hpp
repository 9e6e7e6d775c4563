// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <new>

#include "objectness_segmentation/result.hpp"
#include "objectness_segmentation/scene/frame.hpp"

namespace objectness {

/// Calls run(result), which fills the result. What all ways to segment a frame owe their callers: labels of the frame's
/// size (none where not even they could be made), the total time, and a status in place of an exception.
template <class Run>
Segmentation guardedSegmentation(const Frame& frame, const Run& run) {
  Segmentation result;
  {
    const StageTimer timer(result.report.timings_ms, "total");
    try {
      result.report.remarks = frame.remarks;
      result.labels = cv::Mat_<ushort>(frame.height(), frame.width(), static_cast<ushort>(0));
      run(result);
    } catch (const std::bad_alloc&) {
      result.status = Status::error(StatusCode::kInternalError, "out of memory");
    } catch (const std::exception& e) {
      result.status = Status::error(StatusCode::kInternalError, e.what());
    }
  }
  return result;
}

}  // namespace objectness
