// SPDX-License-Identifier: BSD-3-Clause
// Runs a fuzz target without libFuzzer, with any compiler: its kept corpus, then as many mutations of it, always the
// same ones. A crash, or a hang that ctest ends, is a failed test.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "fuzz_input.hpp"

namespace {

std::vector<std::string> readCorpus() {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(CORPUS_DIR)) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());  // the order of a folder is not fixed
  std::vector<std::string> corpus;
  for (const auto& path : paths) {
    std::ifstream file(path, std::ios::binary);
    corpus.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return corpus;
}

void run(const std::string& input) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

/// Changes bits, bytes and whole numbers, cuts, doubles, and splices in parts of another input.
std::string mutate(std::string input, const std::string& other, std::mt19937& random) {
  const auto below = [&random](std::size_t limit) { return limit == 0 ? 0 : random() % limit; };
  for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
    const std::size_t at = below(input.size()), length = below(std::min<std::size_t>(64, input.size() - at) + 1);
    static const std::uint32_t kNumbers[] = {0, 1, 0x7F, 0xFF, 0xFFFF, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF, 0x7FC00000};
    const std::uint32_t number = kNumbers[below(std::size(kNumbers))];
    switch (below(7)) {
      case 0:
        if (!input.empty()) input[at] = static_cast<char>(input[at] ^ 1 << below(8));
        break;
      case 1:
        if (!input.empty()) input[at] = static_cast<char>(random());
        break;
      case 2:
        if (at + 4 <= input.size()) std::memcpy(&input[at], &number, 4);
        break;
      case 3:
        input.erase(at, length);
        break;
      case 4:
        input.insert(at, input.substr(at, length));
        break;
      case 5:
        input.insert(at, other.substr(below(other.size()), below(64)));
        break;
      default:
        input.insert(at, 1, static_cast<char>(random()));
    }
  }
  return input;
}

TEST(Fuzz, KeptCorpus) {
  const std::vector<std::string> corpus = readCorpus();
  ASSERT_FALSE(corpus.empty()) << CORPUS_DIR;
  run("");
  for (const std::string& input : corpus) run(input);
}

TEST(Fuzz, Mutations) {
  const std::vector<std::string> corpus = readCorpus();
  ASSERT_FALSE(corpus.empty()) << CORPUS_DIR;
  std::mt19937 random(1);
  for (int i = 0; i < MUTATIONS; ++i) {
    run(mutate(corpus[random() % corpus.size()], corpus[random() % corpus.size()], random));
  }
}

}  // namespace
