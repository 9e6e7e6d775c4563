// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <string>

namespace objectness_segmentation {

/// Calls work() from a callback of ROS, whose threads would take the whole process with them: what it throws ends this
/// call only, and tell(what) is called.
template <class Work, class Tell>
void guarded(Work&& work, Tell&& tell) noexcept {
  const auto say = [&](const char* what) {
    try {
      tell(std::string(what));
    } catch (...) {  // nobody is left to tell
    }
  };
  try {
    work();
  } catch (const std::exception& e) {
    say(e.what());
  } catch (...) {
    say("an exception that is no std::exception");
  }
}

}  // namespace objectness_segmentation
