// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planned_source.h"

#include <traverse/observations/cause.h>
#include <traverse/observations/convert.h>

#include <algorithm>

namespace traverse::importing
{
namespace
{
constexpr size_t kMostLines = 1000;
}  // namespace

void countImported(const mrpt::obs::CObservation& observation, ImportReport& report)
{
  std::string type = observation.GetRuntimeClass()->className;
  type.erase(0, type.rfind(':') == std::string::npos ? 0 : type.rfind(':') + 1);
  ++report.imported[observation.sensorLabel + " " + type];
}

void addDamage(const std::string& what, ImportReport& report)
{
  if (report.damage.size() < kMostLines)
  {
    report.damage.push_back(what);
  }
}

PlannedSource::PlannedSource(
    std::vector<Step> steps, ImportReport report, const ImportParams& params) :
    steps_(std::move(steps)), report_(std::move(report)), from_s_(params.from_s), to_s_(params.to_s)
{
  if (steps_.empty())
  {
    throw ImportError(params.input.string() + ": has no observations");
  }
  const bool all_stamped = std::all_of(
      steps_.begin(), steps_.end(), [](const Step& step) { return step.stamp.has_value(); });
  if (all_stamped)
  {
    std::stable_sort(
        steps_.begin(), steps_.end(),
        [](const Step& a, const Step& b) { return *a.stamp < *b.stamp; });
  }
}

bool PlannedSource::wanted(poses::TimeNs stamp)
{
  first_ = first_.value_or(stamp);
  const double at_s = poses::secondsBetween(*first_, stamp);
  return at_s >= from_s_ && at_s < to_s_;
}

std::optional<Entry> PlannedSource::next()
{
  while (next_ < steps_.size())
  {
    const Step& step = steps_[next_++];
    if (step.stamp && !wanted(*step.stamp))
    {
      continue;
    }
    try
    {
      Entry entry = step.load();
      if (!step.stamp && !wanted(observations::toTime(entry.observation->timestamp).value_or(0)))
      {
        continue;
      }
      countImported(*entry.observation, report_);
      return entry;
    }
    catch (const std::exception& e)
    {
      addDamage(observations::causeOf(e), report_);
    }
  }
  return std::nullopt;
}

double PlannedSource::progress() const
{
  return static_cast<double>(next_) / static_cast<double>(steps_.size());
}
}  // namespace traverse::importing
