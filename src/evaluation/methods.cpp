// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/methods.hpp"

#include <algorithm>
#include <boost/crc.hpp>
#include <memory>

#include "baselines/baselines.hpp"
#include "evaluation/piece_methods.hpp"
#include "objectness_segmentation/io/config_yaml.hpp"
#include "objectness_segmentation/pipeline.hpp"
#include "objectness_segmentation/sequence.hpp"

namespace objectness::evaluation {
namespace {

using Follow = decltype(Method::follow);

/// model: nullptr for the built-in one.
Follow followWith(const Config& config, const std::shared_ptr<const LearnedObjectness>& model) {
  return [config, model](int fuse_frames) {
    const auto sequence = std::make_shared<FrameSequence>(fuse_frames);
    return [config, model, sequence](const Frame& frame) {
      return sequence->next(frame, {}, 0, config, model.get()).segmentation;
    };
  };
}

Method ownMethod(const std::string& name, const std::string& description, const Config& config) {
  Method method{name, description, toYaml(config), [config](const Frame& frame) { return segment(frame, config); },
                true, config.input};
  method.follow = followWith(config, nullptr);
  return method;
}

/// Results of different models must not be taken for one another: a model is known by the sum of all it holds.
std::string modelText(const LearnedObjectness& model) {
  const std::string text = toJson(model);
  boost::crc_32_type sum;
  sum.process_bytes(text.data(), text.size());
  return "\nmodel: " + model.trained_on + " (checksum " + std::to_string(sum.checksum()) + ")\n";
}

Method learnedMethod(const std::string& name, const std::string& description, const Config& config,
                     const std::optional<LearnedObjectness>& model) {
  Method method = ownMethod(name, description, config);
  if (!model) return method;
  method.settings += modelText(*model);
  const auto shared = std::make_shared<const LearnedObjectness>(*model);
  method.run = [config, shared](const Frame& frame) { return segment(frame, config, *shared); };
  method.follow = followWith(config, shared);
  return method;
}

/// mps, lccp and cpc get the table and the points above it that the package finds.
Method baselineMethod(Baseline baseline, const std::string& description, const Config& config) {
  return {toString(baseline),
          description,
          settingsText(baseline, BaselinesConfig{}) + "\n\n" + toYaml(config),
          [baseline, config](const Frame& frame) {
            return segmentWithBaseline(baseline, frame, config, BaselinesConfig{});
          },
          false,
          config.input};
}

Method oracleMethod(const Config& config) {
  Method method{"oracle",
                "Perfect choice: every superpixel piece of the default method goes to its true object.",
                "perfect choice\n\n" + toYaml(config),
                {},
                false,
                config.input};
  method.run_knowing = [config](const Frame& frame, const cv::Mat_<ushort>& true_labels) {
    return segmentByOracle(frame, true_labels, config);
  };
  return method;
}

Method clusteringMethod(const Config& config, const std::optional<LearnedObjectness>& model) {
  const auto shared = model ? std::make_shared<const LearnedObjectness>(*model) : nullptr;
  return {"clustering",
          "Plain correlation clustering of the default method's links, by greedy additive edge contraction.",
          "correlation clustering\n\n" + toYaml(config) + (model ? modelText(*model) : ""),
          [config, shared](const Frame& frame) { return segmentByClustering(frame, config, shared.get()); },
          false,
          config.input};
}

std::vector<Method> allMethods(Config config, const std::optional<LearnedObjectness>& model) {
  config.pipeline.method = SegmentationMethod::kObjectness;
  Config paper = config, plain_boxes = config;
  paper.pipeline.method = SegmentationMethod::kPaper;
  plain_boxes.pipeline.method = SegmentationMethod::kBoxes;
  return {
      learnedMethod("objectness", "The package's default.", config, model),
      ownMethod("paper", "The paper's system; whole superpixels follow the box that holds most of them.", paper),
      ownMethod("boxes", "The paper's system; segments are the pixels within its boxes.", plain_boxes),
      baselineMethod(Baseline::kMps, "PCL's organized multi-plane segmentation, the paper's baseline.", config),
      baselineMethod(Baseline::kLccp, "PCL's locally convex connected patches over supervoxels.", config),
      baselineMethod(Baseline::kCpc, "PCL's constrained planar cuts over supervoxels.", config),
      baselineMethod(Baseline::kEuclidean, "PCL alone: passthrough, a plane by RANSAC, Euclidean clusters of the rest.",
                     config),
      baselineMethod(Baseline::kOrganized,
                     "PCL alone: passthrough, a plane by RANSAC, connected components of the rest.", config),
      clusteringMethod(config, model),
      oracleMethod(config),
  };
}

}  // namespace

std::vector<std::string> methodNames() {
  std::vector<std::string> names;
  for (const Method& method : allMethods({}, {})) names.push_back(method.name);
  return names;
}

std::vector<std::string> usualMethodNames() {
  std::vector<std::string> names = methodNames();
  const auto unusual = [](const std::string& name) { return name == "oracle" || name == "clustering"; };
  names.erase(std::remove_if(names.begin(), names.end(), unusual), names.end());
  return names;
}

Result<std::vector<Method>> makeMethods(const std::vector<std::string>& names, const Config& config,
                                        const std::optional<LearnedObjectness>& model) {
  const std::vector<Method> all = allMethods(config, model);
  Result<std::vector<Method>> chosen;
  for (const std::string& name : names) {
    const auto method = std::find_if(all.begin(), all.end(), [&](const Method& m) { return m.name == name; });
    if (method == all.end()) {
      std::string known;
      for (const Method& m : all) known += (known.empty() ? "" : ", ") + m.name;
      return Result<std::vector<Method>>::error(StatusCode::kBadConfig,
                                                "there is no method '" + name + "', only " + known);
    }
    const bool again =
        std::any_of(chosen.value.begin(), chosen.value.end(), [&](const Method& m) { return m.name == name; });
    if (!again) chosen.value.push_back(*method);
  }
  return chosen;
}

}  // namespace objectness::evaluation
