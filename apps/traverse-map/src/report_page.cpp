// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report_page.h"

#include <traverse/formats/layer_map.h>
#include <traverse/formats/png.h>

#include <fmt/format.h>

namespace traverse::app
{
namespace
{
using formats::readableNumber;

formats::Table countTable(
    const std::string& caption,
    const std::string& what,
    const std::map<std::string, uint64_t>& counts)
{
  formats::Table table{caption, {what, "number"}, {}};
  for (const auto& [name, count] : counts)
  {
    table.rows.push_back({name, readableNumber(static_cast<double>(count))});
  }
  return table;
}

std::map<std::string, uint64_t> rejectsByReason(const RunMetrics& metrics)
{
  std::map<std::string, uint64_t> counts;
  for (size_t i = 0; i < points::kRejectCount; ++i)
  {
    if (metrics.rejects.count[i] != 0)
    {
      counts[std::string(points::kRejectNames[i])] = metrics.rejects.count[i];
    }
  }
  return counts;
}

formats::Section overview(const RunMetrics& metrics)
{
  formats::Section section{"Overview", {}};
  for (const std::string& problem : metrics.problems)
  {
    section.blocks.emplace_back(formats::Notice{"Partial: " + problem});
  }
  for (const std::string& warning : metrics.warnings)
  {
    section.blocks.emplace_back(formats::Notice{warning});
  }
  formats::KeyFigures figures;
  figures.figures = {
      {"scans", readableNumber(static_cast<double>(metrics.scans))},
      {"points", readableNumber(static_cast<double>(metrics.points))},
      {"seconds", readableNumber(metrics.times.total_s())},
      {"peak memory, MB", readableNumber(peakMemory_mb())}};
  section.blocks.emplace_back(figures);
  return section;
}

formats::Timeline timelineOf(const RunMetrics& metrics)
{
  formats::Timeline timeline{
      "When each sensor spoke: its rate over the time of the log (high where it is highest), gaps "
      "in orange; red below the line: stamps that go backward, orange above: stamps that repeat",
      {}};
  timeline.rows.reserve(metrics.sensors.size());
  for (const logs::SensorTimes& sensor : metrics.sensors)
  {
    timeline.rows.push_back(
        {sensor.label, sensor.type, sensor.count, sensor.backward, sensor.repeated, sensor.bad,
         sensor.stamps});
  }
  return timeline;
}

formats::Section inputs(const RunMetrics& metrics)
{
  formats::Section section{"What came in", {}};
  if (!metrics.sensors.empty())
  {
    section.blocks.emplace_back(timelineOf(metrics));
  }
  section.blocks.emplace_back(
      countTable("Observations that became scans", "class", metrics.observations));
  const std::vector<std::pair<std::string, std::map<std::string, uint64_t>>> tables = {
      {"Observations left aside", metrics.ignored},
      {"Observations rejected, and why", metrics.rejected},
      {"Values that did not become points, by reason", rejectsByReason(metrics)},
      {"Poses from " + metrics.pose_source, metrics.poses},
      {"How the pose of a scan was found", metrics.pose_quality},
      {"Motion within a scan", metrics.deskew}};
  for (const auto& [caption, counts] : tables)
  {
    if (!counts.empty())
    {
      section.blocks.emplace_back(countTable(caption, "", counts));
    }
  }
  return section;
}

formats::Section times(const RunMetrics& metrics)
{
  formats::BarChart chart{"Time per stage", "s", {}};
  for (const auto& [stage, seconds] : metrics.times.seconds())
  {
    chart.bars.push_back({stage, seconds, std::nullopt});
  }
  return {"Time", {chart}};
}

formats::BarChart classChart(const MapMetrics& map, const layers::LayerSet& layers)
{
  formats::BarChart chart{"Cells by class", "cells", {}};
  for (const auto& [name, count] : map.cells_by_class)
  {
    std::optional<layers::Colour> colour;
    for (const layers::LegendEntry& entry : layers.legend)
    {
      colour = entry.name == name ? std::optional(entry.colour) : colour;
    }
    chart.bars.push_back({name, static_cast<double>(count), colour});
  }
  return chart;
}

/** Where none could be rendered, the classes themselves: a page without script needs some picture.
 */
std::vector<formats::Picture> withOne(
    std::vector<formats::Picture> pictures, const layers::LayerSet& layers)
{
  constexpr size_t kMostCells = 4'000'000;
  const layers::Layer* classes = layers.find(layers.class_layer);
  const bool drawable = classes != nullptr && layers.size() <= kMostCells &&
                        std::holds_alternative<std::vector<uint8_t>>(classes->data);
  if (pictures.empty() && drawable)
  {
    pictures.push_back(
        {formats::png(formats::classPicture(layers)), "Classes from above, north up.", true});
  }
  return pictures;
}

std::string partOf(const RunMetrics& metrics)
{
  if (metrics.piece)
  {
    return fmt::format(", piece {} of {}", metrics.piece->number, metrics.piece->of);
  }
  return metrics.merged_pieces > 0 ? fmt::format(", merged from {} pieces", metrics.merged_pieces)
                                   : "";
}
}  // namespace

std::string titleOf(const Settings& settings)
{
  return settings.run.title.empty() ? settings.rawlog.filename().string() : settings.run.title;
}

formats::Section mapSection(
    const MapMetrics& map, const MapLayers& shown, std::vector<formats::Picture> pictures)
{
  const layers::LayerSet& layers = shown.layers;
  formats::Section section{map.name, {}};
  section.blocks.emplace_back(formats::Paragraph{fmt::format(
      "{} scans with {} points in cells of {} m; {} points lay outside the map, {} scans had no "
      "valid pose.",
      map.scans, readableNumber(static_cast<double>(map.points)), layers.lattice.cell_m(),
      readableNumber(static_cast<double>(map.outside)), map.scans_no_pose)});
  section.blocks.emplace_back(formats::Gallery{withOne(std::move(pictures), layers)});
  section.blocks.emplace_back(formats::Legend{layers.legend});
  section.blocks.emplace_back(formats::layerMap(layers, shown.trajectory_m));
  section.blocks.emplace_back(classChart(map, layers));
  for (const layers::Layer& layer : layers.layers)
  {
    constexpr size_t kBins = 40;
    if (const auto* values = std::get_if<std::vector<float>>(&layer.data))
    {
      formats::Histogram histogram =
          formats::histogramOf(*values, kBins, layer.name, layer.unit == "1" ? "" : layer.unit);
      if (!histogram.counts.empty())
      {
        section.blocks.emplace_back(std::move(histogram));
      }
    }
  }
  return section;
}

std::string reportPage(
    const Settings& settings, const RunMetrics& metrics, std::vector<formats::Section> maps)
{
  formats::Report report;
  report.title = titleOf(settings);
  report.subtitle = settings.rawlog.string() + partOf(metrics);
  report.sections.push_back(overview(metrics));
  for (formats::Section& map : maps)
  {
    report.sections.push_back(std::move(map));
  }
  report.sections.push_back(inputs(metrics));
  report.sections.push_back(times(metrics));
  report.footer = "traverse-map " TRAVERSE_VERSION;
  return formats::html(report);
}
}  // namespace traverse::app
