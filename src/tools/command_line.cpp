// SPDX-License-Identifier: BSD-3-Clause
#include "tools/command_line.hpp"

namespace objectness {

namespace po = boost::program_options;

po::variables_map parseCommandLine(int argc, const char* const* argv, const po::options_description& options,
                                   Inputs inputs) {
  po::options_description all = options;
  po::positional_options_description positional;
  if (inputs == Inputs::kAny) {
    all.add_options()("input", po::value<std::vector<std::string>>());
    positional.add("input", -1);
  }
  // Abbreviated options would change their meaning when an option is added.
  const int style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
  po::variables_map values;
  po::store(po::command_line_parser(argc, argv).options(all).positional(positional).style(style).run(), values);
  po::notify(values);
  return values;
}

std::string textOf(const po::variables_map& values, const char* name) {
  return values.count(name) ? values[name].as<std::string>() : std::string();
}

std::vector<std::string> listOf(const po::variables_map& values, const char* name) {
  return values.count(name) ? values[name].as<std::vector<std::string>>() : std::vector<std::string>();
}

}  // namespace objectness
