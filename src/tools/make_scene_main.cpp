// SPDX-License-Identifier: BSD-3-Clause
// Writes the built-in demo scene as a scene folder.
#include <boost/program_options.hpp>
#include <iostream>

#include "objectness_segmentation/ros/scene_bag_writer.hpp"
#include "objectness_segmentation/sim/demo_scene.hpp"
#include "objectness_segmentation/sim/simulated_frame.hpp"

int main(int argc, char** argv) {
  namespace po = boost::program_options;
  po::options_description options(
      "make_scene --demo --out DIR [--seed N]\n\nWrites a simulated table with boxes, cylinders and a bowl: "
      "depth.png, color.png, camera.yaml, labels.png (truth)");
  auto add = options.add_options();
  add("out", po::value<std::string>()->value_name("DIR"), "the scene folder, made when missing");
  add("bag", po::value<std::string>()->value_name("FILE.bag"),
      "a recording of a camera that moves about the scene, with the truth in it; replaced when it exists");
  add("frames", po::value<int>()->value_name("N")->default_value(1), "of the bag");
  add("rate", po::value<double>()->value_name("HZ")->default_value(10), "frames of the bag a second");
  add("demo", po::bool_switch(), "the built-in scene");
  add("seed", po::value<std::uint32_t>()->value_name("N")->default_value(1),
      "moves the objects a little, makes the noise");
  add("help,h", "print this");
  try {
    po::variables_map values;
    po::store(po::command_line_parser(argc, argv).options(options).positional({}).run(), values);
    if (values.count("help")) {
      std::cout << options;
      return 0;
    }
    po::notify(values);
    const auto seed = values["seed"].as<std::uint32_t>();
    const objectness::sim::Scene scene = objectness::sim::makeDemoScene(seed);
    if (values.count("bag")) {
      const auto path = values["bag"].as<std::string>();
      objectness_segmentation::SceneBagSettings settings;
      settings.seed = seed;
      settings.frames = values["frames"].as<int>();
      settings.rate_hz = values["rate"].as<double>();
      const objectness::Status status = objectness_segmentation::writeSceneBag(path, scene, settings);
      if (!status.ok()) {
        std::cerr << "make_scene: --bag " << path << ": " << status.message << std::endl;
        return 1;
      }
    }
    if (!values.count("out")) return 0;
    const auto frame =
        objectness::sim::simulateFrame(scene, scene.T_world_camera, objectness::sim::DepthSensor(), seed);
    const objectness::Status status = objectness::sim::saveSimulatedFrame(values["out"].as<std::string>(), frame);
    if (status.ok()) return 0;
    std::cerr << "make_scene: " << status.message << std::endl;
    return 1;
  } catch (const po::error& e) {
    std::cerr << "make_scene: " << e.what() << " (make_scene --help)" << std::endl;
    return 2;
  }
}
