// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/table_text.hpp"

#include <algorithm>
#include <cstdio>

namespace objectness::evaluation {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 ? values[half] : (values[half - 1] + values[half]) / 2;
}

std::string fixedText(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string csvCell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

void writeCell(std::ostream& out, const std::string& text, std::size_t width, bool left) {
  const std::string space(text.size() < width ? width - text.size() : 0, ' ');
  out << (left ? text + space : space + text) << ' ';
}

void MeanScores::add(const Scores& scores) {
  std::size_t k = 0;
  Scores::fields(scores, [&](const char*, double value) {
    if (k == sums_.size()) sums_.push_back(0);
    sums_[k++] += value;
  });
  ++count_;
}

Scores MeanScores::mean() const {
  Scores mean;
  auto sum = sums_.begin();
  Scores::fields(mean, [&](const char*, double& value) { value = *sum++ / count_; });
  return mean;
}

}  // namespace objectness::evaluation
