// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "evaluation/box_overlap.hpp"
#include "evaluation/true_boxes.hpp"
#include "fixtures/cue_view.hpp"
#include "fixtures/temporary_folder.hpp"

using namespace objectness;
using namespace objectness::evaluation;
using namespace objectness_test;
using Eigen::Vector3d;

namespace {

/// Surface k is the object 10 * (k + 1).
cv::Mat_<ushort> labelsOf(const CueView& view) {
  cv::Mat_<ushort> labels(view.frame.height(), view.frame.width(), static_cast<ushort>(0));
  for (int i = 0; i < view.frame.size(); ++i) {
    const int surface = view.scene.seen[i];
    labels(i) = static_cast<ushort>(surface < 0 ? 0 : surface == 0 ? 1 : 10 * (surface + 1));
  }
  return labels;
}

CueView twoBoxes() {
  return CueView(sceneOf({kTable, box({-0.2, 0, 0}, {-0.05, 0.1, 0.12}), box({0.1, 0, 0}, {0.2, 0.2, 0.06})}));
}

OrientedBox boxOf(const CueView& view, const Vector3d& low, const Vector3d& high) {
  OrientedBox box;
  box.T_camera_box = view.scene.T_world_camera.inverse() * Eigen::Translation3d((low + high) / 2);
  box.size_m = high - low;
  return box;
}

constexpr const char* kObjects =
    "level: 3\n"
    "objects:\n"
    "  - {label: 20, size_m: [0.1, 0.2, 0.3], T_camera_box: {position: [1, 2, 3], orientation_xyzw: [0, 0, 1, 0]}}\n"
    "  - {label: 30, size_m: [0.1, 0.1, 0.1], T_camera_box: {position: [0, 0, 1], orientation_xyzw: [0, 0, 0, 1]}}\n"
    "hidden: []\n";

}  // namespace

TEST(TrueBoxes, FittedBoxesAreThoseOfTheModel) {
  const CueView view = twoBoxes();
  const std::vector<TrueBox> boxes = fitTrueBoxes(view.frame, view.table, labelsOf(view));
  ASSERT_EQ(boxes.size(), 2u);
  EXPECT_EQ(boxes[0].object, 0);
  EXPECT_EQ(boxes[1].object, 1);
  EXPECT_GT(boxOverlap(boxes[0].box, boxOf(view, {-0.2, 0, 0}, {-0.05, 0.1, 0.12})), 0.93);
  EXPECT_GT(boxOverlap(boxes[1].box, boxOf(view, {0.1, 0, 0}, {0.2, 0.2, 0.06})), 0.93);
}

TEST(TrueBoxes, PartsAreOneObjectAndStrayPixelsAreLeftOut) {
  CueView view = twoBoxes();
  cv::Mat_<ushort> labels = labelsOf(view);
  const OrientedBox before = fitTrueBoxes(view.frame, view.table, labels)[0].box;
  const Eigen::Vector2i top = view.pixelOf({-0.12, 0.05, 0.12});
  cv::Mat_<ushort>(labels(cv::Rect(top.x() - 5, top.y() - 5, 10, 10))).setTo(21);
  labels(5, 5) = 20;
  view.frame.points[top.y() * 640 + top.x() + 20] *= 0.5f;  // a pixel half way to the camera
  const std::vector<TrueBox> boxes = fitTrueBoxes(view.frame, view.table, labels);
  ASSERT_EQ(boxes.size(), 2u);
  EXPECT_GT(boxOverlap(boxes[0].box, before), 0.999);
}

TEST(TrueBoxes, AreReadFromTheSceneFolder) {
  const TemporaryFolder folder;
  writeBytes(folder / "objects.yaml", kObjects);
  const auto boxes = loadTrueBoxes(folder.path());
  ASSERT_TRUE(boxes.ok()) << boxes.status.message;
  ASSERT_EQ(boxes.value.size(), 2u);
  EXPECT_EQ(boxes.value[0].object, 0);
  EXPECT_EQ(boxes.value[0].box.size_m, Vector3d(0.1, 0.2, 0.3));
  EXPECT_TRUE((boxes.value[0].box.T_camera_box * Vector3d(1, 0, 0)).isApprox(Vector3d(0, 2, 3))) << "half a turn";
}

TEST(TrueBoxes, OfTheFileComeFirstAndHiddenObjectsDoNotCount) {
  const CueView view = twoBoxes();
  cv::Mat_<ushort> labels = labelsOf(view);
  const TemporaryFolder folder;
  EXPECT_EQ(findTrueBoxes(folder.path(), view.frame, view.table, labels).value.size(), 2u) << "no file: fitted";
  writeBytes(folder / "objects.yaml", "objects:\n- {name: mug, seed: [3, 4], box: [1, 2, 5, 6]}\n");
  EXPECT_EQ(findTrueBoxes(folder.path(), view.frame, view.table, labels).value.size(), 2u) << "no sizes: fitted";
  writeBytes(folder / "objects.yaml", kObjects);
  EXPECT_EQ(findTrueBoxes(folder.path(), view.frame, view.table, labels).value[0].box.size_m, Vector3d(0.1, 0.2, 0.3));
  labels.setTo(0, labels == 30);
  EXPECT_EQ(findTrueBoxes(folder.path(), view.frame, view.table, labels).value.size(), 1u);
}

TEST(TrueBoxes, AFileThatCannotBeReadIsNamed) {
  const TemporaryFolder folder;
  for (const char* content : {"objects: [{label: 20, size_m: [1, 2]", "objects:\n- {label: 20, size_m: [1, 2]}\n",
                              "objects:\n- {label: 20, size_m: [1, 2, 3]}\n",
                              "objects:\n- {label: twenty, size_m: [1, 2, 3], T_camera_box: {position: [0, 0, 0], "
                              "orientation_xyzw: [0, 0, 0, 1]}}\n",
                              "objects:\n- {label: 20, size_m: [1, 2, 3], T_camera_box: {position: [0, 0, 0], "
                              "orientation_xyzw: [0, 0, 0, 2]}}\n",
                              "objects:\n- {label: 20, size_m: [1, 2, -3], T_camera_box: {position: [0, 0, 0], "
                              "orientation_xyzw: [0, 0, 0, 1]}}\n"}) {
    writeBytes(folder / "objects.yaml", content);
    const auto boxes = loadTrueBoxes(folder.path());
    EXPECT_EQ(boxes.status.code, StatusCode::kBadInput) << content;
    EXPECT_NE(boxes.status.message.find(folder / "objects.yaml"), std::string::npos) << boxes.status.message;
  }
}
