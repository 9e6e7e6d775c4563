// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "evaluation/scores.hpp"

namespace objectness::evaluation {

/// Of at least one value; the mean of the middle two of an even number.
double median(std::vector<double> values);

std::string fixedText(double value, int digits);

/// Names of scenes and groups may hold anything: quoted where needed.
std::string csvCell(const std::string& text);

/// A cell of a table on a terminal: at least `width` wide, and a blank.
void writeCell(std::ostream& out, const std::string& text, std::size_t width, bool left);

/// Means of scores, column by column.
class MeanScores {
 public:
  void add(const Scores& scores);
  int count() const { return count_; }
  Scores mean() const;  ///< of at least one

 private:
  std::vector<double> sums_;
  int count_ = 0;
};

}  // namespace objectness::evaluation
