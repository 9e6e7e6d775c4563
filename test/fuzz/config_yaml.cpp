// SPDX-License-Identifier: BSD-3-Clause
// A preset of any text, as a file and as an assignment on the command line.
#include "objectness_segmentation/io/config_yaml.hpp"

#include "frame_promises.hpp"

namespace {

using namespace objectness_fuzz;

void requirePreset(const objectness::Status& status, const objectness::Config& config) {
  static const std::string defaults = objectness::toYaml(objectness::Config());
  requireReason(status);
  require(objectness::validate(config).empty(), "what is taken over is valid");
  require(status.ok() || objectness::toYaml(config) == defaults, "what is rejected changes nothing");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Folder folder;
  const std::string text = Bytes(data, size).rest();
  objectness::Config from_file, again, assigned;
  const objectness::Status loaded = objectness::loadConfig(folder.write("preset.yaml", text), from_file);
  requirePreset(loaded, from_file);
  requirePreset(objectness::setParameters({text}, assigned), assigned);
  if (!loaded.ok()) return 0;
  const std::string written = objectness::toYaml(from_file);
  require(objectness::loadConfig(folder.write("again.yaml", written), again).ok(), "what was written is read");
  require(objectness::toYaml(again) == written, "and is the same");
  return 0;
}
