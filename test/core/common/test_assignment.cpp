// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include "common/assignment.hpp"

using objectness::assignMaximum;

namespace {

/// The largest sum over all ways to give each row of a wide matrix a column of its own.
double largestSum(const Eigen::MatrixXd& gains) {
  if (gains.rows() > gains.cols()) return largestSum(gains.transpose());
  std::vector<int> columns(static_cast<std::size_t>(gains.cols()));
  std::iota(columns.begin(), columns.end(), 0);
  double best = -1e300;
  do {
    double sum = 0;
    for (int row = 0; row < gains.rows(); ++row) sum += gains(row, columns[static_cast<std::size_t>(row)]);
    best = std::max(best, sum);
  } while (std::next_permutation(columns.begin(), columns.end()));
  return best;
}

}  // namespace

TEST(Assignment, HasTheLargestSumOfAllPermutations) {
  std::mt19937 random(1);
  for (int round = 0; round < 300; ++round) {
    const int rows = 1 + static_cast<int>(random() % 7), columns = 1 + static_cast<int>(random() % 7);
    // Few values make ties, zeros are what pairs that share nothing have.
    const unsigned values = round % 2 ? 4 : 1000000;
    Eigen::MatrixXd gains(rows, columns);
    for (Eigen::Index i = 0; i < gains.size(); ++i) gains(i) = random() % values / static_cast<double>(values);
    const auto pairs = assignMaximum(gains);
    ASSERT_EQ(pairs.size(), static_cast<std::size_t>(std::min(rows, columns)));
    std::set<int> used_rows, used_columns;
    double sum = 0;
    for (const auto& [row, column] : pairs) {
      EXPECT_TRUE(used_rows.insert(row).second && used_columns.insert(column).second);
      sum += gains(row, column);
    }
    EXPECT_NEAR(sum, largestSum(gains), 1e-12) << gains;
    EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end()));
  }
}

TEST(Assignment, EqualGainsGiveTheIdentity) {
  const std::vector<std::pair<int, int>> identity{{0, 0}, {1, 1}, {2, 2}};
  EXPECT_EQ(assignMaximum(Eigen::MatrixXd::Zero(3, 5)), identity);
  EXPECT_EQ(assignMaximum(Eigen::MatrixXd::Constant(5, 3, 0.5)), identity);
}

TEST(Assignment, OfNothingIsNothing) {
  EXPECT_TRUE(assignMaximum(Eigen::MatrixXd(0, 3)).empty());
  EXPECT_TRUE(assignMaximum(Eigen::MatrixXd(3, 0)).empty());
}
