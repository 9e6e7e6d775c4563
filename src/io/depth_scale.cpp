// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/io/depth_scale.hpp"

#include <cmath>
#include <locale>
#include <sstream>

namespace objectness {
namespace {

constexpr double kMinUnitM = 1e-6, kMaxUnitM = 0.02;

/// The number that is the whole text, NaN when it is none.
double numberOf(const std::string& text) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double value = 0;
  stream >> value;
  return stream && stream.peek() == std::istringstream::traits_type::eof() ? value : std::nan("");
}

}  // namespace

Result<double> depthUnit(const std::string& scale) {
  const std::size_t slash = scale.find('/');
  double value = numberOf(scale.substr(0, slash));
  if (slash != std::string::npos) value /= numberOf(scale.substr(slash + 1));
  const double unit_m = value >= 1 ? 1 / value : value;
  if (unit_m >= kMinUnitM * (1 - 1e-9) && unit_m <= kMaxUnitM * (1 + 1e-9)) return {{}, unit_m};
  return Result<double>::error(StatusCode::kBadInput,
                               "is '" + scale +
                                   "', must be the units of a metre (1000 for millimetres, 5000, ...) or the metres of "
                                   "a unit (0.001, 1/5000, ...), within 1 um and 2 cm");
}

}  // namespace objectness
