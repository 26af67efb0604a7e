// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster.h"

#include "refuse.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace traverse::simulation
{
namespace
{
/** Embree ends the program where a mesh has no finite size. */
void checkHeights(const Raster& raster, const std::string& file)
{
  constexpr float kHighest_m = 1e4F;
  const bool possible = std::all_of(
      raster.heights_m.begin(), raster.heights_m.end(),
      [](float height_m) { return std::abs(height_m) <= kHighest_m; });
  if (!possible)
  {
    throw options::OptionError("file", file, "heights within 10 km of zero");
  }
}
}  // namespace

double Raster::at(double x_m, double y_m) const
{
  const Eigen::Vector2d node = to_node * Eigen::Vector2d(x_m, y_m) + shift;
  const double u = std::clamp(node.x(), 0.0, static_cast<double>(columns - 1));
  const double v = std::clamp(node.y(), 0.0, static_cast<double>(rows - 1));
  const size_t column = std::min(static_cast<size_t>(u), columns - 2);
  const size_t row = std::min(static_cast<size_t>(v), rows - 2);
  const double du = u - static_cast<double>(column);
  const double dv = v - static_cast<double>(row);
  const float* p = heights_m.data() + row * columns + column;
  const double south = (1 - du) * static_cast<double>(p[0]) + du * static_cast<double>(p[1]);
  p += columns;
  const double north = (1 - du) * static_cast<double>(p[0]) + du * static_cast<double>(p[1]);
  return (1 - dv) * south + dv * north - zero_m;
}

bool Raster::fillUnknown()
{
  std::deque<size_t> known;
  for (size_t i = 0; i < heights_m.size(); ++i)
  {
    if (std::isfinite(heights_m[i]))
    {
      known.push_back(i);
    }
  }
  if (known.empty())
  {
    return false;
  }
  const auto spread = [&](size_t from, size_t to)
  {
    if (!std::isfinite(heights_m[to]))
    {
      heights_m[to] = heights_m[from];
      known.push_back(to);
    }
  };
  for (; !known.empty(); known.pop_front())
  {
    const size_t i = known.front();
    const size_t column = i % columns;
    if (column > 0)
    {
      spread(i, i - 1);
    }
    if (column + 1 < columns)
    {
      spread(i, i + 1);
    }
    if (i >= columns)
    {
      spread(i, i - columns);
    }
    if (i + columns < heights_m.size())
    {
      spread(i, i + columns);
    }
  }
  return true;
}

std::shared_ptr<const Raster> loadRaster(const TerrainParams& params, const SceneParams& scene)
{
  if (params.file.empty())
  {
    throw options::OptionError("file", "", "a raster's file");
  }
  const bool gridded = params.file.ends_with(".raw.gz");
  auto raster =
      std::make_shared<Raster>(gridded ? heightRaster(params, scene) : pointRaster(params, scene));
  if (!raster->fillUnknown())
  {
    throw options::OptionError("file", params.file, "a file with known heights");
  }
  checkHeights(*raster, params.file);
  raster->zero_m = raster->at(0, 0);
  return raster;
}
}  // namespace traverse::simulation
