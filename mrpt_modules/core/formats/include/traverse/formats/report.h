// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/layer_set.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace traverse::formats
{
/** A line or two of prose. */
struct Paragraph
{
  std::string text;
};

/** Something the reader must not miss: a partial result, skipped data. */
struct Notice
{
  std::string text;
};

/** One large number with its name: {"points", "1 204 551"}. */
struct KeyFigure
{
  std::string name;
  std::string value;
};

/** Shown side by side, first thing of a section. */
struct KeyFigures
{
  std::vector<KeyFigure> figures;
};

/** A PNG file's bytes; they are put into the page. */
struct Picture
{
  std::string png;
  std::string caption;
  bool pixelated = false;  //!< cells keep hard edges when enlarged
};

/** Pictures side by side as the window allows. */
struct Gallery
{
  std::vector<Picture> pictures;
};

/** What the colours of the pictures mean. */
struct Legend
{
  std::vector<layers::LegendEntry> entries;
};

/** Cells that are numbers stand to the right. Shorter rows are filled up. */
struct Table
{
  std::string caption;
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
};

/** One bar; no colour: the page's own. Values that are not finite or negative are drawn as 0. */
struct Bar
{
  std::string label;
  double value = 0;
  std::optional<layers::Colour> colour;
};

/** Horizontal bars with their values, in the order given. */
struct BarChart
{
  std::string caption;
  std::string unit;  //!< "s", "cells" ...
  std::vector<Bar> bars;
};

/** How often values fall between equally spaced edges. */
struct Histogram
{
  std::string caption;
  std::string unit;  //!< of the values
  double first_edge = 0;
  double bin_width = 1;
  std::vector<uint64_t> counts;
};

/** When one sensor spoke. */
struct TimelineRow
{
  std::string label;
  std::string type;
  uint64_t count = 0;     //!< observations
  uint64_t backward = 0;  //!< stamped before their predecessor
  uint64_t repeated = 0;  //!< stamped as their predecessor
  uint64_t bad = 0;       //!< without a usable stamp

  std::vector<int64_t> stamps_ns;  //!< in order of arrival; may be the first ones only
};

/** Rates over a common time, gaps (more than three times the usual step), and where stamps went
 * backward (below the line) or came twice (above). The first 64 rows are drawn. */
struct Timeline
{
  std::string caption;
  std::vector<TimelineRow> rows;
};

/** A map to explore: layers to switch, values of the cell under the pointer. See layerMap(). */
struct LayerMap
{
  std::string caption;
  std::string json;  //!< ASCII; empty: the caption alone
};

using Block = std::variant<
    Paragraph,
    Notice,
    KeyFigures,
    Picture,
    Gallery,
    Legend,
    Table,
    BarChart,
    Histogram,
    Timeline,
    LayerMap>;

struct Section
{
  std::string title;
  std::vector<Block> blocks;
};

struct Report
{
  std::string title;
  std::string subtitle;
  std::vector<Section> sections;
  std::string footer;
};

/** The report as one HTML page that needs nothing else and loads nothing: light and dark, also for
 * print. It has a script where it has a LayerMap, the page's own one and no other may run; all else
 * can be read without. All texts may be hostile; they are escaped, and bytes that are no UTF-8
 * shown as such. The same report gives the same bytes. */
std::string html(const Report& report);

/** Histogram of the finite values over their own range; no counts where there are none. A constant
 * value gives one bin around it. */
Histogram histogramOf(
    std::span<const float> values, size_t bins, std::string caption, std::string unit);

/** A number for people: whole ones in groups of three digits ("12 345"), others with 4 digits. */
std::string readableNumber(double value);
}  // namespace traverse::formats
