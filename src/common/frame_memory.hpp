// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace objectness {

/// For programs that segment frames, before the first one: memory that a frame frees stays with the process for the
/// next, and in the main thread comes from the system in large pages where it has them. Thousands of small pages,
/// fetched again for each frame, would otherwise take milliseconds. It is a setting of the whole process and takes no
/// memory by itself; a thread that segments, and is not the main one, calls it itself. Nothing where the C library is
/// not glibc.
void keepFrameMemory();

/// Returns what is kept and not in use to the system, of all threads: when no more frames are to come. The next thread
/// that segments would not find it again.
void returnFrameMemory();

}  // namespace objectness
