// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <sstream>

#include "method_names.hpp"
#include "objectness_segmentation/config_fields.hpp"

namespace objectness {
namespace {

using Problems = std::vector<std::string>;

// 0.02 / 0.01 is not exactly 2.
constexpr double kMultipleTolerance = 1e-6;

template <class... Parts>
std::string sentence(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

void checkRanges(const Config& config, Problems& problems) {
  Config copy = config;
  for (const ConfigField& field : configFields(copy)) {
    const double value = std::visit([](const auto* v) { return static_cast<double>(*v); }, field.value);
    if (value >= field.range.min && value <= field.range.max) continue;  // false for NaN
    if (std::holds_alternative<SegmentationMethod*>(field.value)) {
      problems.push_back(field.fullName() + " is no method, must be " + joinedMethodNames(", ", " or "));
      continue;
    }
    problems.push_back(
        sentence(field.fullName(), " is ", value, ", must be within ", field.range.min, " and ", field.range.max));
  }
}

void checkOrder(const char* low_name, double low, const char* high_name, double high, Problems& problems) {
  if (low > high) {
    problems.push_back(sentence(low_name, " is ", low, ", must be at most ", high_name, ", which is ", high));
  }
}

/// Boxes are sampled on the voxel grid: any other length would silently be rounded to it.
void checkWholeVoxels(const char* name, double metres, double voxel_m, Problems& problems) {
  if (!(voxel_m > 0) || !std::isfinite(metres)) return;
  const double voxels = metres / voxel_m;
  if (std::abs(voxels - std::round(voxels)) > kMultipleTolerance) {
    problems.push_back(
        sentence(name, " is ", metres, ", must be a whole multiple of volume.voxel_m, which is ", voxel_m));
  } else if (metres > 0 && std::round(voxels) < 1) {
    problems.push_back(sentence(name, " is ", metres, ", must be at least volume.voxel_m, which is ", voxel_m));
  }
}

}  // namespace

std::vector<std::string> validate(const Config& config) {
  Problems problems;
  checkRanges(config, problems);

  const InputConfig& input = config.input;
  if (input.min_depth_m >= input.max_depth_m) {
    problems.push_back(sentence("input.min_depth_m is ", input.min_depth_m,
                                ", must be less than input.max_depth_m, which is ", input.max_depth_m));
  }
  checkOrder("normals.min_window_px", config.normals.min_window_px, "normals.max_window_px",
             config.normals.max_window_px, problems);
  const TableConfig& table = config.table;
  if (table.given && table.given_a == 0 && table.given_b == 0 && table.given_c == 0) {
    problems.push_back(
        "table.given_a, table.given_b and table.given_c are all 0, must be the normal of the given plane");
  }
  const SearchConfig& search = config.search;
  checkOrder("search.min_size_m", search.min_size_m, "search.max_size_m", search.max_size_m, problems);
  const double voxel_m = config.volume.voxel_m;
  checkWholeVoxels("search.corner_step_m", search.corner_step_m, voxel_m, problems);
  checkWholeVoxels("search.size_step_xy_m", search.size_step_xy_m, voxel_m, problems);
  checkWholeVoxels("search.size_step_z_m", search.size_step_z_m, voxel_m, problems);
  checkWholeVoxels("search.min_size_m", search.min_size_m, voxel_m, problems);
  checkWholeVoxels("search.max_size_m", search.max_size_m, voxel_m, problems);
  checkWholeVoxels("objectness.ring_xy_m", config.objectness.ring_xy_m, voxel_m, problems);
  checkWholeVoxels("objectness.ring_z_m", config.objectness.ring_z_m, voxel_m, problems);
  checkOrder("selection.end_temperature", config.selection.end_temperature, "selection.start_temperature",
             config.selection.start_temperature, problems);
  return problems;
}

}  // namespace objectness
