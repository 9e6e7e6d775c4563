// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node_settings.hpp"

#include <sstream>

#include "objectness_segmentation/ros/topics.hpp"

namespace objectness_segmentation {
namespace {

constexpr int kMaxQueueSize = 1000;
constexpr double kMaxTransformTimeout_s = 60;  // the wait ends with the nodelet, too
constexpr double kMaxServiceTimeout_s = 3600;

/// Reads single parameters and gathers what is wrong with them.
class Reader {
 public:
  Reader(const ros::NodeHandle& nh, std::vector<std::string>& problems) : nh_(nh), problems_(problems) {}

  template <class T>
  void read(const char* name, T& value, const char* expected) const {
    T given{};
    if (!nh_.hasParam(name)) return;
    if (nh_.getParam(name, given)) {
      value = given;
    } else {
      complain(name, std::string("must be ") + expected);
    }
  }
  template <class T>
  void read(const char* name, T& value, const char* expected, T least, T largest) const {
    T given = value;
    read(name, given, expected);
    if (given >= least && given <= largest) {
      value = given;
    } else {
      std::ostringstream why;
      why << "is " << given << ", must be " << expected << " from " << least << " to " << largest;
      complain(name, why.str());
    }
  }
  void frame(const char* name, std::string& value) const {
    read(name, value, "the name of a frame");
    if (value.empty() || value[0] != '/') return;
    value.erase(0, 1);
    problems_.push_back("parameter " + nh_.resolveName(name) + " begins with /, which tf2 does not know: " + value +
                        " is used");
  }
  void complain(const char* name, const std::string& why) const {
    problems_.push_back("parameter " + nh_.resolveName(name) + " " + why + ": it is not used");
  }

 private:
  const ros::NodeHandle& nh_;
  std::vector<std::string>& problems_;
};

}  // namespace

ReadSettings readSettings(const ros::NodeHandle& nh) {
  ReadSettings result;
  NodeSettings& settings = result.settings;
  const Reader reader(nh, result.problems);
  std::string input = "points";
  reader.read("input", input, "points or depth");
  settings.input.depth = input == "depth";
  if (input != "points" && input != "depth") reader.complain("input", "is '" + input + "', must be points or depth");
  settings.input.queue_size = kSynchronizerQueueSize;
  reader.read("queue_size", settings.input.queue_size, "a whole number", 1, kMaxQueueSize);
  reader.read("approximate_sync", settings.input.approximate, "true or false");
  reader.read("lazy", settings.lazy, "true or false");
  reader.read("latch", settings.latch, "true or false");
  reader.read("keep_memory", settings.keep_memory, "true or false");
  reader.read("fuse_frames", settings.fuse_frames, "a whole number", 1, objectness::kMostFused);
  reader.read("model", settings.model, "the path of a file");
  reader.frame("target_frame", settings.target_frame);
  reader.frame("up_frame", settings.up_frame);
  reader.frame("fixed_frame", settings.fixed_frame);
  reader.read("transform_timeout", settings.transform_timeout_s, "a number of seconds", 0.0, kMaxTransformTimeout_s);
  reader.read("service_timeout", settings.service_timeout_s, "a number of seconds", 0.01, kMaxServiceTimeout_s);
  return result;
}

const std::vector<std::string>& settingNames() {
  static const std::vector<std::string> names = {"input",
                                                 "queue_size",
                                                 "approximate_sync",
                                                 "lazy",
                                                 "latch",
                                                 "keep_memory",
                                                 "fuse_frames",
                                                 "model",
                                                 "target_frame",
                                                 "up_frame",
                                                 "fixed_frame",
                                                 "transform_timeout",
                                                 "service_timeout",
                                                 "image_transport",
                                                 "depth_image_transport",
                                                 "diagnostic_period",
                                                 "num_worker_threads"};
  return names;
}

}  // namespace objectness_segmentation
