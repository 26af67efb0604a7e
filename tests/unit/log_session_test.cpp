// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <frame_pipe.h>
#include <iostream>
#include <session.h>
#include <support/scratch_folder.h>
#include <unistd.h>

namespace
{
using namespace traverse;
using namespace traverse::logs;
using sandbox::ReaderJob;
using sandbox::SharedProgress;
using ::testing::HasSubstr;

constexpr auto kScan = static_cast<uint32_t>(FrameType::scan);

/** What the parent makes of a child that behaves like `job`. */
LogReport reportOf(const ReaderJob& job, const ReadOptions& options = {})
{
  const traverse::testing::ScratchFolder dir;
  traverse::testing::writeText(dir / "log", "something");
  Session session(dir / "log", {.reader_memory_mb = 128, .reader_timeout_s = 0.3}, options, job);
  while (session.next())
  {
  }
  return session.report();
}

void sendEnd(int frames_fd)
{
  FramePipe pipe(frames_fd);
  pipe.frames().add(FrameType::end);
  pipe.flush();
}

void send(int frames_fd, const FrameHeader& header)
{
  EXPECT_EQ(write(frames_fd, &header, sizeof(header)), static_cast<ssize_t>(sizeof(header)));
}

TEST(LogSession, EndsWell)
{
  const LogReport r = reportOf([](int, int frames, SharedProgress&) { sendEnd(frames); });
  EXPECT_TRUE(r.complete()) << r.damage;
}

TEST(LogSession, MoreSensorsThanAnyRobotHasShareAPlace)
{
  const LogReport r = reportOf(
      [](int, int frames, SharedProgress&)
      {
        FramePipe pipe(frames);
        for (int i = 0; i < 1000; ++i)
        {
          SightingFrame sighting;
          sighting.label = std::to_string(i);
          pipe.frames().add(sighting);
        }
        pipe.flush();
        sendEnd(frames);
      });
  ASSERT_EQ(r.sensors.size(), 257U);
  EXPECT_EQ(r.sensors.back().label, "others");
  EXPECT_EQ(r.sensors.back().count, 744U);
}

TEST(LogSession, AChildThatJustLeavesIsDamage)
{
  EXPECT_EQ(reportOf([](int, int, SharedProgress&) {}).end, LogEnd::damaged);
}

TEST(LogSession, AChildThatThrowsHasLastWords)
{
  const LogReport r =
      reportOf([](int, int, SharedProgress&) { throw std::runtime_error("out of cheese"); });
  EXPECT_THAT(r.damage, HasSubstr("out of cheese"));
}

TEST(LogSession, AChildThatDiesIsToldWithItsPlace)
{
  const LogReport r = reportOf(
      [](int, int, SharedProgress& progress)
      {
        progress.object = 16;
        progress.offset = 5;
        progress.setType("CSomething");
        raise(SIGSEGV);
      });
  EXPECT_THAT(r.damage, HasSubstr("died (signal 11)"));
  EXPECT_THAT(r.damage, HasSubstr("at object 17 (CSomething) near byte 5 of 9"));
}

TEST(LogSession, AChildThatDiesAfterItsEndIsDamageToo)
{
  const LogReport r = reportOf(
      [](int, int frames, SharedProgress&)
      {
        sendEnd(frames);
        raise(SIGKILL);
      });
  EXPECT_EQ(r.end, LogEnd::damaged);
}

TEST(LogSession, AChildThatSpinsOrSleepsIsEnded)
{
  const LogReport spins = reportOf(
      [](int, int, SharedProgress&)
      {
        for (volatile int i = 0;;)
        {
          i = 1 - i;
        }
      });
  EXPECT_THAT(spins.damage, HasSubstr("no progress"));
  const LogReport sleeps = reportOf([](int, int, SharedProgress&) { pause(); });
  EXPECT_THAT(sleeps.damage, HasSubstr("no progress"));
}

TEST(LogSession, AChildThatEatsMemoryIsEnded)
{
  const LogReport r = reportOf(
      [](int, int, SharedProgress&)
      {
        for (;;)
        {
          std::vector<char>* leak = new std::vector<char>(1U << 20U, 'x');
          EXPECT_NE(leak->data(), nullptr);
        }
      });
  EXPECT_EQ(r.end, LogEnd::damaged) << r.damage;
}

TEST(LogSession, NonsenseFromTheChildIsDamage)
{
  const LogReport magic = reportOf([](int, int frames, SharedProgress&)
                                   { send(frames, {.magic = 1, .type = kScan, .length = 0}); });
  EXPECT_THAT(magic.damage, HasSubstr("nonsense"));
  const LogReport length = reportOf([](int, int frames, SharedProgress&)
                                    { send(frames, {.type = kScan, .length = UINT64_MAX}); });
  EXPECT_THAT(length.damage, HasSubstr("nonsense"));
  const LogReport type =
      reportOf([](int, int frames, SharedProgress&) { send(frames, {.type = 99, .length = 0}); });
  EXPECT_THAT(type.damage, HasSubstr("nonsense"));
  const LogReport empty = reportOf([](int, int frames, SharedProgress&)
                                   { send(frames, {.type = kScan, .length = 0}); });
  EXPECT_THAT(empty.damage, HasSubstr("nonsense"));
}

TEST(LogSession, ACountOfMadeUpNamesIsBounded)
{
  const LogReport r = reportOf(
      [](int, int frames, SharedProgress&)
      {
        FramePipe pipe(frames);
        for (int i = 0; i < 5000; ++i)
        {
          pipe.frames().add(CountFrame{Counted::ignored, "C\n" + std::to_string(i), ""});
        }
        pipe.flush();
        sendEnd(frames);
      });
  EXPECT_TRUE(r.complete()) << r.damage;
  EXPECT_LE(r.ignored.size(), 257U);
  EXPECT_EQ(r.ignored.count("C?0"), 1U) << "nothing that moves a terminal's cursor";
}

TEST(LogSession, WhatTheChildPrintsIsNotShown)
{
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  const LogReport r = reportOf(
      [](int, int frames, SharedProgress&)
      {
        for (int i = 0; i < 100'000; ++i)
        {
          std::cout << "chatter of a library\n";
          std::cerr << "complaint\n";
        }
        std::cout.flush();
        sendEnd(frames);
      });
  EXPECT_TRUE(r.complete()) << r.damage;
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(LogSession, TheChildHasNoOtherFilesAndWritesNone)
{
  const traverse::testing::ScratchFolder dir;
  const LogReport r = reportOf(
      [&](int, int frames, SharedProgress&)
      {
        const int made = open((dir / "made").c_str(), O_WRONLY | O_CREAT, 0600);
        if (write(made, "x", 1) >= 0 || fcntl(6, F_GETFD) >= 0)
        {
          throw std::runtime_error("it could");
        }
        sendEnd(frames);
      });
  EXPECT_TRUE(r.complete()) << r.damage;
}

TEST(LogSession, AnInterruptFromTheKeyboardIsTheParentsAffair)
{
  const LogReport r = reportOf(
      [](int, int frames, SharedProgress&)
      {
        raise(SIGINT);
        sendEnd(frames);
      });
  EXPECT_TRUE(r.complete()) << r.damage;
}

TEST(LogSession, StopsWhileItWaits)
{
  const std::atomic<bool> stop = true;
  const LogReport r = reportOf([](int, int, SharedProgress&) { pause(); }, {.stop = &stop});
  EXPECT_EQ(r.end, LogEnd::stopped);
}
}  // namespace
