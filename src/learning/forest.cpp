// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/learning/forest.hpp"

#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

namespace objectness {
namespace {

Result<Forest> bad(const std::string& why) { return Result<Forest>::error(StatusCode::kBadInput, why); }

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

Forest::Node parseNode(const nlohmann::json& json) {
  Forest::Node node;
  if (json.size() == 1) {
    node.value = json.at(0).get<float>();
  } else {
    node.cue = json.at(0).get<int>();
    node.threshold = json.at(1).get<float>();
    node.left = json.at(2).get<int>();
    node.right = json.at(3).get<int>();
  }
  return node;
}

/// To five digits, as a number that is written with no more.
double rounded(float value) {
  std::ostringstream text;
  text << std::setprecision(5) << value;
  return std::stod(text.str());
}

/// Children come after their parents: no walk is endless, none leaves the tree.
bool sound(const nlohmann::json& nodes, const std::vector<Forest::Node>& tree, int cues) {
  const int size = static_cast<int>(tree.size());
  for (int i = 0; i < size; ++i) {
    const Forest::Node& node = tree[i];
    if (nodes[i].size() == 1) continue;  // a leaf
    if (node.cue < 0 || node.cue >= cues || node.left <= i || node.right <= i || node.left >= size ||
        node.right >= size)
      return false;
  }
  return size > 0;
}

}  // namespace

float Forest::predict(const std::vector<float>& values) const {
  if (trees.empty()) return 0;
  float sum = 0;
  for (const std::vector<Node>& tree : trees) {
    const Node* node = tree.data();
    while (node->cue >= 0) node = &tree[values[node->cue] <= node->threshold ? node->left : node->right];
    sum += node->value;
  }
  return sum / static_cast<float>(trees.size());
}

nlohmann::json toJson(const Forest& forest) {
  nlohmann::json trees = nlohmann::json::array();
  for (const auto& tree : forest.trees) {
    nlohmann::json nodes = nlohmann::json::array();
    for (const Forest::Node& node : tree) {
      nodes.push_back(node.cue < 0 ? nlohmann::json{rounded(node.value)}
                                   : nlohmann::json{node.cue, rounded(node.threshold), node.left, node.right});
    }
    trees.push_back(std::move(nodes));
  }
  return {{"cues", forest.cues}, {"trees", std::move(trees)}};
}

Result<Forest> parseForest(const nlohmann::json& json, const std::vector<std::string>& cues) {
  try {
    Result<Forest> result;
    result.value.cues = json.at("cues").get<std::vector<std::string>>();
    if (result.value.cues != cues) {
      return bad("is made for the cues " + listed(result.value.cues) + ", this version has " + listed(cues) +
                 ": learn it anew with learn_objectness");
    }
    for (const nlohmann::json& nodes : json.at("trees")) {
      std::vector<Forest::Node> tree;
      for (const nlohmann::json& node : nodes) tree.push_back(parseNode(node));
      if (!sound(nodes, tree, static_cast<int>(cues.size()))) {
        return bad("tree " + std::to_string(result.value.trees.size()) + " refers to nodes or cues that do not exist");
      }
      result.value.trees.push_back(std::move(tree));
    }
    if (result.value.trees.empty()) return bad("has no tree");
    return result;
  } catch (const nlohmann::json::exception& e) {
    return bad(std::string("is no forest: ") + e.what());
  }
}

}  // namespace objectness
