// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "html_text.h"

#include <traverse/formats/timeline.h>

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace traverse::formats
{
namespace
{
constexpr double kWidth = 720;
constexpr double kRow = 66;
constexpr double kBand = 26;  // of a row: the rate
constexpr size_t kMostRows = 64;

using poses::secondsFrom;

/** Where stamps stand on the page. */
struct Axis
{
  int64_t first_ns = 0;
  int64_t last_ns = 0;

  double span_s() const { return secondsFrom(first_ns, last_ns); }

  double at(int64_t stamp_ns) const
  {
    return span_s() > 0 ? secondsFrom(first_ns, stamp_ns) / span_s() * kWidth : kWidth / 2;
  }
};

std::optional<Axis> axisOf(const Timeline& timeline)
{
  std::optional<Axis> axis;
  for (const TimelineRow& row : timeline.rows)
  {
    for (const int64_t stamp : row.stamps_ns)
    {
      axis = axis ? Axis{std::min(axis->first_ns, stamp), std::max(axis->last_ns, stamp)}
                  : Axis{stamp, stamp};
    }
  }
  return axis;
}

/** How many stamps fall on each part of the axis; so few parts that each has some of a steady
 * sensor, or the rate would seem to flicker. */
std::vector<size_t> binned(const TimelineRow& row, const Axis& axis)
{
  constexpr size_t kMostBins = 240;
  constexpr size_t kStampsPerBin = 6;
  std::vector<size_t> counts(
      std::clamp<size_t>(row.stamps_ns.size() / kStampsPerBin, 1, kMostBins));
  for (const int64_t stamp : row.stamps_ns)
  {
    const double share = axis.at(stamp) / kWidth;
    ++counts[std::min(
        static_cast<size_t>(share * static_cast<double>(counts.size())), counts.size() - 1)];
  }
  return counts;
}

std::string rateSvg(const TimelineRow& row, const Axis& axis, double bottom)
{
  const std::vector<size_t> counts = binned(row, axis);
  const double largest = static_cast<double>(*std::max_element(counts.begin(), counts.end()));
  const double step = kWidth / static_cast<double>(counts.size());
  std::string path = fmt::format("M0 {}", bottom);
  double x = 0;
  for (const size_t count : counts)
  {
    path += fmt::format("V{:.1f}", bottom - kBand * static_cast<double>(count) / largest);
    x += step;
    path += fmt::format("H{:.1f}", x);
  }
  return fmt::format("<path class=\"bar\" d=\"{}V{}Z\"/>", path, bottom);
}

std::string gapsSvg(const StampRhythm& rhythm, const Axis& axis, double bottom)
{
  std::string svg;
  for (const StampGap& gap : rhythm.gaps)
  {
    const double from = axis.at(gap.from_ns);
    svg += fmt::format(
        "<rect class=\"gap\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{}\"><title>no "
        "observation from {:.3f} s to {:.3f} s</title></rect>",
        from, bottom - kBand, std::max(1.0, axis.at(gap.to_ns) - from), kBand,
        secondsFrom(axis.first_ns, gap.from_ns), secondsFrom(axis.first_ns, gap.to_ns));
  }
  return svg;
}

/** Ticks where stamps went backward or came twice: one per place that can be told apart. */
std::string marksSvg(const TimelineRow& row, const Axis& axis, double bottom)
{
  std::set<std::pair<int, bool>> places;
  for (size_t i = 1; i < row.stamps_ns.size(); ++i)
  {
    if (row.stamps_ns[i] <= row.stamps_ns[i - 1])
    {
      places.emplace(
          static_cast<int>(axis.at(row.stamps_ns[i])), row.stamps_ns[i] < row.stamps_ns[i - 1]);
    }
  }
  std::string svg;
  for (const auto& [x, backward] : places)
  {
    svg += fmt::format(
        "<rect class=\"{}\" x=\"{}\" y=\"{:.1f}\" width=\"3\" height=\"7\"/>",
        backward ? "backward" : "repeated", x - 1, backward ? bottom + 2 : bottom - kBand - 7);
  }
  return svg;
}

std::string summaryOf(const TimelineRow& row, const StampRhythm& rhythm)
{
  std::string text = readableNumber(static_cast<double>(row.count));
  if (rhythm.period_s)
  {
    text += fmt::format(" \xC2\xB7 {:.3g} Hz", 1 / *rhythm.period_s);
  }
  if (rhythm.gap_count > 0)
  {
    text +=
        fmt::format(" \xC2\xB7 {} gaps, longest {:.3g} s", rhythm.gap_count, rhythm.longest_gap_s);
  }
  for (const auto& [number, what] :
       {std::pair(row.backward, "backward"), {row.repeated, "repeated"}, {row.bad, "no clock's"}})
  {
    text += number > 0 ? fmt::format(" \xC2\xB7 {} {}", number, what) : "";
  }
  const bool cut = row.stamps_ns.size() + row.bad < row.count;
  return text + (cut ? fmt::format(" \xC2\xB7 first {} shown", row.stamps_ns.size()) : "");
}

std::string rowSvg(const TimelineRow& row, const std::optional<Axis>& axis, double top)
{
  constexpr double kBottom = 56;
  const StampRhythm rhythm = rhythmOf(row.stamps_ns);
  std::string svg = fmt::format(
      "<g><text x=\"0\" y=\"{0}\">{1}<tspan class=\"soft\"> {2}</tspan></text>"
      "<text class=\"soft\" x=\"{3}\" y=\"{0}\" text-anchor=\"end\">{4}</text>",
      top + 14, escaped(shortened(row.label.empty() ? "(no label)" : row.label, 24)),
      escaped(shortened(row.type, 28)), kWidth, escaped(summaryOf(row, rhythm)));
  if (axis && !row.stamps_ns.empty())
  {
    svg += rateSvg(row, *axis, top + kBottom) + gapsSvg(rhythm, *axis, top + kBottom) +
           marksSvg(row, *axis, top + kBottom);
  }
  return svg + fmt::format(
                   "<line class=\"axis\" x1=\"0\" y1=\"{0}\" x2=\"{1}\" y2=\"{0}\"/></g>\n",
                   top + kBottom, kWidth);
}

std::string scaleSvg(const std::optional<Axis>& axis, double top)
{
  std::string svg;
  for (const int part : {0, 1, 2})
  {
    const char* anchor = part == 0 ? "start" : part == 1 ? "middle" : "end";
    svg += fmt::format(
        "<text class=\"soft\" x=\"{}\" y=\"{}\" text-anchor=\"{}\">{:.4g} s</text>\n",
        kWidth / 2 * part, top + 16, anchor, (axis ? axis->span_s() : 0) / 2 * part);
  }
  return svg;
}
}  // namespace

StampRhythm rhythmOf(std::span<const int64_t> stamps_ns)
{
  poses::Timing timing = poses::timingOf(stamps_ns);
  StampRhythm rhythm;
  if (timing.median_period_s > 0)
  {
    rhythm.period_s = timing.median_period_s;
  }
  rhythm.gaps = std::move(timing.gaps);
  rhythm.gap_count = rhythm.gaps.size();
  rhythm.longest_gap_s = rhythm.gaps.empty() ? 0 : timing.longest_period_s;
  if (rhythm.gaps.size() > StampRhythm::kMostGaps)
  {
    std::stable_sort(
        rhythm.gaps.begin(), rhythm.gaps.end(),
        [](const StampGap& a, const StampGap& b) { return a.seconds() > b.seconds(); });
    rhythm.gaps.resize(StampRhythm::kMostGaps);
    std::sort(
        rhythm.gaps.begin(), rhythm.gaps.end(),
        [](const StampGap& a, const StampGap& b) { return a.from_ns < b.from_ns; });
  }
  return rhythm;
}

std::string timelineSvg(const Timeline& timeline)
{
  const size_t rows = std::min(timeline.rows.size(), kMostRows);
  const std::optional<Axis> axis = axisOf(timeline);
  const double height = kRow * static_cast<double>(rows) + 24;
  std::string svg = fmt::format(
      "<svg class=\"timeline\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">\n", kWidth,
      height, escaped(timeline.caption));
  double top = 0;
  for (size_t i = 0; i < rows; ++i)
  {
    svg += rowSvg(timeline.rows[i], axis, top);
    top += kRow;
  }
  svg += scaleSvg(axis, top) + "</svg>\n";
  if (rows < timeline.rows.size())
  {
    svg += fmt::format("<p>{} more are not shown.</p>\n", timeline.rows.size() - rows);
  }
  return svg;
}
}  // namespace traverse::formats
