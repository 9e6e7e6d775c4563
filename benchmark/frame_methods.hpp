// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "objectness_segmentation/config.hpp"
#include "objectness_segmentation/result.hpp"
#include "objectness_segmentation/scene/frame.hpp"

namespace objectness::benchmarks {

constexpr int kThreads = 2;

/// A way to segment a whole frame.
struct FrameMethod {
  std::string name;    ///< "objectness", "paper", "mps", ...
  std::string volume;  ///< of interest: "tight" or "wide"; "none" where there is none
  std::function<Segmentation(const Frame&)> run;
  bool is_baseline = false;  ///< one of PCL's
};

/// Both of the package's methods; PCL's MPS and LCCP after the package's front end, with its normals or with PCL's; and
/// what is written with PCL alone. kThreads threads wherever there is more than one.
std::vector<FrameMethod> frameMethods();

/// A volume of interest of the paper's search: as far as the objects reach, or the preset cfg/wide_volume.yaml.
struct VolumeOfInterest {
  std::string name;  ///< "tight", "wide"
  Config config;     ///< of --method paper
};
std::vector<VolumeOfInterest> volumesOfInterest();

/// The same with the threshold of the preset cfg/strict.yaml.
std::vector<VolumeOfInterest> strictVolumes();

}  // namespace objectness::benchmarks
