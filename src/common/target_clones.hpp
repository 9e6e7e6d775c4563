// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// For the hot kernels: the function is compiled for newer processors, too, and chosen at run time. Never -mavx2 for a
// whole file with Eigen or PCL in it: built for another alignment than Debian's libraries, it crashes inside a nodelet
// manager. A file that uses this has plain types at its border and includes neither.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(OBJECTNESS_PORTABLE)
#define OBJECTNESS_CLONES(target) __attribute__((target_clones(target, "default")))
#else
#define OBJECTNESS_CLONES(target)
#endif
