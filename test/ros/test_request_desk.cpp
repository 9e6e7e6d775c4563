// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <thread>

#include "ros/request_desk.hpp"

namespace {

using Desk = objectness_segmentation::RequestDesk<int>;

TEST(RequestDesk, OnlyFramesNewerThanTheRequestAnswerIt) {
  Desk desk;
  EXPECT_FALSE(desk.pending());
  const Desk::Ticket before = desk.ticketFor(100, 100);
  EXPECT_EQ(before, 0u);
  Desk::Request request(desk, 100.5);
  EXPECT_TRUE(desk.pending());
  EXPECT_FALSE(desk.wants(before));
  const Desk::Ticket late = desk.ticketFor(100.4, 100.6);  // on its way when the request came
  EXPECT_FALSE(desk.wants(late));
  desk.answer(late, 1);
  EXPECT_FALSE(request.wait(0.01));
  const Desk::Ticket fresh = desk.ticketFor(100.6, 100.7);
  EXPECT_TRUE(desk.wants(fresh));
  desk.answer(fresh, 2);
  ASSERT_TRUE(request.wait(60));
  EXPECT_EQ(*request.wait(60), 2);
}

TEST(RequestDesk, KnowsOfFramesThatWereTooOld) {
  Desk desk;
  Desk::Request request(desk, 100);
  EXPECT_EQ(request.oldFrames().count, 0u);
  desk.ticketFor(93.5, 100.5);
  desk.ticketFor(94.5, 101.25);
  Desk::Request later(desk, 102);
  desk.ticketFor(101, 102.5);
  EXPECT_EQ(request.oldFrames().count, 2u);
  EXPECT_DOUBLE_EQ(request.oldFrames().age_s, 6.75);
  EXPECT_EQ(later.oldFrames().count, 1u);
  EXPECT_DOUBLE_EQ(later.oldFrames().age_s, 1.5);
}

TEST(RequestDesk, StampsOfAnotherClockCountByArrival) {
  Desk desk;
  EXPECT_EQ(desk.ticketFor(1000, 1e9), 0u);
  Desk::Request request(desk, 1e9);
  EXPECT_TRUE(desk.wants(desk.ticketFor(1000, 1e9 + 0.1)));
  EXPECT_TRUE(desk.wants(desk.ticketFor(0, 1e9 + 0.1)));
  EXPECT_TRUE(desk.wants(desk.ticketFor(2e9, 1e9 + 0.1)));
}

TEST(RequestDesk, AFrameAnswersAllRequestsBeforeIt) {
  Desk desk;
  Desk::Request first(desk, 1);
  Desk::Request second(desk, 2);
  const Desk::Ticket between = desk.ticketFor(1.5, 2.1), after = desk.ticketFor(2.5, 2.6);
  desk.answer(between, 15);
  EXPECT_EQ(first.wait(60).value_or(0), 15);
  EXPECT_FALSE(second.wait(0.01));
  desk.answer(after, 25);
  EXPECT_EQ(first.wait(60).value_or(0), 15);
  EXPECT_EQ(second.wait(60).value_or(0), 25);
}

TEST(RequestDesk, ARequestThatIsGoneIsNotWanted) {
  Desk desk;
  Desk::Ticket ticket = 0;
  {
    Desk::Request request(desk, 1);
    ticket = desk.ticketFor(2, 2);
  }
  EXPECT_FALSE(desk.pending());
  EXPECT_FALSE(desk.wants(ticket));
  desk.answer(ticket, 1);
  Desk::Request later(desk, 3);
  EXPECT_FALSE(desk.wants(ticket));
}

TEST(RequestDesk, StopEndsTheWaiting) {
  Desk desk;
  std::thread waiting([&desk] {
    Desk::Request request(desk, 1);
    EXPECT_FALSE(request.wait(600));
  });
  while (!desk.pending()) std::this_thread::yield();
  desk.stop();
  waiting.join();
  EXPECT_TRUE(desk.stopped());
  Desk::Request late(desk, 2);
  EXPECT_FALSE(late.wait(600));
}

}  // namespace
