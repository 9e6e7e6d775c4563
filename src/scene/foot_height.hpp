// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace objectness {

/// What stands on a surface is seen down to this height over it; what is not, hangs or is hidden there.
constexpr float kFootHeightM = 0.04f;

}  // namespace objectness
