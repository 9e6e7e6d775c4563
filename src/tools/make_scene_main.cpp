// SPDX-License-Identifier: BSD-3-Clause
// Simulates scenes with their truth: see `make_scene --help`.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "sim/demo_scene.hpp"
#include "sim/scene_generator.hpp"
#include "sim/simulated_frame.hpp"
#include "sim/truth_file.hpp"
#include "tools/make_scene_options.hpp"
#include "tools/scene_bag.hpp"
#include "tools/tool_message.hpp"

namespace {

using namespace objectness;
using namespace objectness::sim;
namespace fs = std::filesystem;

enum ExitStatus { kAllDone = 0, kSomeFailed = 1, kUsageError = 2 };

std::string numbered(const std::string& name, int number) {
  char digits[16];
  std::snprintf(digits, sizeof digits, "_%04d", number);
  return name + digits;
}

/// One picture, or all of the sequence.
Status writeFolders(const Scene& scene, std::uint32_t index, const MakeSceneOptions& options, const fs::path& folder) {
  const auto write = [&](const Eigen::Isometry3d& T_world_camera, int frame, const fs::path& to) {
    const std::uint32_t noise = noiseSeed(options.seed, index, frame);
    return saveSimulatedFrame(to.string(), simulateFrame(scene, T_world_camera, options.sensor, noise));
  };
  Status status;
  if (options.frames) {
    for (int frame = 0; frame < *options.frames && status.ok(); ++frame) {
      status = write(options.still ? scene.T_world_camera : orbitPose(scene, frame, *options.frames), frame,
                     folder / numbered("frame", frame));
    }
  } else {
    status = write(scene.T_world_camera, 0, folder);
  }
  return status;
}

/// What was asked for of one scene. Prints how many objects there are.
Status writeScene(const Scene& scene, std::uint32_t index, const MakeSceneOptions& options, const fs::path& folder) {
  Status status;
  if (!options.bag.empty()) status = writeBag(scene, index, options);
  if (status.ok() && !options.out.empty()) status = writeFolders(scene, index, options, folder);
  if (status.ok()) {
    std::cout << (options.out.empty() ? options.bag : folder.string()) << ": " << scene.level << ", "
              << scene.objects.size() << " objects" << std::endl;
  }
  return status;
}

/// What is said when a scene cannot be made or written; empty when all went well.
std::string makeScene(const std::string& level, int index, const MakeSceneOptions& options, const fs::path& folder) {
  try {
    SceneRequest request;
    request.level = level;
    request.seed = options.seed;
    request.index = static_cast<std::uint32_t>(index);
    request.objects = options.objects;
    request.table = options.table;
    request.around = options.around;
    request.min_table_share = options.table_share.value_or(request.min_table_share);
    request.camera = options.sensor.camera;
    const Result<Scene> scene = generateScene(request);
    return (scene.ok() ? writeScene(scene.value, request.index, options, folder) : scene.status).message;
  } catch (const std::bad_alloc&) {
    return "needs more memory than there is";
  } catch (const std::exception& e) {
    return e.what();
  }
}

void printError(const std::string& message) { printToolMessage("make_scene", message); }

/// Many scenes, and the list of their groups for evaluations.
ExitStatus makeScenes(const MakeSceneOptions& options) {
  std::error_code error;
  fs::create_directories(options.out, error);
  if (error) {
    printError("cannot make the folder " + options.out + ": " + error.message());
    return kSomeFailed;
  }
  ExitStatus exit_status = kAllDone;
  std::string groups = "scene,group\n";
  for (const std::string& level : options.levels) {
    for (int index = 0; index < *options.count; ++index) {
      const std::string name = numbered(level, index);
      const std::string problem = makeScene(level, index, options, fs::path(options.out) / name);
      if (problem.empty()) {
        groups += name + "," + level + "\n";
      } else {
        printError(name + ": " + problem);
        exit_status = kSomeFailed;
      }
    }
  }
  const std::string path = (fs::path(options.out) / "groups.csv").string();
  if (std::ofstream(path) << groups) return exit_status;
  printError("cannot write " + path);
  return kSomeFailed;
}

}  // namespace

int main(int argc, char** argv) {
  const Result<MakeSceneOptions> parsed = parseMakeSceneOptions(argc, argv);
  if (!parsed.ok()) {
    printError(parsed.status.message + " (make_scene --help)");
    return kUsageError;
  }
  const MakeSceneOptions& options = parsed.value;
  if (!options.print.empty()) {
    std::cout << options.print << std::flush;
    return std::cout ? kAllDone : kSomeFailed;
  }
  if (options.count) return makeScenes(options);
  const std::string problem = options.levels.empty()
                                  ? writeScene(makeDemoScene(options.seed), 0, options, options.out).message
                                  : makeScene(options.levels.front(), 0, options, options.out);
  if (problem.empty()) return kAllDone;
  printError(problem);
  return kSomeFailed;
}
