// SPDX-License-Identifier: BSD-3-Clause
// The compiled part of the Python module. What users call, its checks and its documentation are in
// objectness_segmentation/*.py; here NumPy's arrays become frames, and results arrays and the text of objects.json.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "objectness_segmentation/io/config_yaml.hpp"
#include "objectness_segmentation/io/result_writer.hpp"
#include "objectness_segmentation/pipeline.hpp"
#include "objectness_segmentation/sequence.hpp"
#include "python/numpy_images.hpp"

namespace py = pybind11;

namespace objectness::python {
namespace {

/// Row-major 4 x 4 of T_fixed_camera.
using Pose = std::array<double, 16>;

/// What is asked of every frame.
struct Images {
  Images(const py::array& depth_array, const py::array& color_array, const std::array<double, 4>& fx_fy_cx_cy)
      : depth(depthView(depth_array)), color(bgrOf(color_array)) {
    const auto& [fx, fy, cx, cy] = fx_fy_cx_cy;
    camera = {fx, fy, cx, cy, depth.cols, depth.rows};
  }

  cv::Mat depth;  ///< the caller's memory
  cv::Mat_<cv::Vec3b> color;
  PinholeCamera camera;
};

/// (name of the status, its sentence)
py::tuple pythonStatus(const Status& status) { return py::make_tuple(toString(status.code), status.message); }

/// (status, warnings)
py::tuple setParametersOf(Config& config, const std::vector<std::string>& assignments) {
  std::vector<std::string> warnings;
  const Status status = setParameters(assignments, config, &warnings);
  return py::make_tuple(pythonStatus(status), warnings);
}

/// (status, labels, objects.json)
py::tuple segmentImages(const py::array& depth, const std::array<double, 4>& fx_fy_cx_cy, const py::array& color,
                        const Config& config) {
  const Images images(depth, color, fx_fy_cx_cy);
  Segmentation result;
  std::string json;
  {
    const py::gil_scoped_release others_may_run;
    const Result<Frame> frame = makeFrame(images.depth, images.color, images.camera, config.input);
    if (frame.ok()) {
      result = segment(frame.value, config);
    } else {
      result.status = frame.status;
    }
    json = toJson("", result);
  }
  return py::make_tuple(pythonStatus(result.status), labelArray(result.labels), json);
}

std::optional<Eigen::Isometry3d> poseOf(const std::optional<Pose>& values) {
  if (!values) return {};
  Eigen::Isometry3d pose;
  pose.matrix() = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(values->data());
  return pose;
}

py::list pythonIdentities(const std::vector<Identity>& identities) {
  using namespace pybind11::literals;
  py::list list;
  for (const Identity& identity : identities) {
    list.append(py::dict("label"_a = identity.label, "id"_a = identity.id, "age_frames"_a = identity.age_frames,
                         "age_s"_a = identity.age_s, "confidence"_a = identity.confidence));
  }
  return list;
}

/// A FrameSequence that threads may share: their frames come one after the other.
class Sequence {
 public:
  explicit Sequence(int fuse_frames) : frames_(fuse_frames) {}

  /// (status, labels, objects.json, identities)
  py::tuple next(const py::array& depth, const std::array<double, 4>& fx_fy_cx_cy, const py::array& color,
                 const Config& config, double time_s, const std::optional<Pose>& T_fixed_camera) {
    const Images images(depth, color, fx_fy_cx_cy);
    SequenceResult result;
    std::string json;
    {
      const py::gil_scoped_release others_may_run;  // before the lock, whose owner needs the interpreter to return
      const std::lock_guard<std::mutex> lock(mutex_);
      Result<Frame> frame = makeFrame(images.depth, images.color, images.camera, config.input);
      if (frame.ok()) {
        result = frames_.next(std::move(frame.value), poseOf(T_fixed_camera), time_s, config);
      } else {
        result.segmentation.status = frame.status;
      }
      json = toJson("", result.segmentation);
    }
    return py::make_tuple(pythonStatus(result.segmentation.status), labelArray(result.segmentation.labels), json,
                          pythonIdentities(result.identities));
  }

 private:
  std::mutex mutex_;
  FrameSequence frames_;
};

}  // namespace
}  // namespace objectness::python

PYBIND11_MODULE(_core, module) {
  using namespace objectness;
  using namespace objectness::python;
  module.doc() = "The compiled part of objectness_segmentation: no interface.";
  module.attr("MAX_FUSE_FRAMES") = kMostFused;
  module.attr("FUSE_FRAMES") = kFuseFrames;
  py::class_<Config>(module, "Config").def(py::init<>()).def("set", &setParametersOf);
  module.def("segment", &segmentImages);
  py::class_<Sequence>(module, "Sequence").def(py::init<int>()).def("next", &Sequence::next);
}
