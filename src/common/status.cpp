// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/common/status.hpp"

namespace objectness {

const char* toString(StatusCode code) {
  switch (code) {
    case StatusCode::kOk:
      return "ok";
    case StatusCode::kNotOrganized:
      return "not_organized";
    case StatusCode::kSizeMismatch:
      return "size_mismatch";
    case StatusCode::kBadCamera:
      return "bad_camera";
    case StatusCode::kNoValidPoints:
      return "no_valid_points";
    case StatusCode::kNoTable:
      return "no_table";
    case StatusCode::kBadConfig:
      return "bad_config";
    case StatusCode::kVolumeTooLarge:
      return "volume_too_large";
    case StatusCode::kBadInput:
      return "bad_input";
    case StatusCode::kCancelled:
      return "cancelled";
    case StatusCode::kInternalError:
      return "internal_error";
    case StatusCode::kNoTransform:
      return "no_transform";
    case StatusCode::kNoInput:
      return "no_input";
  }
  return "unknown";
}

}  // namespace objectness
