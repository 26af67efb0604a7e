// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "html_text.h"

#include <traverse/formats/bytes.h>
#include <traverse/formats/report_addition.h>

#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>

namespace traverse::formats
{
namespace
{
// Texts in a page are escaped, so that none of these can stand in one.
constexpr std::string_view kBeginning = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n";
constexpr std::string_view kNavigationEnd = "</nav>\n</header>\n";
constexpr std::string_view kMainEnd = "</main>\n<footer>";

struct Markers
{
  std::string begin;
  std::string end;

  explicit Markers(std::string_view id) :
      begin(fmt::format("<!-- added: {} -->", id)), end(fmt::format("<!-- end of {} -->", id))
  {
  }

  std::string around(const std::string& content) const { return begin + content + end; }
};

[[noreturn]] void refuse()
{
  throw FormatError("is no report of this program, or was changed by hand");
}

std::string withoutAdded(std::string_view page, const Markers& markers)
{
  std::string rest;
  while (true)
  {
    const size_t begin = page.find(markers.begin);
    if (begin == std::string_view::npos)
    {
      return rest.append(page);
    }
    const size_t end = page.find(markers.end, begin);
    if (end == std::string_view::npos)
    {
      refuse();
    }
    rest.append(page.substr(0, begin));
    page.remove_prefix(end + markers.end.size());
  }
}

void insertBefore(std::string& page, std::string_view place, const std::string& text)
{
  const size_t at = page.find(place);
  if (at == std::string::npos || page.find(place, at + 1) != std::string::npos)
  {
    refuse();
  }
  page.insert(at, text);
}

void check(std::string_view id, const Section& section)
{
  const auto plain = [](char c)
  { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; };
  const bool has_map = std::any_of(
      section.blocks.begin(), section.blocks.end(),
      [](const Block& b) { return std::holds_alternative<LayerMap>(b); });
  // two hyphens would end the comment that the id stands in
  if (id.empty() || !std::all_of(id.begin(), id.end(), plain) ||
      id.find("--") != std::string_view::npos || has_map)
  {
    throw std::invalid_argument("a section that cannot be added to a page");
  }
}
}  // namespace

std::string withAddedSection(std::string_view page, std::string_view id, const Section& section)
{
  check(id, section);
  if (page.substr(0, kBeginning.size()) != kBeginning)
  {
    refuse();
  }
  const Markers markers(id);
  std::string added = withoutAdded(page, markers);
  insertBefore(
      added, kNavigationEnd,
      markers.around(fmt::format("<a href=\"#{}\">{}</a>", id, escaped(section.title))));
  insertBefore(
      added, kMainEnd,
      markers.around(fmt::format(
          "<section id=\"{}\">\n<h2>{}</h2>\n{}</section>\n", id, escaped(section.title),
          blocksHtml(section))));
  return added;
}
}  // namespace traverse::formats
