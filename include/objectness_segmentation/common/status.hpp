// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace objectness {

/// Why a frame could or could not be segmented. The names are part of the API: they appear in objects.json, in the
/// nodelet's messages and in its diagnostics.
enum class StatusCode {
  kOk,              ///< segmented; zero objects on the table is a valid result
  kNotOrganized,    ///< the cloud has no pixel grid and no camera was given to restore one
  kSizeMismatch,    ///< cloud, image and camera do not agree in size
  kBadCamera,       ///< no camera, or intrinsics that no pinhole camera has
  kNoValidPoints,   ///< every depth is missing or outside the range
  kNoTable,         ///< no plane qualifies as a table
  kBadConfig,       ///< a configuration value is out of its range
  kVolumeTooLarge,  ///< the volume of interest would not fit in memory at this voxel size
  kBadInput,        ///< a file or message that cannot be read, or depth with more holes than surfaces
  kCancelled,       ///< the caller asked to stop in mid-frame
  kInternalError,   ///< an exception was caught at the border of the core
  kNoTransform,     ///< ROS: where the camera was is not known (tf)
  kNoInput          ///< ROS: no frame came in the time that was given
};

/// "ok", "not_organized", ...
const char* toString(StatusCode code);

/// A code and a sentence a user can act on ("cloud is 307200 x 1, not organized: ...").
struct [[nodiscard]] Status {
  StatusCode code = StatusCode::kOk;
  std::string message;

  bool ok() const { return code == StatusCode::kOk; }
  static Status error(StatusCode code, std::string message) { return {code, std::move(message)}; }
};

/// A value, or the reason there is none. `value` is meaningful only when ok().
template <class T>
struct [[nodiscard]] Result {
  Status status;
  T value{};

  bool ok() const { return status.ok(); }
  static Result error(StatusCode code, std::string message) { return {Status::error(code, std::move(message)), T{}}; }
  static Result error(Status status) { return {std::move(status), T{}}; }
};

}  // namespace objectness
