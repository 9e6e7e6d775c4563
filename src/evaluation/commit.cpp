// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/commit.hpp"

#include "evaluation_commit.hpp"  // written into the build folder at every build

namespace objectness::evaluation {

std::string commit() { return OBJECTNESS_COMMIT; }

}  // namespace objectness::evaluation
