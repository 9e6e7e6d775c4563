// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace objectness {

/// cfg/objectness_model.json, built into the library so that there is nothing to find at run time.
extern const char* const kDefaultModelJson;

}  // namespace objectness
