// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/program_options.hpp>
#include <string>
#include <vector>

namespace objectness {

/// Whether a tool takes words that are no options; they are found under the name "input".
enum class Inputs { kNone, kAny };

/// The values of a command line; `options` are those of the help. Throws boost::program_options::error for a wrong one.
boost::program_options::variables_map parseCommandLine(int argc, const char* const* argv,
                                                       const boost::program_options::options_description& options,
                                                       Inputs inputs);

/// The value of an option; empty when it is not given.
std::string textOf(const boost::program_options::variables_map& values, const char* name);
std::vector<std::string> listOf(const boost::program_options::variables_map& values, const char* name);

}  // namespace objectness
