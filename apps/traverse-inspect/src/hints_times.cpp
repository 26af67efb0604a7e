// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evidence.h"
#include "log_summary.h"

#include <traverse/poses/timing.h>

#include <algorithm>
#include <fmt/format.h>

namespace traverse::app
{
namespace
{
using logs::SensorTimes;

std::string nameOf(const SensorTimes& sensor)
{
  return sensorName(sensor.label, sensor.type);
}

double asDouble(uint64_t n)
{
  return static_cast<double>(n);
}

void hintAtStamps(const SensorTimes& sensor, Hints& hints)
{
  if (sensor.bad > 0)
  {
    hints.push_back(
        {"bad_stamps",
         nameOf(sensor),
         Weight::suspicion,
         fmt::format(
             "{} of {} stamps are no clock's (none, before 1980 or after 2100)", sensor.bad,
             sensor.count),
         {{"stamps", asDouble(sensor.bad)}}});
  }
  if (sensor.backward > 0)
  {
    hints.push_back(
        {"backward_stamps",
         nameOf(sensor),
         Weight::suspicion,
         fmt::format(
             "{} stamps lie before their predecessor's: a clock that was set, or files put "
             "together out of order",
             sensor.backward),
         {{"stamps", asDouble(sensor.backward)}}});
  }
  if (sensor.repeated > 0)
  {
    hints.push_back(
        {"repeated_stamps",
         nameOf(sensor),
         Weight::suspicion,
         fmt::format(
             "{} stamps are their predecessor's again: data written twice, or stamps too coarse",
             sensor.repeated),
         {{"stamps", asDouble(sensor.repeated)}}});
  }
}

void hintAtRate(const SensorTimes& sensor, Hints& hints)
{
  constexpr double kSlowest_s = 100;  // scans further apart are nobody's
  constexpr double kFastest_s = 2e-5;
  const poses::Timing timing = poses::timingOf(sensor.stamps);
  const double period_s = timing.median_period_s;
  if (period_s > kSlowest_s || (period_s > 0 && period_s < kFastest_s))
  {
    hints.push_back(
        {"time_units",
         nameOf(sensor),
         Weight::suspicion,
         fmt::format(
             "a period of {:.3g} s: stamps look as if they were taken for {} seconds", period_s,
             period_s > kSlowest_s ? "milli- or microseconds written as" : "a fraction of"),
         {{"period_s", period_s}}});
    return;
  }
  if (timing.gaps.empty())
  {
    return;
  }
  const auto longest = std::max_element(
      timing.gaps.begin(), timing.gaps.end(),
      [](const poses::StampGap& a, const poses::StampGap& b) { return a.seconds() < b.seconds(); });
  hints.push_back(
      {"gaps",
       nameOf(sensor),
       Weight::suspicion,
       fmt::format(
           "silent {} times for more than {} periods, longest {:.2f} s from {}", timing.gaps.size(),
           poses::Timing::kGapPeriods, longest->seconds(), dateOf(longest->from_ns)),
       {{"gaps", asDouble(timing.gaps.size())}, {"longest_s", longest->seconds()}}});
}

/** A sensor whose stamps share no time with those of the sensor that spoke most. */
void hintAtClocks(const std::vector<SensorTimes>& sensors, Hints& hints)
{
  const auto main = std::max_element(
      sensors.begin(), sensors.end(),
      [](const SensorTimes& a, const SensorTimes& b) { return a.stamps.size() < b.stamps.size(); });
  for (const SensorTimes& sensor : sensors)
  {
    if (sensor.first == 0 || main->first == 0 || sensor.count < 2 ||
        (sensor.first <= main->last && sensor.last >= main->first))
    {
      continue;
    }
    const double apart_s = poses::secondsBetween(main->first, sensor.first);
    hints.push_back(
        {"clock_span",
         nameOf(sensor),
         Weight::suspicion,
         fmt::format(
             "its stamps share no time with those of {}: they begin {:.3f} s {}; another clock, or "
             "another time zone",
             nameOf(*main), std::abs(apart_s), apart_s > 0 ? "later" : "earlier"),
         {{"apart_s", apart_s}}});
  }
}
}  // namespace

void hintAtTimes(const Evidence& evidence, Hints& hints)
{
  const size_t before = hints.size();
  for (const SensorTimes& sensor : evidence.report.sensors)
  {
    hintAtStamps(sensor, hints);
    hintAtRate(sensor, hints);
  }
  hintAtClocks(evidence.report.sensors, hints);
  if (hints.size() == before && !evidence.report.sensors.empty())
  {
    hints.push_back(
        {"times", "log", Weight::fine, "stamps are in order, without gaps, of one clock", {}});
  }
}
}  // namespace traverse::app
