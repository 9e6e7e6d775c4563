// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/tracking/tracker.hpp"

#include <algorithm>

#include "common/assignment.hpp"
#include "tracking/observation.hpp"

namespace objectness {
namespace {

constexpr int kSurfaceMemoryFrames = 10;  // surface not seen for longer may have moved
constexpr double kFirstConfidence = 0.3;
constexpr double kConfidenceKept = 0.7;  // of the confidence before, a frame

}  // namespace

struct Tracker::Track {
  Identity identity;
  Observation last;
  double first_time_s = 0, last_time_s = 0;
  int missed = 0;  ///< frames since it was last seen
};

Tracker::Tracker() = default;
Tracker::~Tracker() = default;

void Tracker::clear() {
  tracks_.clear();
  last_view_.reset();
}

std::vector<Identity> identitiesByRank(std::size_t count) {
  std::vector<Identity> identities(count);
  for (std::size_t rank = 0; rank < count; ++rank) {
    identities[rank].label = kFirstObjectLabel + static_cast<int>(rank);
  }
  return identities;
}

int Tracker::freeLabel() const {
  int label = kFirstObjectLabel;
  const auto taken = [&](const auto& track) { return track->identity.label == label; };
  while (std::any_of(tracks_.begin(), tracks_.end(), taken)) ++label;
  return label;
}

std::vector<Identity> Tracker::update(const Frame& frame, const std::vector<Segment>& segments,
                                      const Eigen::Isometry3d& T_fixed_camera, double time_s,
                                      const TrackingConfig& config) {
  if (time_s < last_time_s_ - kTimeJump_s) clear();
  last_time_s_ = time_s;
  ++frames_;

  std::vector<Observation> observations;
  for (const Segment& segment : segments)
    observations.push_back(makeObservation(frame, segment, T_fixed_camera, frames_));
  auto view = std::make_unique<PosedDepthImage>(frame, T_fixed_camera);
  std::vector<bool> arrived;
  for (const Observation& observation : observations)
    arrived.push_back(last_view_ && isElsewhere(observation, *last_view_));
  Eigen::MatrixXd gains(tracks_.size(), observations.size());
  std::vector<Agreement> agreements(tracks_.size() * observations.size());
  for (std::size_t t = 0; t < tracks_.size(); ++t) {
    const bool left = isElsewhere(tracks_[t]->last, *view);
    for (std::size_t s = 0; s < observations.size(); ++s) {
      const Agreement agreement = agree(tracks_[t]->last, observations[s], !left && !arrived[s], config);
      agreements[t * observations.size() + s] = agreement;
      gains(static_cast<Eigen::Index>(t), static_cast<Eigen::Index>(s)) = agreement.gain;
    }
  }

  std::vector<Track*> owner(segments.size(), nullptr);
  for (const auto& track : tracks_) ++track->missed;
  for (const auto& [t, s] : assignMaximum(gains)) {
    const Agreement& agreement = agreements[t * observations.size() + s];
    if (agreement.gain <= 0) continue;
    Track& track = *tracks_[t];
    owner[s] = &track;
    track.missed = 0;
    track.last_time_s = time_s;
    Identity& identity = track.identity;
    ++identity.age_frames;
    identity.age_s = time_s - track.first_time_s;
    identity.confidence = kConfidenceKept * identity.confidence + (1 - kConfidenceKept) * agreement.quality;
    Observation& now = observations[s];
    if (!agreement.moved) {
      SurfaceCells surface = std::move(track.last.surface);
      surface.merge(now.surface, frames_ - kSurfaceMemoryFrames);
      now.surface = std::move(surface);
    }
    track.last = std::move(now);
  }

  const auto forgotten = [&](const std::unique_ptr<Track>& track) {
    return track->missed > config.max_missed_frames && time_s - track->last_time_s > config.max_missed_s;
  };
  for (const auto& track : tracks_) {
    if (track->missed > 0) track->identity.confidence *= kConfidenceKept;
  }
  tracks_.erase(std::remove_if(tracks_.begin(), tracks_.end(), forgotten), tracks_.end());

  std::vector<Identity> identities;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    if (!owner[s]) {
      auto track = std::make_unique<Track>();
      track->identity = {freeLabel(), ++last_id_, 1, 0, kFirstConfidence};
      track->last = std::move(observations[s]);
      track->first_time_s = track->last_time_s = time_s;
      tracks_.push_back(std::move(track));
      owner[s] = tracks_.back().get();
    }
    identities.push_back(owner[s]->identity);
  }
  last_view_ = std::move(view);
  return identities;
}

}  // namespace objectness
