// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation_commit.hpp"  // written into the build folder at every build
#include "objectness_segmentation/evaluation/run.hpp"

namespace objectness::evaluation {

std::string commit() { return OBJECTNESS_COMMIT; }

}  // namespace objectness::evaluation
