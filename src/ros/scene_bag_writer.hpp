// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "ros/bag_output.hpp"
#include "sim/simulated_frame.hpp"

namespace objectness_segmentation {

/// Writes simulated frames as the bag that a camera driver's topics would give, with the truth beside them. Topics and
/// coordinate frames are those in topics.hpp: /tf holds the camera's way, /tf_static its optical frame. /truth/labels
/// are the label images, /truth/objects the table and the true boxes and pixels of the objects that are not hidden, in
/// the optical frame, their label that of the image. Everything of a frame has the same stamp.
class SceneBagWriter {
 public:
  /// Replaces a file of that name.
  explicit SceneBagWriter(const std::string& path) : bag_(path) {}

  /// An error stays. kBadInput: the file cannot be written, or the stamp is 0.
  objectness::Status write(const objectness::sim::SimulatedFrame& frame, const ros::Time& stamp);
  objectness::Status close() { return bag_.close(); }

 private:
  BagOutput bag_;
  bool has_static_transform_ = false;
};

struct SceneBagSettings {
  objectness::sim::DepthSensor sensor;
  int frames = 1;
  double rate_hz = 10;
  bool still = false;  ///< the camera stays where the scene has it
  /// The seed of a frame's noise.
  std::function<std::uint32_t(int frame)> noise_seed = [](int frame) { return static_cast<std::uint32_t>(frame); };
};

/// A recording of a camera that swings about the scene (sim::orbitPose()) or stands still, frame i at kFirstStamp_s + i
/// / rate_hz. The same arguments give the same bytes.
constexpr std::uint32_t kFirstStamp_s = 1000;
objectness::Status writeSceneBag(const std::string& path, const objectness::sim::Scene& scene,
                                 const SceneBagSettings& settings);

}  // namespace objectness_segmentation
