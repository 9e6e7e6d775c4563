// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "objectness_segmentation/ros/latest_only_worker.hpp"

namespace {

using objectness_segmentation::LatestOnlyWorker;
using namespace std::chrono_literals;

void noException(const std::string& what) { ADD_FAILURE() << what; }

/// Lets a job block until the test opens it.
struct Gate {
  std::promise<void> entered, opened;
  std::shared_future<void> open = opened.get_future().share();
};

TEST(LatestOnlyWorker, WorksOnTheNewestAndCountsTheReplaced) {
  Gate gate;
  std::vector<int> done;
  std::promise<void> last;
  LatestOnlyWorker<int> worker(
      [&](int job) {
        if (job == 0) {
          gate.entered.set_value();
          gate.open.wait();
        }
        done.push_back(job);
        if (job == 100) last.set_value();
      },
      noException);
  worker.submit(0);
  gate.entered.get_future().wait();
  for (int job = 1; job <= 100; ++job) worker.submit(job);
  EXPECT_EQ(worker.dropped(), 99u);
  gate.opened.set_value();
  ASSERT_EQ(last.get_future().wait_for(10s), std::future_status::ready);
  worker.stop();
  EXPECT_EQ(done, (std::vector<int>{0, 100}));
  EXPECT_EQ(worker.dropped(), 99u);
}

TEST(LatestOnlyWorker, LosesNothingWhenItKeepsUp) {
  std::promise<int> result;
  LatestOnlyWorker<int> worker([&](int job) { result.set_value(job); }, noException);
  for (int job = 0; job < 50; ++job) {
    result = std::promise<int>();
    auto future = result.get_future();
    worker.submit(job);
    ASSERT_EQ(future.wait_for(10s), std::future_status::ready);
    EXPECT_EQ(future.get(), job);
  }
  EXPECT_EQ(worker.dropped(), 0u);
}

TEST(LatestOnlyWorker, StopEndsABusyJobForgetsTheWaitingOneAndJoins) {
  std::promise<void> entered;
  std::vector<int> done;
  LatestOnlyWorker<int>* self = nullptr;
  LatestOnlyWorker<int> worker(
      [&](int job) {
        entered.set_value();
        while (!self->stopFlag()) std::this_thread::sleep_for(1ms);
        done.push_back(job);
      },
      noException);
  self = &worker;
  worker.submit(1);
  entered.get_future().wait();
  worker.submit(2);
  worker.stop();
  EXPECT_EQ(done, (std::vector<int>{1}));
  worker.submit(3);
  worker.stop();
  EXPECT_EQ(done, (std::vector<int>{1}));
}

TEST(LatestOnlyWorker, StopsWithoutEverHavingWorked) {
  for (int i = 0; i < 200; ++i) LatestOnlyWorker<int>([](int) {}, noException);
}

TEST(LatestOnlyWorker, OutlivesExceptions) {
  std::vector<std::string> reported;
  std::promise<void> done;
  LatestOnlyWorker<int>* self = nullptr;
  LatestOnlyWorker<int> worker(
      [&](int job) {
        if (job == 0) {
          self->submit(1);
          throw std::runtime_error("first");
        }
        if (job == 1) {
          self->submit(2);
          throw 42;
        }
        done.set_value();
      },
      [&](const std::string& what) {
        reported.push_back(what);
        throw std::runtime_error("the report fails, too");
      });
  self = &worker;
  worker.submit(0);
  ASSERT_EQ(done.get_future().wait_for(10s), std::future_status::ready);
  worker.stop();
  ASSERT_EQ(reported.size(), 2u);
  EXPECT_EQ(reported[0], "first");
}

TEST(LatestOnlyWorker, FreesJobs) {
  auto job = std::make_shared<int>(1);
  const std::weak_ptr<int> watched = job;
  std::promise<void> entered, opened;
  auto open = opened.get_future().share();
  LatestOnlyWorker<std::shared_ptr<int>> worker(
      [&](const std::shared_ptr<int>& value) {
        if (value) return;
        entered.set_value();
        open.wait();
      },
      noException);
  worker.submit(nullptr);
  entered.get_future().wait();
  worker.submit(std::move(job));
  EXPECT_FALSE(watched.expired());
  worker.submit(std::make_shared<int>(2));
  EXPECT_TRUE(watched.expired());
  opened.set_value();
}

}  // namespace
