// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/piece_methods.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>

#include "common/true_labels.hpp"
#include "evaluation/contracted_edges.hpp"
#include "finished_segments.hpp"
#include "front_end.hpp"
#include "grouping/bottom_up.hpp"
#include "grouping/links.hpp"
#include "grouping/object_judge.hpp"
#include "guarded_segmentation.hpp"
#include "needed_resolution.hpp"

namespace objectness::evaluation {
namespace {

/// What the choice among the pieces of a frame can go by.
struct PieceScene {
  const Frame& frame;
  const Segmentation& seen;
  const PieceGraph& graph;
};
using Choose = std::function<std::vector<GroupHypothesis>(const PieceScene&)>;

void run(const Frame& frame, const Config& config, const Choose& choose, Segmentation& result) {
  const Stages stage(nullptr, result.report);
  observeScene(frame, config, stage, result);
  if (!result.status.ok()) return;
  const PieceGraph graph = findPieceGraph(frame, result.normals, result.table, result.object_points, result.superpixels,
                                          config.pieces, config.links, config.runtime.threads);
  stage.report().pieces = graph.pieces.count();
  const std::vector<GroupHypothesis> groups = choose({frame, result, graph});
  std::vector<int> all(groups.size());
  std::iota(all.begin(), all.end(), 0);
  result.segments = cutGroups(graph.pieces, groups, all, config.segments);
  finishSegments(frame, config, stage, result);
}

Segmentation segmentBy(const Choose& choose, const Frame& frame, const Config& config) {
  return guardedSegmentation(frame, [&](Segmentation& result) {
    const std::vector<std::string> problems = validate(config);
    if (problems.empty()) {
      atNeededResolution(frame, config, result, [&](const Frame& seen) { run(seen, config, choose, result); });
    } else {
      result.status = Status::error(StatusCode::kBadConfig, problems.front());
    }
  });
}

std::vector<GroupHypothesis> describe(const PieceScene& scene, const std::vector<std::vector<int>>& groups,
                                      const std::vector<Link>& links, const Config& config) {
  auto described =
      describeGroups({scene.frame, scene.seen.table, scene.seen.edges, scene.graph.pieces, scene.graph.borders, links},
                     groups, config.runtime.threads);
  for (GroupHypothesis& group : described) group.cues = config.grouping.cues(group.cues);
  return described;
}

/// Intersection over union, in pixels, of an object and the pieces that are its own.
double overlapWith(int object, const std::vector<int>& pieces, const Pieces& all, const cv::Mat_<ushort>& true_labels) {
  int size = 0, own = 0, shared = 0;
  for (const ushort label : true_labels) size += trueObject(label) == object;
  for (const int k : pieces) {
    for (const int pixel : all.pieces[k].pixels) {
      ++own;
      shared += trueObject(true_labels(pixel / true_labels.cols, pixel % true_labels.cols)) == object;
    }
  }
  return static_cast<double>(shared) / (size + own - shared);
}

}  // namespace

std::vector<int> pieceOwners(const Pieces& pieces, const cv::Mat_<ushort>& true_labels) {
  std::vector<int> owners;
  for (const Piece& piece : pieces.pieces) {
    std::map<int, int> pixels;  // by object; -1: of none
    for (const int i : piece.pixels) ++pixels[trueObject(true_labels(i / true_labels.cols, i % true_labels.cols))];
    int owner = -1, most = 0;
    for (const auto& [object, count] : pixels) {
      const bool more = object >= 0 && count > most;
      if (more) owner = object, most = count;
    }
    owners.push_back(pixels[-1] > most ? -1 : owner);
  }
  return owners;
}

Segmentation segmentByOracle(const Frame& frame, const cv::Mat_<ushort>& true_labels, const Config& config) {
  const cv::Mat_<ushort> truth = labelsOfBlocks(true_labels, averagedPixels(frame, config.resolution));
  const Choose choose = [&](const PieceScene& scene) {
    const std::vector<int> owners = pieceOwners(scene.graph.pieces, truth);
    std::map<int, std::vector<int>> of_object;
    for (std::size_t k = 0; k < owners.size(); ++k) {
      if (owners[k] >= 0) of_object[owners[k]].push_back(static_cast<int>(k));
    }
    std::vector<std::vector<int>> groups;
    std::vector<double> overlaps;
    for (const auto& [object, pieces] : of_object) {
      groups.push_back(pieces);
      overlaps.push_back(overlapWith(object, pieces, scene.graph.pieces, truth));
    }
    std::vector<GroupHypothesis> described = describe(scene, groups, {}, config);
    for (std::size_t k = 0; k < described.size(); ++k) described[k].objectness = static_cast<float>(overlaps[k]);
    return described;
  };
  return segmentBy(choose, frame, config);
}

Segmentation segmentByClustering(const Frame& frame, const Config& config, const LearnedObjectness* model) {
  const Choose choose = [&](const PieceScene& scene) {
    const PieceGraph& graph = scene.graph;
    const LearnedObjectness* judge = judgeOf(config, model);
    const std::vector<Link> links = judgeLinks(graph, judge, config.runtime.threads);
    std::vector<WeightedEdge> edges;
    for (const Link& link : links) {
      const double factor = link.contact ? 1 : config.grouping.weight_gaps;
      edges.push_back({link.first, link.second, factor * logOdds(link.probability)});
    }
    std::vector<GroupHypothesis> clusters = describe(scene, contractEdges(graph.pieces.count(), edges), links, config);
    judgeObjects(config, judge, clusters);
    return clusters;
  };
  return segmentBy(choose, frame, config);
}

}  // namespace objectness::evaluation
