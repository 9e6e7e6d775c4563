// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/learning/learned_objectness.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "grouping/group_cues.hpp"
#include "io/file_access.hpp"
#include "learning/default_model.hpp"
#include "objectness_segmentation/learning/cue_list.hpp"

namespace objectness {
namespace {

constexpr std::size_t kMaxModelBytes = 16 << 20;

Status parsePart(const nlohmann::json& json, const char* name, const std::vector<std::string>& cues, Forest& forest) {
  if (!json.contains(name)) return Status::error(StatusCode::kBadInput, std::string("has no \"") + name + "\"");
  Result<Forest> part = parseForest(json.at(name), cues);
  if (!part.ok()) return Status::error(part.status.code, std::string("\"") + name + "\" " + part.status.message);
  forest = std::move(part.value);
  return {};
}

Forest unpacked(const EmbeddedForest& embedded, const std::vector<std::string>& cues) {
  Forest forest;
  forest.cues.assign(embedded.cues, embedded.cues + embedded.cue_count);
  if (forest.cues != cues) throw std::logic_error("the built-in model is made for other cues: learn it anew");
  const Forest::Node* next = embedded.nodes;
  for (std::size_t i = 0; i < embedded.tree_count; ++i) {
    forest.trees.emplace_back(next, next + embedded.tree_sizes[i]);
    next += embedded.tree_sizes[i];
  }
  return forest;
}

}  // namespace

const LearnedObjectness& defaultModel() {
  static const LearnedObjectness model{unpacked(kDefaultModel.contact, cueNames<ContactCues>()),
                                       unpacked(kDefaultModel.gap, cueNames<GapCues>()),
                                       unpacked(kDefaultModel.group, cueNames<GroupCues>()), kDefaultModel.trained_on};
  return model;
}

Result<LearnedObjectness> parseModel(const std::string& text) {
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  Result<LearnedObjectness> model;
  if (!json.is_object()) {
    return Result<LearnedObjectness>::error(StatusCode::kBadInput, "is not a model: not a JSON object");
  }
  const nlohmann::json trained_on = json.value("trained_on", nlohmann::json(""));
  if (!trained_on.is_string()) {
    return Result<LearnedObjectness>::error(StatusCode::kBadInput, "\"trained_on\" is no text");
  }
  model.value.trained_on = trained_on.get<std::string>();
  for (Status status : {parsePart(json, "contact", cueNames<ContactCues>(), model.value.contact),
                        parsePart(json, "gap", cueNames<GapCues>(), model.value.gap),
                        parsePart(json, "group", cueNames<GroupCues>(), model.value.group)}) {
    if (!status.ok()) return Result<LearnedObjectness>::error(status);
  }
  return model;
}

Result<LearnedObjectness> loadModel(const std::string& path) {
  const Result<std::string> text = readFile(path, kMaxModelBytes);
  if (!text.ok()) return Result<LearnedObjectness>::error(text.status);
  return parseModel(text.value);
}

std::string toJson(const LearnedObjectness& model) {
  const nlohmann::json json = {{"trained_on", model.trained_on},
                               {"contact", toJson(model.contact)},
                               {"gap", toJson(model.gap)},
                               {"group", toJson(model.group)}};
  return json.dump();
}

}  // namespace objectness
