// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "summary.h"

#include <traverse/options/untrusted_text.h>

#include <cstdio>
#include <fmt/format.h>

namespace traverse::app
{
namespace
{
constexpr size_t kMostLines = 20;

/** The first lines of many, and how many more there are. */
template <class List, class F>
void tellSome(const char* kind, const List& list, F&& text_of)
{
  size_t told = 0;
  for (const auto& item : list)
  {
    if (told++ == kMostLines)
    {
      fmt::print(stderr, "traverse-import: {}: and {} more\n", kind, list.size() - kMostLines);
      return;
    }
    fmt::print(stderr, "traverse-import: {}: {}\n", kind, forTerminal(text_of(item)));
  }
}
}  // namespace

std::string forTerminal(const std::string& text)
{
  constexpr size_t kLongest = 300;
  return options::printable(text, kLongest);
}

std::string summaryOf(const importing::ImportReport& report)
{
  constexpr size_t kMostKinds = 200;
  std::string text;
  size_t kinds = 0;
  for (const auto& [what, count] : report.imported)
  {
    if (kinds++ == kMostKinds)
    {
      return text + fmt::format("and {} more\n", report.imported.size() - kMostKinds);
    }
    text += fmt::format("{:>8}  {}\n", count, forTerminal(what));
  }
  return text;
}

void tellProblems(const importing::ImportReport& report)
{
  const auto itself = [](const std::string& text) { return text; };
  tellSome("warning", report.warnings, itself);
  tellSome(
      "skipped", report.skipped,
      [](const auto& entry) { return fmt::format("{} x {}", entry.second, entry.first); });
  tellSome("damaged", report.damage, itself);
}
}  // namespace traverse::app
