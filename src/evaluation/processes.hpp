// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

namespace objectness::evaluation {

/// Calls work(i) for i = 0..count-1, each in a forked process of its own, up to `jobs` at a time, and done(i, failure)
/// in this one as each ends: failure is empty, or says how the process died ("was killed by signal 11 (Segmentation
/// fault)"). So the memory of each is its own, and one that crashes takes no other along. What work() finds it leaves
/// in files. A process does not outlive this one. Call it from a program of one thread.
void forEachInProcess(int count, int jobs, const std::function<void(int)>& work,
                      const std::function<void(int, const std::string&)>& done);

}  // namespace objectness::evaluation
