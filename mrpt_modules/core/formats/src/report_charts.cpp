// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "html_text.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numeric>

namespace traverse::formats
{
namespace
{
constexpr double kWidth = 720;

double drawable(double value)
{
  return std::isfinite(value) && value > 0 ? value : 0;
}

std::string withUnit(double value, const std::string& unit)
{
  return unit.empty() ? readableNumber(value) : readableNumber(value) + " " + unit;
}

std::string svgOpen(double height, const std::string& caption)
{
  return fmt::format(
      "<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">\n", kWidth, height,
      escaped(caption));
}
}  // namespace

std::string barChartSvg(const BarChart& chart)
{
  constexpr double kRow = 26;
  constexpr double kBar = 16;
  constexpr double kLabel = 190;
  constexpr double kValue = 130;
  constexpr size_t kLabelCharacters = 26;
  double largest = 0;
  for (const Bar& bar : chart.bars)
  {
    largest = std::max(largest, drawable(bar.value));
  }
  std::string svg =
      svgOpen(kRow * static_cast<double>(std::max<size_t>(1, chart.bars.size())), chart.caption);
  double y = 0;
  for (const Bar& bar : chart.bars)
  {
    const double length =
        largest > 0 ? drawable(bar.value) / largest * (kWidth - kLabel - kValue) : 0;
    const std::string fill =
        bar.colour ? fmt::format("style=\"fill:{}\"", cssColour(*bar.colour)) : "";
    svg += fmt::format(
        "<g><title>{0}</title><text x=\"{1}\" y=\"{2}\" text-anchor=\"end\">{3}</text>"
        "<rect class=\"bar outlined\" {4} x=\"{5}\" y=\"{6}\" width=\"{7:.2f}\" height=\"{8}\" "
        "rx=\"2\"/>"
        "<text class=\"soft\" x=\"{9:.2f}\" y=\"{2}\">{10}</text></g>\n",
        escaped(bar.label), kLabel - 10, y + 18, escaped(shortened(bar.label, kLabelCharacters)),
        fill, kLabel, y + (kRow - kBar) / 2, std::max(length, 1.0), kBar, kLabel + length + 8,
        escaped(withUnit(bar.value, chart.unit)));
    y += kRow;
  }
  return svg + "</svg>\n";
}

std::string histogramSvg(const Histogram& histogram)
{
  constexpr double kHeight = 190;
  constexpr double kTop = 24;
  constexpr double kBottom = 160;
  constexpr double kLeft = 8;
  constexpr double kRight = kWidth - 8;
  std::string svg = svgOpen(kHeight, histogram.caption);
  const size_t bins = histogram.counts.size();
  if (bins == 0)
  {
    return svg + "<text class=\"soft\" x=\"8\" y=\"90\">no values</text></svg>\n";
  }
  const uint64_t largest =
      std::max<uint64_t>(1, *std::max_element(histogram.counts.begin(), histogram.counts.end()));
  const double step = (kRight - kLeft) / static_cast<double>(bins);
  const double gap = std::min(2.0, step / 5);
  for (size_t i = 0; i < bins; ++i)
  {
    const double share = static_cast<double>(histogram.counts[i]) / static_cast<double>(largest);
    const double from = histogram.first_edge + histogram.bin_width * static_cast<double>(i);
    svg += fmt::format(
        "<rect class=\"bar\" x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\">"
        "<title>{:.4g} to {:.4g}: {}</title></rect>\n",
        kLeft + step * static_cast<double>(i), kBottom - share * (kBottom - kTop), step - gap,
        share * (kBottom - kTop), from, from + histogram.bin_width,
        readableNumber(static_cast<double>(histogram.counts[i])));
  }
  svg += fmt::format(
      "<line class=\"axis\" x1=\"{0}\" y1=\"{1}\" x2=\"{2}\" y2=\"{1}\"/>\n"
      "<text class=\"soft\" x=\"{0}\" y=\"14\">largest: {3}</text>\n",
      kLeft, kBottom, kRight, readableNumber(static_cast<double>(largest)));
  for (const int part : {0, 1, 2})
  {
    const char* anchor = part == 0 ? "start" : part == 1 ? "middle" : "end";
    const double at =
        histogram.first_edge + histogram.bin_width * static_cast<double>(bins) * part / 2.0;
    svg += fmt::format(
        "<text x=\"{:.2f}\" y=\"{}\" text-anchor=\"{}\">{:.3g} {}</text>\n",
        kLeft + (kRight - kLeft) * part / 2.0, kBottom + 20, anchor, at, escaped(histogram.unit));
  }
  return svg + "</svg>\n";
}

Histogram histogramOf(
    std::span<const float> values, size_t bins, std::string caption, std::string unit)
{
  Histogram histogram{std::move(caption), std::move(unit), 0, 1, {}};
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const float v : values)
  {
    if (std::isfinite(v))
    {
      low = std::min(low, double{v});
      high = std::max(high, double{v});
    }
  }
  if (low > high || bins == 0)
  {
    return histogram;
  }
  const bool constant = low == high;
  histogram.counts.assign(constant ? 1 : bins, 0);
  histogram.first_edge = constant ? low - 0.5 : low;
  histogram.bin_width = constant ? 1 : (high - low) / static_cast<double>(bins);
  for (const float v : values)
  {
    if (std::isfinite(v))
    {
      const auto bin =
          static_cast<size_t>((double{v} - histogram.first_edge) / histogram.bin_width);
      ++histogram.counts[std::min(bin, histogram.counts.size() - 1)];
    }
  }
  return histogram;
}
}  // namespace traverse::formats
