// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// A log read in pieces gives every scan once, and the same as a reader of the whole.
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <gtest/gtest.h>

#include <random>
#include <support/log_reading.h>

namespace
{
using namespace traverse;
using namespace traverse::logs;
using traverse::testing::laserScan;
using traverse::testing::LogReading;
using traverse::testing::readLog;
using traverse::testing::ScratchFolder;
using traverse::testing::serialised;
using traverse::testing::writeText;

mrpt::obs::CObservation2DRangeScan labelled(const std::string& label, double t_s, float range_m)
{
  mrpt::obs::CObservation2DRangeScan scan = laserScan(t_s, range_m);
  scan.sensorLabel = label;
  return scan;
}

/** Two lasers, scans that stand twice, stamps that go back and stand still, frames, other things,
 * broken scans between repetitions. */
std::vector<std::string> mixedLog(std::mt19937& random, int entries)
{
  std::vector<std::string> log;
  std::string last;
  for (int i = 0; i < entries; ++i)
  {
    const std::string label = random() % 2 == 0 ? "A" : "B";
    const double t = static_cast<double>(random() % 8);
    const auto range = static_cast<float>(1 + random() % 3);
    switch (random() % 6)
    {
      case 0:
        last = last.empty() ? serialised(labelled(label, t, range)) : last;  // once more
        break;
      case 1:
      {
        mrpt::obs::CSensoryFrame frame;
        frame.insert(std::make_shared<mrpt::obs::CObservation2DRangeScan>(labelled("A", t, range)));
        frame.insert(std::make_shared<mrpt::obs::CObservation2DRangeScan>(labelled("B", t, range)));
        last = serialised(frame);
        break;
      }
      case 2:
        last = serialised(mrpt::obs::CObservationIMU());
        break;
      case 3:
      {
        auto broken = labelled(label, t, range);
        broken.deltaPitch = 1;  // which is refused
        last = serialised(broken);
        break;
      }
      default:
        last = serialised(labelled(label, t, range));
    }
    log.push_back(last);
  }
  return log;
}

std::string bytesOf(const std::vector<points::Decoded>& scans)
{
  std::string all;
  for (const points::Decoded& d : scans)
  {
    all += d.scan.sensor_label + std::to_string(d.scan.stamp) + ' ';
    for (const auto* channel : {&d.scan.x, &d.scan.y, &d.scan.z, &d.scan.time_s})
    {
      all.append(reinterpret_cast<const char*>(channel->data()), channel->size() * sizeof(float));
    }
  }
  return all;
}

template <class Counts>
void add(Counts& to, const Counts& from)
{
  for (const auto& [key, count] : from)
  {
    to[key] += count;
  }
}

void expectPiecesToBeTheWhole(
    const std::filesystem::path& log,
    uint64_t entries,
    const observations::ObservationParams& sensors = {})
{
  const LogReading whole = readLog(log, sensors);
  ASSERT_EQ(whole.report.objects, entries);
  ASSERT_EQ(countEntries(log, {}).objects, entries);
  for (const uint64_t cut : {entries / 3, entries / 2, entries - 1})
  {
    LogReading sum;
    for (const EntryRange range :
         {EntryRange{0, cut}, EntryRange{cut, cut + 1}, EntryRange{cut + 1}})
    {
      LogReading piece = readLog(log, sensors, {.entries = range});
      EXPECT_TRUE(piece.report.complete()) << piece.report.damage;
      std::move(piece.scans.begin(), piece.scans.end(), std::back_inserter(sum.scans));
      sum.report.objects += piece.report.objects;
      add(sum.report.observations, piece.report.observations);
      add(sum.report.ignored, piece.report.ignored);
      add(sum.report.rejected, piece.report.rejected);
    }
    EXPECT_EQ(bytesOf(sum.scans), bytesOf(whole.scans)) << "cut at " << cut;
    EXPECT_EQ(sum.report.objects, whole.report.objects);
    EXPECT_EQ(sum.report.observations, whole.report.observations);
    EXPECT_EQ(sum.report.ignored, whole.report.ignored);
    EXPECT_EQ(sum.report.rejected, whole.report.rejected);
  }
}

TEST(LogPieces, AreTheWholeLog)
{
  const ScratchFolder scratch;
  std::mt19937 random(5);
  for (int round = 0; round < 8; ++round)
  {
    std::string log;
    for (const std::string& entry : mixedLog(random, 24))
    {
      log += entry;
    }
    writeText(scratch / "mixed.rawlog", log);
    expectPiecesToBeTheWhole(scratch / "mixed.rawlog", 24);
  }
}

TEST(LogPieces, OfALogThatIsOneObjectAreTheWholeLog)
{
  const ScratchFolder scratch;
  mrpt::obs::CRawlog log;
  for (int i = 0; i < 9; ++i)
  {
    log.insert(std::make_shared<mrpt::obs::CObservation2DRangeScan>(laserScan(0.1 * i)));
  }
  writeText(scratch / "one.rawlog", serialised(log));
  expectPiecesToBeTheWhole(scratch / "one.rawlog", 10);  // its comment is one, too
}

TEST(LogPieces, CutNoSweepOfATiltingScanner)
{
  const ScratchFolder scratch;
  std::string log;
  for (int i = 0; i < 40; ++i)
  {
    auto row = labelled("TILT", 0.02 * i, 5.0F + 0.01F * static_cast<float>(i));
    const int swing = i % 20;
    row.sensorPose.setYawPitchRoll(0, 0.05 * (swing < 10 ? swing : 20 - swing), 0);
    log += serialised(row);
  }
  writeText(scratch / "tilt.rawlog", log);
  observations::ObservationParams sensors;
  sensors.tilting_labels = "TILT";
  EXPECT_GT(readLog(scratch / "tilt.rawlog", sensors).scans.size(), 2U);
  expectPiecesToBeTheWhole(scratch / "tilt.rawlog", 40, sensors);
}

TEST(LogPieces, TheLastOneTellsTheDamage)
{
  const ScratchFolder scratch;
  const std::string log = traverse::testing::laserLog(6);
  writeText(scratch / "cut.rawlog", log.substr(0, log.size() - 100));
  EXPECT_EQ(countEntries(scratch / "cut.rawlog", {}).objects, 5U);
  EXPECT_TRUE(readLog(scratch / "cut.rawlog", {}, {.entries = {0, 3}}).report.complete());
  const LogReading last = readLog(scratch / "cut.rawlog", {}, {.entries = {3}});
  EXPECT_EQ(last.report.end, LogEnd::damaged);
  EXPECT_EQ(last.scans.size(), 2U);
}
}  // namespace
