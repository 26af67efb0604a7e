// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "truth_folder.h"

#include <traverse/common_app/input_file.h>
#include <traverse/formats/geojson.h>
#include <traverse/formats/geotiff_read.h>
#include <traverse/formats/trajectory.h>

#include <fmt/format.h>
#include <iterator>
#include <map>
#include <stdexcept>
#include <utility>

namespace traverse::app
{
namespace
{
namespace fs = std::filesystem;

constexpr size_t kLargestText = size_t{256} << 20U;

bool isThere(const fs::path& file)
{
  std::error_code error;
  return fs::exists(file, error);
}

layers::LayerSet readLayers(const fs::path& folder)
{
  std::vector<fs::path> files;
  for (const char* name : {"truth_class.tif", "truth_state.tif", "truth_object.tif"})
  {
    files.push_back(folder / name);
  }
  if (isThere(folder / "truth_swept.tif"))
  {
    files.push_back(folder / "truth_swept.tif");
  }
  layers::LayerSet set = formats::readGeoTiffs(files);
  for (const fs::path& file : files)
  {
    if (set.find(file.stem().string()) == nullptr)
    {
      throw formats::FormatError(
          fmt::format("'{}' has no layer '{}'", file.string(), file.stem().string()));
    }
  }
  if (set.class_layer != "truth_class")
  {
    throw formats::FormatError(fmt::format("'{}' has no names of classes", files[0].string()));
  }
  return set;
}

double numberOf(const formats::Feature& feature, const std::string& key)
{
  const auto found = feature.properties.find(key);
  const auto* number =
      found == feature.properties.end() ? nullptr : std::get_if<double>(&found->second);
  return number == nullptr ? 0 : *number;
}

std::vector<evaluation::TrueOutline> readOutlines(const fs::path& file)
{
  constexpr double kLowest_m = 0.25;  // lower things are no obstacles
  constexpr double kMostObjects = 4e9;
  std::vector<evaluation::TrueOutline> outlines;
  if (!isThere(file))
  {
    return outlines;
  }
  const std::string text = asInput([&] { return formats::readFile(file, kLargestText); });
  for (formats::Feature& feature : formats::parseGeoJson(text, fmt::format("'{}'", file.string())))
  {
    const double object = numberOf(feature, "object");
    if (numberOf(feature, "height_m") >= kLowest_m && object >= 0 && object <= kMostObjects)
    {
      outlines.push_back({static_cast<uint32_t>(object), std::move(feature.polygons)});
    }
  }
  return outlines;
}

std::vector<evaluation::MovingFrame> readMoving(const fs::path& file)
{
  const std::string text = asInput([&] { return formats::readFile(file, kLargestText); });
  std::map<double, evaluation::MovingFrame> frames;
  for (formats::Feature& feature : formats::parseGeoJson(text, fmt::format("'{}'", file.string())))
  {
    const auto time = feature.properties.find("time_s");
    if (time == feature.properties.end() || !std::holds_alternative<double>(time->second))
    {
      throw formats::FormatError(
          fmt::format("'{}' has a feature without a number time_s", file.string()));
    }
    evaluation::MovingFrame& frame = frames[std::get<double>(time->second)];
    frame.time_s = std::get<double>(time->second);
    std::move(feature.polygons.begin(), feature.polygons.end(), std::back_inserter(frame.outlines));
  }
  std::vector<evaluation::MovingFrame> all;
  all.reserve(frames.size());
  for (auto& [time_s, frame] : frames)
  {
    all.push_back(std::move(frame));
  }
  return all;
}

std::vector<evaluation::Departure> readDepartures(
    const fs::path& file, const layers::LayerSet& layers)
{
  if (!isThere(file))
  {
    return {};
  }
  try
  {
    return evaluation::departuresOf(readMoving(file), layers.lattice, layers.extent);
  }
  catch (const std::length_error& e)
  {
    throw formats::FormatError(fmt::format("'{}': {}", file.string(), e.what()));
  }
}
}  // namespace

std::vector<poses::StampedPose> readTum(const fs::path& file)
{
  if (!isThere(file))
  {
    return {};
  }
  const std::string text = asInput([&] { return formats::readFile(file, kLargestText); });
  return text.empty() ? std::vector<poses::StampedPose>()
                      : formats::parseTrajectory({text, file.string()});
}

TruthFolder readTruth(const fs::path& folder)
{
  TruthFolder truth{
      readLayers(folder),
      readOutlines(folder / "footprints.geojson"),
      readTum(folder / "trajectory.tum"),
      {}};
  truth.departures = readDepartures(folder / "moving.geojson", truth.layers);
  return truth;
}
}  // namespace traverse::app
