// SPDX-License-Identifier: BSD-3-Clause
#include "learning/forest_trainer.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/ml.hpp>

namespace objectness {
namespace {

/// Copies the part of OpenCV's tree below `from`; returns its index in `tree`.
int copyNode(const cv::ml::RTrees& model, int from, std::vector<Forest::Node>& tree) {
  const cv::ml::DTrees::Node& node = model.getNodes()[from];
  const int index = static_cast<int>(tree.size());
  tree.emplace_back();
  if (node.split < 0 || node.left < 0) {
    tree[index].value = static_cast<float>(node.value);
    return index;
  }
  const cv::ml::DTrees::Split& split = model.getSplits()[node.split];
  const int left = copyNode(model, node.left, tree), right = copyNode(model, node.right, tree);
  tree[index].cue = split.varIdx;
  tree[index].threshold = split.c;
  tree[index].left = split.inversed ? right : left;
  tree[index].right = split.inversed ? left : right;
  return index;
}

}  // namespace

void Samples::add(const std::vector<float>& row, float target) {
  values.insert(values.end(), row.begin(), row.end());
  targets.push_back(target);
}

Forest trainForest(const Samples& samples, const ForestSettings& settings) {
  const int rows = static_cast<int>(samples.size()), columns = static_cast<int>(samples.cues.size());
  const cv::Mat values(rows, columns, CV_32F, const_cast<float*>(samples.values.data()));
  const cv::Mat targets(rows, 1, CV_32F, const_cast<float*>(samples.targets.data()));
  cv::theRNG().state = settings.seed;
  cv::Ptr<cv::ml::RTrees> model = cv::ml::RTrees::create();
  model->setMaxDepth(settings.depth);
  model->setMinSampleCount(settings.min_samples);
  model->setRegressionAccuracy(1e-4f);
  model->setActiveVarCount(std::max(1, static_cast<int>(std::lround(settings.cue_share * columns))));
  model->setTermCriteria({cv::TermCriteria::MAX_ITER, settings.trees, 0});
  model->train(cv::ml::TrainData::create(values, cv::ml::ROW_SAMPLE, targets));
  Forest forest{samples.cues, {}};
  for (const int root : model->getRoots()) {
    forest.trees.emplace_back();
    copyNode(*model, root, forest.trees.back());
  }
  return forest;
}

}  // namespace objectness
