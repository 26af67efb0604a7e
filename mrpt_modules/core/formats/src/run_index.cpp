// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "html_text.h"

#include <traverse/formats/run_index.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>

namespace traverse::formats
{
namespace
{
constexpr std::string_view kMark = "<!DOCTYPE html>\n<!-- Index of runs of Traverse -->\n";
constexpr size_t kMostCharacters = 200;

/** A folder's name as a part of a relative address; no scheme, path or query can be made of it. */
std::string inAddress(const std::string& name)
{
  std::string out;
  for (const char c : name)
  {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                       c == '-' || c == '_' || c == '.';
    out += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<uint8_t>(c));
  }
  return out;
}

/** "2018-02-26 09:23" of a stamp that a clock can have given. */
std::string dateOf(double stamp_s)
{
  constexpr double kLatest_s = 4.2e9;  // in 2103
  if (!(stamp_s > 0 && stamp_s < kLatest_s))
  {
    return "";
  }
  using std::chrono::days;
  using std::chrono::sys_seconds;
  using std::chrono::year_month_day;
  const sys_seconds time{std::chrono::seconds(static_cast<int64_t>(stamp_s))};
  const year_month_day day{std::chrono::floor<days>(time)};
  const auto minutes_of_day =
      std::chrono::duration_cast<std::chrono::minutes>(time - std::chrono::floor<days>(time))
          .count();
  return fmt::format(
      "{:04}-{:02}-{:02} {:02}:{:02}", int{day.year()}, unsigned{day.month()}, unsigned{day.day()},
      minutes_of_day / 60, minutes_of_day % 60);
}

std::string textCell(const std::string& text)
{
  return "<td>" + escaped(shortened(text, kMostCharacters)) + "</td>";
}

template <class T>
std::string numberCell(const std::optional<T>& value)
{
  if (!value || !std::isfinite(static_cast<double>(*value)))
  {
    return "<td class=\"number\"></td>";
  }
  const auto number = static_cast<double>(*value);
  return fmt::format(
      "<td class=\"number\" data-value=\"{}\">{}</td>", *value,
      escaped(readableNumber(std::is_integral_v<T> ? number : std::round(number * 10) / 10)));
}

std::string rowOf(const RunEntry& run)
{
  const std::string title =
      escaped(shortened(run.title.empty() ? run.folder : run.title, kMostCharacters));
  const std::string picture =
      run.thumbnail.empty()
          ? ""
          : fmt::format("<img alt=\"\" src=\"data:image/png;base64,{}\">", base64(run.thumbnail));
  const auto linked = [&](const std::string& content)
  {
    return run.has_report
               ? fmt::format("<a href=\"./{}/report.html\">{}</a>", inAddress(run.folder), content)
               : content;
  };
  return "<tr><td class=\"thumbnail\">" + linked(picture) + "</td><td>" + linked(title) + "</td>" +
         textCell(run.folder) + textCell(run.log) + textCell(dateOf(run.recorded_s.value_or(0))) +
         fmt::format(
             "<td class=\"{}\">{}</td>", run.good ? "good" : "bad",
             escaped(shortened(run.state, kMostCharacters))) +
         numberCell(run.scans) + numberCell(run.points) + numberCell(run.seconds) +
         numberCell(run.warnings) + "</tr>\n";
}

std::string headings()
{
  std::string out = "<thead><tr><th></th>";
  for (const char* text : {"run", "folder", "log", "recorded (UTC)", "state"})
  {
    out += fmt::format("<th data-sort=\"yes\">{}</th>", text);
  }
  for (const char* text : {"scans", "points", "seconds", "warnings"})
  {
    out += fmt::format("<th class=\"number\" data-sort=\"yes\">{}</th>", text);
  }
  return out + "</tr></thead>\n";
}
}  // namespace

std::string_view runIndexMark()
{
  return kMark;
}

std::string runIndex(
    const std::string& title, const std::vector<RunEntry>& runs, const std::string& note)
{
  const PageScript& script = sortScript();
  const auto good =
      std::count_if(runs.begin(), runs.end(), [](const RunEntry& r) { return r.good; });
  std::string page(kMark);
  page +=
      "<html lang=\"en\">\n<head>\n" + headLines(script.source()) +
      fmt::format(
          "<title>{0}</title>\n<style>{1}</style>\n</head>\n<body class=\"wide\">\n<header><h1>{0}"
          "</h1>\n<p class=\"subtitle\">{2} runs, {3} of them complete</p></header>\n<main>"
          "<section>\n",
          escaped(shortened(title, kMostCharacters)), styleSheet(), runs.size(), good);
  page += note.empty() ? "" : "<p class=\"notice\" role=\"note\">" + escaped(note) + "</p>\n";
  page += "<div class=\"scroll\"><table class=\"runs\">" + headings() + "<tbody>\n";
  for (const RunEntry& run : runs)
  {
    page += rowOf(run);
  }
  page += "</tbody></table></div>\n</section></main>\n<script>";
  page += script.text;
  return page + "</script>\n</body>\n</html>\n";
}
}  // namespace traverse::formats
