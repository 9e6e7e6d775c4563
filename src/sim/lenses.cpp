// SPDX-License-Identifier: BSD-3-Clause
#include "sim/lenses.hpp"

#include "sim/named.hpp"

namespace objectness::sim {
namespace {

PinholeCamera centred(double focal_px, int width, int height) {
  return {focal_px, focal_px, (width - 1) / 2.0, (height - 1) / 2.0, width, height};
}

}  // namespace

const std::vector<Lens>& lenses() {
  static const std::vector<Lens> all{
      {"xtion_qvga", centred(285, 320, 240)},    {"kinect", centred(525, 640, 480)},
      {"xtion", centred(570, 640, 480)},         {"realsense", centred(615, 640, 480)},
      {"realsense_hd", centred(920, 1280, 720)}, {"d405", centred(645, 1280, 720)},
      {"azure", centred(610, 1280, 720)},        {"realsense_full_hd", centred(1380, 1920, 1080)}};
  return all;
}

const PinholeCamera* findLens(const std::string& name) {
  const Lens* found = findNamed(lenses(), name);
  return found ? &found->camera : nullptr;
}

std::string lensNames() { return namesOf(lenses()); }

}  // namespace objectness::sim
