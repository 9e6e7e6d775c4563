// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/peers/peers.hpp"

#include <algorithm>
#include <map>
#include <sstream>

#include "convex_parts.hpp"
#include "guarded_segmentation.hpp"
#include "io/quiet_pcl.hpp"
#include "mps.hpp"
#include "objectness_segmentation/scene/surface_check.hpp"

namespace objectness {
namespace {

template <class Visit>
void visitFields(Peer peer, const PeersConfig& settings, Visit&& visit) {
  if (peer == Peer::kMps) MpsConfig::fields(settings.mps, visit);
  if (peer == Peer::kLccp) LccpConfig::fields(settings.lccp, visit);
  if (peer == Peer::kCpc) CpcConfig::fields(settings.cpc, visit);
}

/// The first value out of its range, a sentence; empty when there is none.
struct RangeCheck {
  const char* peer;
  std::string problem;

  template <class T>
  void operator()(const char* name, const T& value, const Range& range, const char*) {
    if (!problem.empty() || (value >= range.min && value <= range.max)) return;
    std::ostringstream text;
    text << peer << "." << name << " is " << value << ", not within " << range.min << " to " << range.max;
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

std::string problemOf(Peer peer, const Config& config, const PeersConfig& settings) {
  const std::vector<std::string> problems = validate(config);
  if (!problems.empty()) return problems.front();
  RangeCheck check{toString(peer), ""};
  visitFields(peer, settings, check);
  const LccpConfig& lccp = peer == Peer::kCpc ? settings.cpc.lccp : settings.lccp;
  if (check.problem.empty() && peer != Peer::kMps && lccp.seed_m < lccp.voxel_m) {
    check.problem = std::string(toString(peer)) + ".seed_m is less than voxel_m: a supervoxel needs a voxel at least";
  }
  return check.problem;
}

/// Groups pixels by label, 0 left out; largest first, ties in the order of the pixels.
std::vector<Segment> collectSegments(const std::vector<int>& labels, std::size_t min_pixels) {
  std::map<int, Segment> by_label;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] > 0) by_label[labels[i]].pixels.push_back(static_cast<int>(i));
  }
  std::vector<Segment> segments;
  for (auto& [label, segment] : by_label) {
    if (segment.pixels.size() >= min_pixels) segments.push_back(std::move(segment));
  }
  std::sort(segments.begin(), segments.end(), [](const Segment& a, const Segment& b) {
    if (a.pixels.size() != b.pixels.size()) return a.pixels.size() > b.pixels.size();
    return a.pixels.front() < b.pixels.front();
  });
  return segments;
}

void run(Peer peer, const Frame& frame, const Config& config, const PeersConfig& settings, Segmentation& result) {
  const auto stage = [&](const char* name, auto&& work) {
    const StageTimer timer(result.report.timings_ms, name);
    return work();
  };
  const Normals normals = stage("normals", [&] { return estimateNormals(frame, config.normals); });
  result.status = checkSurfaces(frame);
  if (!result.status.ok()) return;
  const Result<Table> found = stage("table", [&] { return findTable(frame, normals, config.table); });
  result.table = found.value;
  result.status = found.status;
  if (!found.ok()) return;
  result.object_points =
      stage("object_points", [&] { return findObjectPoints(frame, normals, result.table, config.object_points); });

  const cv::Mat_<uchar>& mask = result.object_points.mask;
  int min_pixels = 0;
  const std::vector<int> labels = stage(toString(peer), [&] {
    const QuietPcl quiet;
    switch (peer) {
      case Peer::kMps:
        min_pixels = settings.mps.min_pixels;
        return labelMps(frame, normals, mask, settings.mps);
      case Peer::kLccp:
        min_pixels = settings.lccp.min_pixels;
        return labelLccp(frame, normals, mask, settings.lccp);
      default:
        min_pixels = settings.cpc.lccp.min_pixels;
        return labelCpc(frame, normals, mask, settings.cpc);
    }
  });
  result.segments = collectSegments(labels, static_cast<std::size_t>(min_pixels));
  keepMeasured(frame.bridged, result.segments);
  result.labels = labelImage(result.object_points.on_table, frame.bridged, result.segments);
  result.report.counts.emplace_back("object_points", cv::countNonZero(mask));
  result.report.counts.emplace_back("segments", result.segments.size());
}

}  // namespace

const char* toString(Peer peer) {
  switch (peer) {
    case Peer::kMps:
      return "mps";
    case Peer::kLccp:
      return "lccp";
    default:
      return "cpc";
  }
}

Segmentation segmentWithPeer(Peer peer, const Frame& frame, const Config& config, const PeersConfig& settings) {
  return guardedSegmentation(frame, [&](Segmentation& result) {
    const std::string problem = problemOf(peer, config, settings);
    if (problem.empty()) {
      run(peer, frame, config, settings, result);
    } else {
      result.status = Status::error(StatusCode::kBadConfig, problem);
    }
  });
}

std::string settingsText(Peer peer, const PeersConfig& settings) {
  SettingsPrinter printer;
  visitFields(peer, settings, printer);
  return printer.text.str();
}

}  // namespace objectness
