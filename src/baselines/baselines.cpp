// SPDX-License-Identifier: BSD-3-Clause
#include "baselines/baselines.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <sstream>

#include "baselines/convex_parts.hpp"
#include "baselines/euclidean_clusters.hpp"
#include "baselines/mps.hpp"
#include "baselines/organized_clusters.hpp"
#include "baselines/ransac_plane.hpp"
#include "common/thread_pool.hpp"
#include "front_end.hpp"
#include "guarded_segmentation.hpp"
#include "io/quiet_pcl.hpp"
#include "needed_resolution.hpp"
#include "scene/plane_grid.hpp"
#include "segments/segments.hpp"

namespace objectness {
namespace {

template <class Visit>
void visitFields(Baseline baseline, const BaselinesConfig& settings, Visit&& visit) {
  if (baseline == Baseline::kMps) MpsConfig::fields(settings.mps, visit);
  if (baseline == Baseline::kLccp) LccpConfig::fields(settings.lccp, visit);
  if (baseline == Baseline::kCpc) CpcConfig::fields(settings.cpc, visit);
  if (baseline == Baseline::kEuclidean) EuclideanConfig::fields(settings.euclidean, visit);
  if (baseline == Baseline::kOrganized) OrganizedConfig::fields(settings.organized, visit);
}

/// The first value out of its range, a sentence; empty when there is none.
struct RangeCheck {
  const char* baseline;
  std::string problem;

  template <class T>
  void operator()(const char* name, const T& value, const Range& range, const char*) {
    if (!problem.empty() || (value >= range.min && value <= range.max)) return;
    std::ostringstream text;
    text << baseline << "." << name << " is " << value << ", not within " << range.min << " to " << range.max;
    problem = text.str();
  }
  void operator()(const char*, const bool&, const char*) {}
};

struct SettingsPrinter {
  std::ostringstream text;

  template <class T>
  void operator()(const char* name, const T& value, const Range&, const char*) {
    text << (text.tellp() > 0 ? ", " : "") << name << " " << value;
  }
  void operator()(const char* name, const bool& value, const char*) {
    text << (text.tellp() > 0 ? ", " : "") << name << " " << (value ? "on" : "off");
  }
};

bool isPclAlone(Baseline baseline) { return baseline == Baseline::kEuclidean || baseline == Baseline::kOrganized; }

std::string problemOf(Baseline baseline, const Config& config, const BaselinesConfig& settings) {
  const std::vector<std::string> problems = validate(config);
  if (!problems.empty()) return problems.front();
  RangeCheck check{toString(baseline), ""};
  visitFields(baseline, settings, check);
  const bool has_supervoxels = baseline == Baseline::kLccp || baseline == Baseline::kCpc;
  const LccpConfig& lccp = baseline == Baseline::kCpc ? settings.cpc.lccp : settings.lccp;
  if (check.problem.empty() && has_supervoxels && lccp.seed_m < lccp.voxel_m) {
    check.problem =
        std::string(toString(baseline)) + ".seed_m is less than voxel_m: a supervoxel needs a voxel at least";
  }
  return check.problem;
}

struct Sizes {
  int min_pixels, max_pixels = std::numeric_limits<int>::max();
};

/// Groups pixels by label, 0 left out; largest first, ties in the order of the pixels.
std::vector<Segment> collectSegments(const std::vector<int>& labels, const Sizes& sizes) {
  std::map<int, Segment> by_label;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] > 0) by_label[labels[i]].pixels.push_back(static_cast<int>(i));
  }
  std::vector<Segment> segments;
  for (auto& [label, segment] : by_label) {
    const int pixels = static_cast<int>(segment.pixels.size());
    if (pixels >= sizes.min_pixels && pixels <= sizes.max_pixels) segments.push_back(std::move(segment));
  }
  std::sort(segments.begin(), segments.end(), [](const Segment& a, const Segment& b) {
    if (a.pixels.size() != b.pixels.size()) return a.pixels.size() > b.pixels.size();
    return a.pixels.front() < b.pixels.front();
  });
  return segments;
}

/// In the place of the front end: what PCL alone has for a table.
void observePlane(const Frame& frame, const RansacPlaneConfig& config, const Stages& stage, SceneObservation& scene) {
  Result<PlaneCut> found = stage("plane", [&] { return cutByPlane(frame, config); });
  scene.status = found.status;
  if (!scene.status.ok()) return;
  static_cast<Plane&>(scene.table) = found.value.plane;
  scene.table.T_table_camera = tableFrame(found.value.plane);
  scene.object_points = std::move(found.value.points);
}

void observe(Baseline baseline, const Frame& frame, const Config& config, const BaselinesConfig& settings,
             const Stages& stage, SceneObservation& scene) {
  if (baseline == Baseline::kEuclidean) {
    observePlane(frame, settings.euclidean.plane, stage, scene);
  } else if (baseline == Baseline::kOrganized) {
    observePlane(frame, settings.organized.plane, stage, scene);
  } else {
    observeTable(frame, config, stage, scene);
  }
}

std::vector<int> labelObjects(Baseline baseline, const Frame& frame, const BaselinesConfig& settings,
                              const SceneObservation& scene, Sizes& sizes) {
  const cv::Mat_<uchar>& mask = scene.object_points.mask;
  switch (baseline) {
    case Baseline::kMps:
      sizes = {settings.mps.min_pixels};
      return labelMps(frame, scene.normals, mask, settings.mps);
    case Baseline::kLccp:
      sizes = {settings.lccp.min_pixels};
      return labelLccp(frame, scene.normals, mask, settings.lccp);
    case Baseline::kCpc:
      sizes = {settings.cpc.lccp.min_pixels};
      return labelCpc(frame, scene.normals, mask, settings.cpc);
    case Baseline::kEuclidean:
      sizes = {settings.euclidean.min_pixels, settings.euclidean.max_pixels};
      return labelEuclideanClusters(frame, mask, settings.euclidean);
    default:
      sizes = {settings.organized.min_pixels, settings.organized.max_pixels};
      return labelOrganizedClusters(frame, mask, settings.organized.cluster_distance_m,
                                    settings.organized.depth_dependent);
  }
}

void run(Baseline baseline, const Frame& frame, const Config& config, const BaselinesConfig& settings,
         Segmentation& result) {
  const Stages stage(nullptr, result.report);
  const QuietPcl quiet;
  observe(baseline, frame, config, settings, stage, result);
  if (!result.status.ok()) return;
  Sizes sizes{0};
  const std::vector<int> labels =
      stage(toString(baseline), [&] { return labelObjects(baseline, frame, settings, result, sizes); });
  result.segments = collectSegments(labels, sizes);
  keepMeasured(frame.bridged, result.segments);
  result.labels = labelImage(result.object_points.on_table, frame.bridged, result.segments);
  stage.report().object_points = cv::countNonZero(result.object_points.mask);
  stage.report().segments = result.segments.size();
}

}  // namespace

const char* toString(Baseline baseline) {
  switch (baseline) {
    case Baseline::kMps:
      return "mps";
    case Baseline::kLccp:
      return "lccp";
    case Baseline::kCpc:
      return "cpc";
    case Baseline::kEuclidean:
      return "euclidean";
    default:
      return "organized";
  }
}

Segmentation segmentWithBaseline(Baseline baseline, const Frame& frame, const Config& config,
                                 const BaselinesConfig& settings) {
  return guardedSegmentation(frame, [&](Segmentation& result) {
    const std::string problem = problemOf(baseline, config, settings);
    if (problem.empty()) {
      const auto at = [&](const Frame& seen) { run(baseline, seen, config, settings, result); };
      if (isPclAlone(baseline)) {
        const ThreadPool pool(config.runtime.threads);
        at(frame);
      } else {
        atNeededResolution(frame, config, result, at);
      }
    } else {
      result.status = Status::error(StatusCode::kBadConfig, problem);
    }
  });
}

std::string settingsText(Baseline baseline, const BaselinesConfig& settings) {
  SettingsPrinter printer;
  visitFields(baseline, settings, printer);
  return printer.text.str();
}

}  // namespace objectness
