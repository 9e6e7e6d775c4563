// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/evaluation/methods.hpp"

#include <algorithm>

#include "objectness_segmentation/io/config_yaml.hpp"
#include "objectness_segmentation/peers/peers.hpp"
#include "objectness_segmentation/pipeline.hpp"

namespace objectness::evaluation {
namespace {

Method ownMethod(const std::string& name, const std::string& description, const Config& config) {
  return {name, description, toYaml(config), [config](const Frame& frame) { return segment(frame, config); }, true};
}

/// Peers get the table and the points above it that the package's defaults find.
Method peerMethod(Peer peer, const std::string& description, const Config& config) {
  return {toString(peer), description, settingsText(peer, PeersConfig{}) + "\n\n" + toYaml(config),
          [peer, config](const Frame& frame) { return segmentWithPeer(peer, frame, config, PeersConfig{}); }};
}

std::vector<Method> allMethods(int threads) {
  Config defaults;
  defaults.runtime.threads = threads;
  Config plain_boxes = defaults;
  plain_boxes.segments.follow_superpixels = false;
  return {
      ownMethod("objectness", "The package's default.", defaults),
      ownMethod("paper", "The paper's system; whole superpixels follow the box that holds most of them.", defaults),
      ownMethod("boxes", "The paper's system; segments are the pixels within its boxes.", plain_boxes),
      peerMethod(Peer::kMps, "PCL's organized multi-plane segmentation, the paper's baseline.", defaults),
      peerMethod(Peer::kLccp, "PCL's locally convex connected patches over supervoxels.", defaults),
      peerMethod(Peer::kCpc, "PCL's constrained planar cuts over supervoxels.", defaults),
  };
}

}  // namespace

std::vector<std::string> methodNames() {
  std::vector<std::string> names;
  for (const Method& method : allMethods(1)) names.push_back(method.name);
  return names;
}

Result<std::vector<Method>> makeMethods(const std::vector<std::string>& names, int threads) {
  const std::vector<Method> all = allMethods(threads);
  Result<std::vector<Method>> chosen;
  for (const std::string& name : names) {
    const auto method = std::find_if(all.begin(), all.end(), [&](const Method& m) { return m.name == name; });
    if (method == all.end()) {
      std::string known;
      for (const Method& m : all) known += (known.empty() ? "" : ", ") + m.name;
      return Result<std::vector<Method>>::error(StatusCode::kBadConfig,
                                                "there is no method '" + name + "', only " + known);
    }
    const bool again =
        std::any_of(chosen.value.begin(), chosen.value.end(), [&](const Method& m) { return m.name == name; });
    if (!again) chosen.value.push_back(*method);
  }
  return chosen;
}

}  // namespace objectness::evaluation
