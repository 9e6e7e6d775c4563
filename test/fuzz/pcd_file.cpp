// SPDX-License-Identifier: BSD-3-Clause
// A PCD file of any bytes.
#include "objectness_segmentation/io/pcd_file.hpp"

#include "frame_promises.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace objectness_fuzz;
  static const Folder folder;
  const auto cloud = objectness::loadPcd(folder.write("cloud.pcd", Bytes(data, size).rest()));
  requireReason(cloud.status);
  if (!cloud.ok()) return 0;
  const auto count = static_cast<std::size_t>(cloud.value.width) * static_cast<std::size_t>(cloud.value.height);
  require(count > 0 && cloud.value.points.size() == count, "a cloud has all its points");
  const objectness::InputConfig config;
  requireFrame(objectness::makeFrame(cloud.value, std::nullopt, config), config);
  return 0;
}
