// SPDX-License-Identifier: BSD-3-Clause
#include "common/assignment.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace objectness {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kFree = -1;

/// An assignment in the making; rows <= columns.
struct Matching {
  const Eigen::MatrixXd& costs;
  std::vector<double> row_dual, column_dual;
  std::vector<int> column_of_row, row_of_column;

  explicit Matching(const Eigen::MatrixXd& all_costs)
      : costs(all_costs),
        row_dual(costs.rows(), 0),
        column_dual(costs.cols(), 0),
        column_of_row(costs.rows(), kFree),
        row_of_column(costs.cols(), kFree) {}

  /// Gives `start` a column; the rows along the shortest path to a free column move on to their next ones.
  void addRow(int start) {
    std::vector<double> distance(costs.cols(), kInfinity);
    std::vector<int> came_from(costs.cols(), kFree), open(costs.cols()), seen_rows, seen_columns;
    std::iota(open.rbegin(), open.rend(), 0);  // from the last: equal costs everywhere give the identity
    double length = 0;
    int row = start, sink = kFree;
    while (sink == kFree) {
      seen_rows.push_back(row);
      std::size_t nearest = 0;
      double least = kInfinity;
      for (std::size_t k = 0; k < open.size(); ++k) {
        const int column = open[k];
        const double through_row = length + costs(row, column) - row_dual[row] - column_dual[column];
        if (through_row < distance[column]) {
          distance[column] = through_row;
          came_from[column] = row;
        }
        // Of equally near columns a free one, which ends the search.
        if (distance[column] < least || (distance[column] == least && row_of_column[column] == kFree)) {
          least = distance[column];
          nearest = k;
        }
      }
      length = least;
      const int column = open[nearest];
      open[nearest] = open.back();
      open.pop_back();
      seen_columns.push_back(column);
      if (row_of_column[column] == kFree) {
        sink = column;
      } else {
        row = row_of_column[column];
      }
    }
    row_dual[start] += length;
    for (const int seen : seen_rows) {
      if (seen != start) row_dual[seen] += length - distance[column_of_row[seen]];
    }
    for (const int seen : seen_columns) column_dual[seen] -= length - distance[seen];
    for (int column = sink, mover = kFree; mover != start;) {
      mover = came_from[column];
      row_of_column[column] = mover;
      std::swap(column_of_row[mover], column);
    }
  }
};

}  // namespace

std::vector<std::pair<int, int>> assignMaximum(const Eigen::MatrixXd& gains) {
  const bool tall = gains.rows() > gains.cols();
  const Eigen::MatrixXd costs = tall ? Eigen::MatrixXd(-gains.transpose()) : Eigen::MatrixXd(-gains);
  Matching matching(costs);
  for (int row = 0; row < costs.rows(); ++row) matching.addRow(row);
  std::vector<std::pair<int, int>> pairs;
  for (int row = 0; row < costs.rows(); ++row) {
    const int column = matching.column_of_row[row];
    pairs.emplace_back(tall ? column : row, tall ? row : column);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace objectness
