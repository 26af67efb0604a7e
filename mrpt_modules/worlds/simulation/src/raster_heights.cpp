// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster.h"
#include "refuse.h"

#include <traverse/formats/bytes.h>
#include <traverse/formats/gzip.h>
#include <traverse/formats/safe_file.h>

#include <charconv>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

namespace traverse::simulation
{
namespace
{
constexpr size_t kMostNodes = 64U << 20U;
constexpr size_t kLargestFile = 512U << 20U;
constexpr size_t kLargestTransform = 64U << 10U;
constexpr std::string_view kEnding = "_float32.raw.gz";

size_t wholeNumber(std::string_view text)
{
  size_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && stop == text.data() + text.size() ? value : 0;
}

/** "..._785x880_float32.raw.gz": 785 rows of 880. */
void sizesFromName(const std::string& file, Raster& raster)
{
  if (file.size() > kEnding.size() && file.ends_with(kEnding))
  {
    const std::string_view stem = std::string_view(file).substr(0, file.size() - kEnding.size());
    const std::string_view sizes = stem.substr(stem.rfind('_') + 1);
    const size_t cross = sizes.find('x');
    if (cross != std::string_view::npos)
    {
      raster.rows = wholeNumber(sizes.substr(0, cross));
      raster.columns = wholeNumber(sizes.substr(cross + 1));
    }
  }
  const bool possible = raster.rows >= 2 && raster.columns >= 2 && raster.rows <= kMostNodes &&
                        raster.columns <= kMostNodes / raster.rows;
  if (!possible)
  {
    throw options::OptionError(
        "file", file, "NAME_ROWSxCOLS_float32.raw.gz with sizes of 2 to 64 million nodes in all");
  }
}

/** node = s (R world + t), world = origin + place. */
void readTransform(const std::string& text, const TerrainParams& params, Raster& raster)
{
  const nlohmann::json json = nlohmann::json::parse(text);
  const auto r = json.at("R").get<std::vector<double>>();
  const auto t = json.at("t").get<std::vector<double>>();
  const auto s = json.at("s").get<double>();
  if (r.size() != 4 || t.size() != 2 || !(s > 0))
  {
    throw options::OptionError("transform_file", params.transform_file, "R of 4, t of 2, s > 0");
  }
  const Eigen::Matrix2d turn = (Eigen::Matrix2d() << r[0], r[1], r[2], r[3]).finished();
  const Eigen::Vector2d origin(params.origin_x_m, params.origin_y_m);
  raster.to_node = s * turn;
  raster.shift = s * (turn * origin + Eigen::Vector2d(t[0], t[1]));
  if (!raster.to_node.allFinite() || !raster.shift.allFinite())
  {
    throw options::OptionError("transform_file", params.transform_file, "finite numbers");
  }
}
}  // namespace

Raster heightRaster(const TerrainParams& params, const SceneParams& scene)
{
  Raster raster;
  sizesFromName(params.file, raster);
  const size_t bytes = raster.rows * raster.columns * sizeof(float);
  const std::string heights =
      formats::gunzip(formats::readFile(scene.folder / params.file, kLargestFile), bytes);
  if (heights.size() != bytes)
  {
    throw options::OptionError(
        "file", params.file, std::to_string(bytes) + " bytes of heights, as its name says");
  }
  raster.heights_m.resize(raster.rows * raster.columns);
  std::memcpy(raster.heights_m.data(), heights.data(), bytes);
  if (params.transform_file.empty())
  {
    throw options::OptionError("transform_file", "", "the JSON file beside the raster");
  }
  try
  {
    readTransform(
        formats::readFile(scene.folder / params.transform_file, kLargestTransform), params, raster);
  }
  catch (const nlohmann::json::exception& e)
  {
    throw options::OptionError("transform_file", params.transform_file, e.what());
  }
  return raster;
}
}  // namespace traverse::simulation
