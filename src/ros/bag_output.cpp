// SPDX-License-Identifier: BSD-3-Clause
#include "ros/bag_output.hpp"

namespace objectness_segmentation {

BagOutput::BagOutput(const std::string& path) {
  guard([&] {
    bag_ = std::make_unique<rosbag::Bag>(path, rosbag::bagmode::Write);
    bag_->setCompression(rosbag::compression::LZ4);
  });
}

objectness::Status BagOutput::close() {
  if (!bag_) return status_;
  const objectness::Status before = std::exchange(status_, {});
  guard([&] { bag_->close(); });
  // A bag that could not be closed tries again in its destructor, and throws there.
  if (!status_.ok()) static_cast<void>(bag_.release());
  bag_.reset();
  if (!before.ok()) status_ = before;
  return status_;
}

}  // namespace objectness_segmentation
