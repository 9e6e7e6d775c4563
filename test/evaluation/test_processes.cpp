// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <map>
#include <stdexcept>

#include "evaluation/processes.hpp"
#include "fixtures/temporary_folder.hpp"

using namespace objectness_test;
using objectness::evaluation::forEachInProcess;

TEST(Processes, EachDoesItsWorkAndNoneTakesAnotherAlong) {
  const TemporaryFolder folder;
  std::map<int, std::string> failures;
  forEachInProcess(
      6, 3,
      [&](int i) {
        if (i == 1) raise(SIGKILL);
        if (i == 2) raise(SIGSEGV);
        if (i == 3) throw std::runtime_error("no");
        if (i == 4) _exit(7);
        writeBytes(folder / std::to_string(i), std::to_string(getpid()));
      },
      [&](int i, const std::string& failure) { EXPECT_TRUE(failures.emplace(i, failure).second); });
  ASSERT_EQ(failures.size(), 6u);
  for (const int i : {0, 5}) {
    EXPECT_EQ(failures[i], "");
    EXPECT_NE(readBytes(folder / std::to_string(i)), std::to_string(getpid()));
  }
  EXPECT_NE(failures[1].find("signal 9"), std::string::npos) << failures[1];
  EXPECT_NE(failures[1].find("out of memory?"), std::string::npos) << failures[1];
  EXPECT_NE(failures[2].find("signal 11"), std::string::npos) << failures[2];
  EXPECT_EQ(failures[3], "threw an exception");
  EXPECT_NE(failures[4].find("exit status 7"), std::string::npos) << failures[4];
}

TEST(Processes, NoneIsAskedFor) {
  forEachInProcess(
      0, 2, [](int) {}, [](int, const std::string&) { FAIL(); });
}
