// SPDX-License-Identifier: BSD-3-Clause
#include "sim/truth_file.hpp"

#include <yaml-cpp/yaml.h>

#include <filesystem>

#include "io/file_access.hpp"

namespace objectness::sim {
namespace {

namespace fs = std::filesystem;

constexpr int kDigits = 9;

YAML::Emitter& operator<<(YAML::Emitter& out, const Eigen::Vector3d& v) {
  return out << YAML::Flow << YAML::BeginSeq << v.x() << v.y() << v.z() << YAML::EndSeq;
}

YAML::Emitter& operator<<(YAML::Emitter& out, const Eigen::Isometry3d& pose) {
  Eigen::Quaterniond q(pose.linear());
  q.normalize();
  if (q.w() < 0) q.coeffs() *= -1;  // of the two that mean the same
  return out << YAML::BeginMap << YAML::Key << "position" << YAML::Value << Eigen::Vector3d(pose.translation())
             << YAML::Key << "orientation_xyzw" << YAML::Value << YAML::Flow << YAML::BeginSeq << q.x() << q.y()
             << q.z() << q.w() << YAML::EndSeq << YAML::EndMap;
}

void emit(const TrueObject& object, YAML::Emitter& out) {
  out << YAML::BeginMap << YAML::Key << "label" << YAML::Value << object.label << YAML::Key << "kind" << YAML::Value
      << object.kind;
  if (!object.hidden) {
    const cv::Rect& box = object.extent;
    out << YAML::Key << "box" << YAML::Value << YAML::Flow << YAML::BeginSeq << box.x << box.y << box.br().x
        << box.br().y << YAML::EndSeq << YAML::Key << "seed" << YAML::Value << YAML::Flow << YAML::BeginSeq
        << object.seed.x << object.seed.y << YAML::EndSeq;
  }
  out << YAML::Key << "visible" << YAML::Value << object.visible << YAML::Key << "size_m" << YAML::Value
      << object.box.size_m << YAML::Key << "T_camera_box" << YAML::Value << object.box.T_camera_box << YAML::EndMap;
}

void emitObjects(const SimulatedFrame& frame, bool hidden, YAML::Emitter& out) {
  out << YAML::BeginSeq;
  for (const TrueObject& object : frame.objects) {
    if (object.hidden == hidden) emit(object, out);
  }
  out << YAML::EndSeq;
}

/// What is no object; a table in an empty room has none of it.
void emitBackground(const SimulatedFrame& frame, YAML::Emitter& out) {
  if (frame.background.empty()) return;
  out << YAML::Key << "background" << YAML::Value << YAML::BeginSeq;
  for (const SceneBackground& background : frame.background) {
    out << YAML::Flow << YAML::BeginMap << YAML::Key << "label" << YAML::Value << background.label << YAML::Key
        << "kind" << YAML::Value << background.kind << YAML::EndMap;
  }
  out << YAML::EndSeq;
}

std::string truthText(const SimulatedFrame& frame) {
  YAML::Emitter out;
  out.SetDoublePrecision(kDigits);
  out << YAML::Comment(
             "Metres, camera's optical frame. box: [u0, v0, u1, v1] of the label, u1 and v1 just outside; seed:\n"
             "[u, v] within it; visible: share of its surface that nothing covers. What is hidden is void (0)\n"
             "in labels.png.")
      << YAML::BeginMap << YAML::Key << "level" << YAML::Value << frame.level;
  out << YAML::Key << "table" << YAML::Value << YAML::BeginMap << YAML::Key << "normal" << YAML::Value
      << frame.table_normal << YAML::Key << "distance_m" << YAML::Value << frame.table_distance_m << YAML::EndMap;
  emitBackground(frame, out);
  out << YAML::Key << "objects" << YAML::Value;
  emitObjects(frame, false, out);
  out << YAML::Key << "hidden" << YAML::Value;
  emitObjects(frame, true, out);
  out << YAML::EndMap;
  return std::string(out.c_str()) + "\n";
}

std::string poseText(const SimulatedFrame& frame) {
  YAML::Emitter out;
  out.SetDoublePrecision(kDigits);
  out << YAML::Comment("World: z up, origin on the table. Metres.") << YAML::BeginMap << YAML::Key << "T_world_camera"
      << YAML::Value << frame.T_world_camera << YAML::EndMap;
  return std::string(out.c_str()) + "\n";
}

}  // namespace

Status saveSimulatedFrame(const std::string& folder, const SimulatedFrame& frame) {
  const auto file = [&](const char* name) { return (fs::path(folder) / name).string(); };
  Status status = saveSceneFolder(folder, frame.images);
  if (status.ok()) status = writeFile(file("objects.yaml"), truthText(frame));
  if (status.ok()) status = writeFile(file("pose.yaml"), poseText(frame));
  return status;
}

}  // namespace objectness::sim
