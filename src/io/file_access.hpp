// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "objectness_segmentation/common/status.hpp"

namespace objectness {

/// More than any camera or preset file needs.
constexpr std::uintmax_t kMaxTextBytes = 1 << 20;

/// The bytes of a regular file. kBadInput when it is missing, no file, unreadable or larger than max_bytes. Messages of
/// this folder do not name the file they are about when the caller gave its path: the caller knows how to call it.
Result<std::string> readFile(const std::string& path, std::uintmax_t max_bytes);

/// Writes beside `path` and renames: a reader sees the old file or the whole new one, never a part.
Status writeFile(const std::string& path, const std::string& bytes);

/// Makes a folder and those above it. kBadInput with the system's reason.
Status makeFolder(const std::string& path);

/// `message` with "`what`: " before it.
inline Status about(const std::string& what, Status status) {
  status.message = what + ": " + status.message;
  return status;
}

}  // namespace objectness
