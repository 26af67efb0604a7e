// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "html_text.h"

#include <traverse/formats/report.h>

#include <algorithm>
#include <fmt/format.h>

namespace traverse::formats
{
namespace
{
std::string captioned(const std::string& content, const std::string& caption)
{
  const std::string below =
      caption.empty() ? "" : fmt::format("<figcaption>{}</figcaption>", escaped(caption));
  return "<figure>" + content + below + "</figure>\n";
}

/** "12 345", "-0.5", "98 %", "1.5 s": stands to the right. */
bool looksLikeNumber(const std::string& text)
{
  const size_t first = text.find_first_not_of("-+\xE2\x88\x92 ");
  return first != std::string::npos && text[first] >= '0' && text[first] <= '9' &&
         std::count_if(text.begin(), text.end(), [](char c) { return c >= 'a' && c <= 'z'; }) <= 4;
}

std::string block(const Paragraph& p)
{
  return "<p>" + escaped(p.text) + "</p>\n";
}

std::string block(const Notice& notice)
{
  return "<p class=\"notice\" role=\"note\">" + escaped(notice.text) + "</p>\n";
}

std::string block(const KeyFigures& key)
{
  std::string out = "<dl class=\"figures\">";
  for (const KeyFigure& f : key.figures)
  {
    out += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", escaped(f.name), escaped(f.value));
  }
  return out + "</dl>\n";
}

std::string block(const Picture& picture)
{
  return captioned(
      fmt::format(
          "<img{} alt=\"{}\" src=\"data:image/png;base64,{}\">",
          picture.pixelated ? " class=\"pixelated\"" : "", escaped(picture.caption),
          base64(picture.png)),
      picture.caption);
}

std::string block(const Gallery& gallery)
{
  std::string out = "<div class=\"gallery\">\n";
  for (const Picture& picture : gallery.pictures)
  {
    out += block(picture);
  }
  return out + "</div>\n";
}

std::string block(const Legend& legend)
{
  std::string out = "<ul class=\"legend\">";
  for (const layers::LegendEntry& e : legend.entries)
  {
    out += fmt::format(
        "<li><span style=\"background:{}\"></span>{}</li>", cssColour(e.colour), escaped(e.name));
  }
  return out + "</ul>\n";
}

std::string cell(const char* tag, const std::string& text, bool number)
{
  return fmt::format("<{0}{1}>{2}</{0}>", tag, number ? " class=\"number\"" : "", escaped(text));
}

std::string block(const Table& table)
{
  // A column is one of numbers where its first row has one: then its heading stands right, too.
  const auto number = [&](size_t i)
  { return !table.rows.empty() && i < table.rows[0].size() && looksLikeNumber(table.rows[0][i]); };
  std::string out = "<div class=\"scroll\"><table>";
  out += table.caption.empty() ? "" : "<caption>" + escaped(table.caption) + "</caption>";
  out += "<thead><tr>";
  for (size_t i = 0; i < table.head.size(); ++i)
  {
    out += cell("th", table.head[i], number(i));
  }
  out += "</tr></thead>\n<tbody>";
  for (const auto& row : table.rows)
  {
    out += "<tr>";
    for (size_t i = 0; i < std::max(row.size(), table.head.size()); ++i)
    {
      out += cell("td", i < row.size() ? row[i] : "", number(i));
    }
    out += "</tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

/** The caption of a chart is its heading. */
std::string headed(const std::string& chart, const std::string& caption)
{
  return "<figure class=\"chart\"><figcaption>" + escaped(caption) + "</figcaption>" + chart +
         "</figure>\n";
}

std::string block(const BarChart& chart)
{
  return headed(barChartSvg(chart), chart.caption);
}

std::string block(const Histogram& h)
{
  return headed(histogramSvg(h), h.caption);
}

std::string block(const Timeline& timeline)
{
  return headed(timelineSvg(timeline), timeline.caption);
}

std::string block(const LayerMap& map)
{
  if (map.json.empty())
  {
    return "<p>" + escaped(map.caption) + "</p>\n";
  }
  return "<figure class=\"map\"><figcaption>" + escaped(map.caption) +
         "</figcaption><noscript><p>Layers can be switched where JavaScript may run.</p></noscript>"
         "<script type=\"application/json\">" +
         jsonInPage(map.json) + "</script></figure>\n";
}

bool hasMaps(const Report& report)
{
  const auto is_map = [](const Block& b)
  {
    const auto* map = std::get_if<LayerMap>(&b);
    return map != nullptr && !map->json.empty();
  };
  return std::any_of(
      report.sections.begin(), report.sections.end(),
      [&](const Section& s) { return std::any_of(s.blocks.begin(), s.blocks.end(), is_map); });
}

std::string navigation(const Report& report)
{
  std::string out = "<nav>";
  for (size_t i = 0; i < report.sections.size(); ++i)
  {
    out += fmt::format("<a href=\"#s{}\">{}</a>", i, escaped(report.sections[i].title));
  }
  return out + "</nav>\n";
}
}  // namespace

std::string headLines(const std::string& script_source)
{
  const std::string scripts = script_source.empty() ? "" : "; script-src " + script_source;
  return "<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src "
         "data:; "
         "style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'" +
         scripts + "\">\n";
}

std::string blocksHtml(const Section& section)
{
  std::string out;
  for (const Block& b : section.blocks)
  {
    out += std::visit([](const auto& content) { return block(content); }, b);
  }
  return out;
}

std::string html(const Report& report)
{
  const bool with_script = hasMaps(report);
  std::string page = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n" +
                     headLines(with_script ? mapScript().source() : "");
  page += fmt::format("<title>{}</title>\n<style>", escaped(report.title));
  page += styleSheet();
  page += fmt::format(
      "</style>\n</head>\n<body>\n<header><h1>{}</h1>\n<p class=\"subtitle\">{}</p>\n",
      escaped(report.title), escaped(report.subtitle));
  page += navigation(report) + "</header>\n<main>\n";
  for (size_t i = 0; i < report.sections.size(); ++i)
  {
    const Section& section = report.sections[i];
    page += fmt::format("<section id=\"s{}\">\n<h2>{}</h2>\n", i, escaped(section.title));
    page += blocksHtml(section) + "</section>\n";
  }
  page += "</main>\n<footer>" + escaped(report.footer) + "</footer>\n";
  if (with_script)
  {
    page += "<script>";
    page += mapScript().text;
    page += "</script>\n";
  }
  return page + "</body>\n</html>\n";
}
}  // namespace traverse::formats
