// SPDX-License-Identifier: BSD-3-Clause
// Writes the built-in demo scene as a scene folder.
#include <boost/program_options.hpp>
#include <iostream>

#include "objectness_segmentation/sim/demo_scene.hpp"
#include "objectness_segmentation/sim/simulated_frame.hpp"

int main(int argc, char** argv) {
  namespace po = boost::program_options;
  po::options_description options(
      "make_scene --demo --out DIR [--seed N]\n\nWrites a simulated table with boxes, cylinders and a bowl: "
      "depth.png, color.png, camera.yaml, labels.png (truth)");
  auto add = options.add_options();
  add("out", po::value<std::string>()->value_name("DIR")->required(), "the scene folder, made when missing");
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
