// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <vector>

#include "objectness_segmentation/common/range.hpp"
#include "objectness_segmentation/scene/frame.hpp"
#include "objectness_segmentation/segments/segment.hpp"

namespace objectness {

struct TrackingConfig {
  bool enabled = true;
  double max_move_m = 0.15;
  double min_overlap = 0.5;
  double min_similarity = 0.6;
  int max_missed_frames = 5;
  double max_missed_s = 2.0;
  int settle_frames = 15;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("enabled", self.enabled,
          "nodelet: labels keep to the same object from frame to frame; off: labels by rank, the best first");
    visit("max_move_m", self.max_move_m, Range{0, 2},
          "an object that moved farther between two frames it was seen in is a new one");
    visit("min_overlap", self.min_overlap, Range{0.05, 1},
          "one object in two frames when it shares this much of its surface with itself, else only by size and place");
    visit("min_similarity", self.min_similarity, Range{0, 1},
          "least similarity in size (1: the same box) of an object that moved");
    visit("max_missed_frames", self.max_missed_frames, Range{0, 10000},
          "an object that was missed is remembered for this many frames");
    visit("max_missed_s", self.max_missed_s, Range{0, 3600}, "and for this time");
    visit("settle_frames", self.settle_frames, Range{1, 100},
          "the box of an object that does not move is the median of so many frames; 1: of each frame its own");
  }
};

/// Stamps that go back by less are no jump in time.
constexpr double kTimeJump_s = 1;

/// Which object a segment is. Without tracking only `label` is set.
struct Identity {
  int label = 0;          ///< kFirstObjectLabel or above; keeps to the object, used again after it was forgotten
  std::uint64_t id = 0;   ///< from 1, never used again; 0: not tracked
  int age_frames = 0;     ///< frames it was seen in, this one included
  double age_s = 0;       ///< since it was first seen
  double confidence = 0;  ///< 0 to 1: how well it agreed with itself lately; 0.3 when seen for the first time
};

struct PosedDepthImage;

/// The labels of untracked segments: by rank.
std::vector<Identity> identitiesByRank(std::size_t count);

/// Keeps identities from frame to frame: segments and objects seen before are paired one to one so that the sum of
/// their agreement is the largest there is. They agree by the surface they share in a fixed frame, or, for what moved,
/// by size and place. TableClusters of one size that change places between two frames keep the identity of the place:
/// nothing in their shapes tells them apart. Not thread safe; deterministic.
class Tracker {
 public:
  Tracker();
  ~Tracker();

  /// Identities of the segments of one frame, in their order. T_fixed_camera: the camera in a frame in which the table
  /// stands still; the identity when the camera does. time_s: the frame's stamp; a second or more before the last
  /// clears first.
  std::vector<Identity> update(const Frame& frame, const std::vector<Segment>& segments,
                               const Eigen::Isometry3d& T_fixed_camera, double time_s, const TrackingConfig& config);

  /// Forgets all objects. Ids go on.
  void clear();

 private:
  struct Track;
  int freeLabel() const;

  std::vector<std::unique_ptr<Track>> tracks_;
  std::unique_ptr<PosedDepthImage> last_view_;
  std::uint64_t last_id_ = 0;
  double last_time_s_ = 0;
  int frames_ = 0;
};

}  // namespace objectness
