// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluation/run.hpp"

namespace objectness::evaluation {

/// Copies the results of report folders that were computed with --shard into `report`. kBadInput: they differ in
/// commit, methods, settings or levels, a part is missing or given twice, or a scene is in two of them.
Result<Run> mergeShards(const std::string& report, const std::vector<std::string>& shards);

}  // namespace objectness::evaluation
