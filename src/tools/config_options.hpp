// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/program_options.hpp>
#include <optional>
#include <string>
#include <vector>

#include "objectness_segmentation/common/status.hpp"
#include "objectness_segmentation/config.hpp"
#include "objectness_segmentation/learning/learned_objectness.hpp"

namespace objectness {

/// --config and --set, the same for every tool.
void addParameterOptions(boost::program_options::options_description& options);

/// --model, of tools that segment.
void addModelOption(boost::program_options::options_description& options);

/// All of these, --method, --threads and --seed: of tools that run one method.
void addConfigOptions(boost::program_options::options_description& options);

/// Lays what --config, --set and `more` (as --set) ask for over `config`. Further assignments of a --set are found
/// among the inputs and taken out there. Names of earlier versions are warned of on standard error.
Status readParameterOptions(const boost::program_options::variables_map& values, std::vector<std::string>& inputs,
                            const std::vector<std::string>& more, Config& config);

/// The same with what --method, --threads and --seed say.
Status readConfigOptions(const boost::program_options::variables_map& values, std::vector<std::string>& inputs,
                         Config& config);

/// The model of --model, nothing when it is not given. An error names the file and what is wrong with it.
Status readModelOption(const boost::program_options::variables_map& values, std::optional<LearnedObjectness>& model);

}  // namespace objectness
