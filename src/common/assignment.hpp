// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

namespace objectness {

/// Pairs rows and columns one to one so that the sum of their gains is the largest there is (the Hungarian problem),
/// min(rows, columns) pairs, by row. Shortest augmenting paths with duals (Jonker and Volgenant 1987, in the
/// rectangular form of Crouse 2016), O(n^3). Of several best assignments the one SciPy's linear_sum_assignment returns,
/// because the pairs without any gain decide about the boundary measure.
std::vector<std::pair<int, int>> assignMaximum(const Eigen::MatrixXd& gains);

}  // namespace objectness
