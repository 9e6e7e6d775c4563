// SPDX-License-Identifier: BSD-3-Clause
#include "finished_segments.hpp"

#include "objectness_segmentation/segments/unmeasured.hpp"
#include "segments/background.hpp"
#include "segments/whole_boxes.hpp"

namespace objectness {

void finishSegments(const Frame& frame, const Config& config, const Stages& stage, Segmentation& result) {
  if (config.background.judged) {
    const auto background =
        stage("background", [&] { return takeBackground(frame, result.table, result.object_points, result.segments); });
    stage.report().background = background.size();
  }
  keepMeasured(frame.bridged, result.segments);
  result.labels = labelImage(result.object_points.on_table, frame.bridged, result.segments);
  stage("whole_boxes", [&] {
    completeBoxes(frame, result.normals, result.table, result.object_points, result.labels, result.segments,
                  config.runtime.threads);
  });
  if (config.unmeasured.report) {
    result.unmeasured = stage("unmeasured", [&] {
      return findUnmeasured(frame, result.table, result.object_points, result.labels, result.segments,
                            config.unmeasured);
    });
    stage.report().unmeasured = result.unmeasured.size();
  }
  stage.report().segments = result.segments.size();
}

}  // namespace objectness
