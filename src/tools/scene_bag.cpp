// SPDX-License-Identifier: BSD-3-Clause
#include "tools/scene_bag.hpp"

#ifdef OBJECTNESS_WITH_ROS
#include "ros/scene_bag_writer.hpp"
#include "sim/scene_generator.hpp"
#endif

namespace objectness::sim {

#ifdef OBJECTNESS_WITH_ROS

Status writeBag(const Scene& scene, std::uint32_t index, const MakeSceneOptions& options) {
  objectness_segmentation::SceneBagSettings settings{options.sensor, options.frames.value_or(1), options.rate_hz};
  settings.still = options.still;
  settings.noise_seed = [&](int frame) { return noiseSeed(options.seed, index, frame); };
  Status status = objectness_segmentation::writeSceneBag(options.bag, scene, settings);
  if (!status.ok()) status.message = options.bag + ": " + status.message;
  return status;
}

#else

Status writeBag(const Scene&, std::uint32_t, const MakeSceneOptions& options) {
  return Status::error(StatusCode::kBadConfig,
                       options.bag + ": this make_scene was built without ROS and writes no bags; use --out DIR");
}

#endif

}  // namespace objectness::sim
