// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/scene/table.hpp"

namespace objectness {

/// Median angle between the normals of the bare table and the table's own, degrees: what normals are worth in this
/// frame. 0 when too little of the table is seen.
double tableNormalError(const Frame& frame, const Normals& normals, const Table& table, int threads = 1);

/// Computes the normals again with the table's measured noise and a window that is wider by the factor by which their
/// error exceeds config.max_error_deg: the error of a fitted normal falls about as its window grows, and cameras differ
/// tenfold in noise. Returns the given normals if they are good enough.
Normals refineNormals(const Frame& frame, Normals normals, const Table& table, const NormalsConfig& config,
                      int threads = 1);

}  // namespace objectness
