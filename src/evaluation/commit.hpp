// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace objectness::evaluation {

/// The commit the program was built from, with a checksum of what was changed since; the package's version when it was
/// not built in a git checkout.
std::string commit();

}  // namespace objectness::evaluation
