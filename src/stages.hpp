// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>

#include "objectness_segmentation/result.hpp"

namespace objectness {

/// Thrown between stages only.
struct Cancelled {};

/// The stages of a frame: timed, and not begun once cancelled.
class Stages {
 public:
  /// cancel: nullptr for never. `report` must outlive the stages.
  Stages(const std::atomic<bool>* cancel, Report& report) : cancel_(cancel), report_(report) {}

  template <class Work>
  auto operator()(const char* name, Work&& work) const {
    if (cancel_ && *cancel_) throw Cancelled();
    const StageTimer timer(report_.timings_ms, name);
    return work();
  }
  Report& report() const { return report_; }
  const std::atomic<bool>* cancelFlag() const { return cancel_; }

 private:
  const std::atomic<bool>* cancel_;
  Report& report_;
};

}  // namespace objectness
