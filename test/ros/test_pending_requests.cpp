// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <thread>

#include "ros/pending_requests.hpp"

namespace {

using Requests = objectness_segmentation::PendingRequests<int>;

TEST(PendingRequests, OnlyFramesNewerThanTheRequestAnswerIt) {
  Requests requests;
  EXPECT_FALSE(requests.pending());
  const Requests::RequestId before = requests.newestAnsweredBy(100, 100);
  EXPECT_EQ(before, 0u);
  Requests::Request request(requests, 100.5);
  EXPECT_TRUE(requests.pending());
  EXPECT_FALSE(requests.wants(before));
  const Requests::RequestId late = requests.newestAnsweredBy(100.4, 100.6);  // on its way when the request came
  EXPECT_FALSE(requests.wants(late));
  requests.answer(late, 1);
  EXPECT_FALSE(request.wait(0.01));
  const Requests::RequestId fresh = requests.newestAnsweredBy(100.6, 100.7);
  EXPECT_TRUE(requests.wants(fresh));
  requests.answer(fresh, 2);
  ASSERT_TRUE(request.wait(60));
  EXPECT_EQ(*request.wait(60), 2);
}

TEST(PendingRequests, KnowsOfFramesThatWereTooOld) {
  Requests requests;
  Requests::Request request(requests, 100);
  EXPECT_EQ(request.oldFrames().count, 0u);
  requests.newestAnsweredBy(93.5, 100.5);
  requests.newestAnsweredBy(94.5, 101.25);
  Requests::Request later(requests, 102);
  requests.newestAnsweredBy(101, 102.5);
  EXPECT_EQ(request.oldFrames().count, 2u);
  EXPECT_DOUBLE_EQ(request.oldFrames().age_s, 6.75);
  EXPECT_EQ(later.oldFrames().count, 1u);
  EXPECT_DOUBLE_EQ(later.oldFrames().age_s, 1.5);
}

TEST(PendingRequests, StampsOfAnotherClockCountByArrival) {
  Requests requests;
  EXPECT_EQ(requests.newestAnsweredBy(1000, 1e9), 0u);
  Requests::Request request(requests, 1e9);
  EXPECT_TRUE(requests.wants(requests.newestAnsweredBy(1000, 1e9 + 0.1)));
  EXPECT_TRUE(requests.wants(requests.newestAnsweredBy(0, 1e9 + 0.1)));
  EXPECT_TRUE(requests.wants(requests.newestAnsweredBy(2e9, 1e9 + 0.1)));
}

TEST(PendingRequests, AFrameAnswersAllRequestsBeforeIt) {
  Requests requests;
  Requests::Request first(requests, 1);
  Requests::Request second(requests, 2);
  const Requests::RequestId between = requests.newestAnsweredBy(1.5, 2.1), after = requests.newestAnsweredBy(2.5, 2.6);
  requests.answer(between, 15);
  EXPECT_EQ(first.wait(60).value_or(0), 15);
  EXPECT_FALSE(second.wait(0.01));
  requests.answer(after, 25);
  EXPECT_EQ(first.wait(60).value_or(0), 15);
  EXPECT_EQ(second.wait(60).value_or(0), 25);
}

TEST(PendingRequests, ARequestThatIsGoneIsNotWanted) {
  Requests requests;
  Requests::RequestId request_id = 0;
  {
    Requests::Request request(requests, 1);
    request_id = requests.newestAnsweredBy(2, 2);
  }
  EXPECT_FALSE(requests.pending());
  EXPECT_FALSE(requests.wants(request_id));
  requests.answer(request_id, 1);
  Requests::Request later(requests, 3);
  EXPECT_FALSE(requests.wants(request_id));
}

TEST(PendingRequests, StopEndsTheWaiting) {
  Requests requests;
  std::thread waiting([&requests] {
    Requests::Request request(requests, 1);
    EXPECT_FALSE(request.wait(600));
  });
  while (!requests.pending()) std::this_thread::yield();
  requests.stop();
  waiting.join();
  EXPECT_TRUE(requests.stopped());
  Requests::Request late(requests, 2);
  EXPECT_FALSE(late.wait(600));
}

}  // namespace
