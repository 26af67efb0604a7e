// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/formats/report.h>

#include <string>
#include <string_view>

namespace traverse::formats
{
/** Safe inside elements and quoted attributes: markup escaped, bytes that are no UTF-8 and control
 * characters replaced by U+FFFD. */
std::string escaped(std::string_view untrusted);

std::string base64(std::string_view bytes);

/** "#rrggbb" */
std::string cssColour(layers::Colour colour);

/** The page's style sheet. */
std::string_view styleSheet();

/** JSON (ASCII) that can stand in a script element: no markup left. */
std::string jsonInPage(std::string_view ascii_json);

/** A script of ours and what a policy calls it ("'sha256-...'"). */
struct PageScript
{
  std::string_view text;
  std::string_view sha256_hex;

  std::string source() const;
};

/** Made of resources/ when building: the maps of a report, the table of an index. */
const PageScript& mapScript();
const PageScript& sortScript();

/** What every page of ours has in its head. The policy makes the browser itself refuse every
 * address but data in the page, and every script but those of `script_source` (empty: all). */
std::string headLines(const std::string& script_source);

/** What stands in a section below its heading. */
std::string blocksHtml(const Section& section);

std::string barChartSvg(const BarChart& chart);
std::string histogramSvg(const Histogram& histogram);
std::string timelineSvg(const Timeline& timeline);

/** At most `most` characters, with an ellipsis; does not cut UTF-8 in two. */
std::string shortened(const std::string& text, size_t most);
}  // namespace traverse::formats
