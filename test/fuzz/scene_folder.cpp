// SPDX-License-Identifier: BSD-3-Clause
// A scene folder of any two pictures and camera file. Checksums of PNG chunks are put right first, or nothing would get
// past them.
#include "objectness_segmentation/io/scene_folder.hpp"

#include <boost/crc.hpp>

#include "frame_promises.hpp"

namespace {

std::uint32_t bigEndian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = at; i < at + 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

void correctChecksums(std::string& png) {
  constexpr std::size_t kSignature = 8, kFrame = 12;
  for (std::size_t at = kSignature; at + kFrame <= png.size();) {
    const std::size_t length = bigEndian(png, at);
    if (length > png.size() - at - kFrame) return;
    boost::crc_32_type checksum;
    checksum.process_bytes(png.data() + at + 4, length + 4);
    for (int i = 0; i < 4; ++i) png[at + 8 + length + i] = static_cast<char>(checksum.checksum() >> (24 - 8 * i));
    at += kFrame + length;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace objectness_fuzz;
  static const Folder folder;
  Bytes bytes(data, size);
  const bool checksums_hold = (bytes.take<std::uint8_t>() & 1) == 0;
  for (const char* name : {"depth.png", "color.png"}) {
    std::string png = bytes.part();
    if (checksums_hold) correctChecksums(png);
    folder.write(name, png);
  }
  folder.write("camera.yaml", bytes.rest());
  const objectness::InputConfig config;
  requireFrame(objectness::loadSceneFolder(folder.path(), std::nullopt, config), config);
  requireFrame(objectness::loadSceneFolder(folder.path(), objectness::PinholeCamera{20, 20, 7.5, 5.5, 16, 12}, config),
               config);
  return 0;
}
