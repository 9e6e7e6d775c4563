// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/program_options.hpp>
#include <string>
#include <vector>

#include "objectness_segmentation/common/status.hpp"
#include "objectness_segmentation/config.hpp"

namespace objectness {

/// --config, --set, --threads and --seed, the same for every tool.
void addConfigOptions(boost::program_options::options_description& options);

/// Lays what they ask for over `config`. Further assignments of a --set are found among the inputs and taken out there.
Status readConfigOptions(const boost::program_options::variables_map& values, std::vector<std::string>& inputs,
                         Config& config);

}  // namespace objectness
