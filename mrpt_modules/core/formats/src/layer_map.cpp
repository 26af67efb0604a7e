// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The data of a map in report.html, as resources/map_viewer.js reads it:
// {cell_mm, x, y (index of the lower left cell), step (cells per square's edge), width, height
// (squares),
//  class (name of the class layer), legend: [[code, name, "#rrggbb"]...], path: [x, y, x, y...] in
//  m, layers: [{name, unit, type, base, data}...]}
// data is base64 of deflated planes of bytes, all lowest bytes first: equal exponents lie side by
// side. type: u8, u32: as they are; f24: floats without their lowest byte; f32: floats over `base`.
#include "html_text.h"
#include "known_cells.h"

#include <traverse/formats/layer_map.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <zlib.h>

namespace traverse::formats
{
namespace
{
using Json = nlohmann::ordered_json;
constexpr size_t kNoCell = std::numeric_limits<size_t>::max();

/** Which cell stands for each square. */
struct Squares
{
  geometry::CellIndex corner;
  int32_t step = 1;
  size_t width = 0;
  size_t height = 0;
  std::vector<size_t> cells;  //!< place in the layers, or kNoCell
};

size_t squaresAlong(int32_t cells, int32_t step)
{
  return (static_cast<size_t>(cells) + static_cast<size_t>(step) - 1) / static_cast<size_t>(step);
}

geometry::CellRect boundsOf(const layers::LayerSet& set, const std::vector<size_t>& known)
{
  geometry::CellRect bounds;
  for (const size_t place : known)
  {
    const geometry::CellIndex c = cellAt(set, place);
    bounds = bounding(bounds, {c, {c.x + 1, c.y + 1}});
  }
  return bounds;
}

Squares squaresOf(
    const layers::LayerSet& set,
    const std::vector<size_t>& known,
    const geometry::CellRect& bounds,
    int32_t step)
{
  Squares squares{bounds.min, step, 0, 0, {}};
  squares.width = squaresAlong(bounds.width(), step);
  squares.height = squaresAlong(bounds.height(), step);
  squares.cells.assign(squares.width * squares.height, kNoCell);
  const CellClass classes(set);
  for (const size_t place : known)
  {
    const geometry::CellIndex c = cellAt(set, place);
    const auto column = static_cast<size_t>((c.x - bounds.min.x) / step);
    const auto row = static_cast<size_t>((c.y - bounds.min.y) / step);
    size_t& best = squares.cells[row * squares.width + column];
    best = best == kNoCell || classes.at(place) > classes.at(best) ? place : best;
  }
  return squares;
}

/** A float's bits with the lowest 8 rounded away; NaN is always the same one. */
uint32_t roundedBits(float value)
{
  const auto bits = std::bit_cast<uint32_t>(value);
  if (std::isnan(value))
  {
    return 0x7FC00000U;
  }
  return std::isinf(value) ? bits : (bits + 0x80U) & ~0xFFU;
}

std::string deflated(const std::string& bytes)
{
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  if (compress2(
          reinterpret_cast<Bytef*>(packed.data()), &size,
          reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(),
          Z_DEFAULT_COMPRESSION) != Z_OK)
  {
    throw std::bad_alloc();  // the one thing that can go wrong with a buffer of that size
  }
  packed.resize(size);
  return packed;
}

/** Bytes first_plane to 3 of all numbers. */
std::string planes(const std::vector<uint32_t>& numbers, unsigned first_plane)
{
  std::string bytes;
  bytes.reserve(numbers.size() * (4 - first_plane));
  for (unsigned plane = first_plane; plane < 4; ++plane)
  {
    for (const uint32_t number : numbers)
    {
      bytes += static_cast<char>((number >> (8 * plane)) & 0xFFU);
    }
  }
  return bytes;
}

/** What all squares are in one layer, as numbers of 32 bits. */
template <class T, class F>
std::vector<uint32_t> numbersOf(
    const Squares& squares, const std::vector<T>& values, T unknown, F&& bits)
{
  std::vector<uint32_t> numbers;
  numbers.reserve(squares.cells.size());
  for (const size_t place : squares.cells)
  {
    numbers.push_back(bits(place == kNoCell ? unknown : values[place]));
  }
  return numbers;
}

Json encoded(const char* type, double base, const std::string& bytes)
{
  return {{"type", type}, {"base", base}, {"data", base64(deflated(bytes))}};
}

Json encode(const Squares& squares, const std::vector<uint8_t>& values)
{
  std::string bytes;
  bytes.reserve(squares.cells.size());
  for (const size_t place : squares.cells)
  {
    bytes += static_cast<char>(place == kNoCell ? uint8_t{0} : values[place]);
  }
  return encoded("u8", 0, bytes);
}

Json encode(const Squares& squares, const std::vector<uint32_t>& values)
{
  const auto same = [](uint32_t value) { return value; };
  return encoded("u32", 0, planes(numbersOf(squares, values, uint32_t{0}, same), 0));
}

Json encode(const Squares& squares, const std::vector<float>& values)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  return encoded("f24", 0, planes(numbersOf(squares, values, nan, roundedBits), 1));
}

Json encode(const Squares& squares, const std::vector<double>& values)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  double base = std::numeric_limits<double>::infinity();
  for (const double value : values)
  {
    base = std::isfinite(value) ? std::min(base, std::floor(value)) : base;
  }
  base = std::isfinite(base) ? base : 0;
  const auto above = [&](double value)
  {
    return std::bit_cast<uint32_t>(
        std::isnan(value) ? std::bit_cast<float>(0x7FC00000U) : static_cast<float>(value - base));
  };
  return encoded("f32", base, planes(numbersOf(squares, values, nan, above), 0));
}

Json layersOf(const layers::LayerSet& set, const Squares& squares, size_t& bytes)
{
  Json all = Json::array();
  for (const layers::Layer& layer : set.layers)
  {
    Json json = {{"name", layer.name}, {"unit", layer.unit}};
    json.update(
        std::visit([&](const auto& values) { return encode(squares, values); }, layer.data));
    bytes += json["data"].get_ref<const std::string&>().size();
    all.push_back(std::move(json));
  }
  return all;
}

/** x and y in m to the centimetre, so many that a page bears them. */
Json pathOf(std::span<const std::array<double, 3>> trajectory_m)
{
  constexpr size_t kMost = 4000;
  const size_t stride = trajectory_m.size() / kMost + 1;
  Json path = Json::array();
  const auto put = [&](const std::array<double, 3>& p)
  {
    for (const double metres : {p[0], p[1]})
    {
      path.push_back(std::round(metres * 100) / 100);
    }
  };
  for (size_t i = 0; i < trajectory_m.size(); i += stride)
  {
    put(trajectory_m[i]);
  }
  if (!trajectory_m.empty())
  {
    put(trajectory_m.back());
  }
  return path;
}

Json legendOf(const layers::LayerSet& set)
{
  Json legend = Json::array();
  for (const layers::LegendEntry& entry : set.legend)
  {
    legend.push_back({entry.code, entry.name, cssColour(entry.colour)});
  }
  return legend;
}

Json head(const layers::LayerSet& set, const Squares& squares)
{
  return {{"cell_mm", set.lattice.cell_mm}, {"x", squares.corner.x},  {"y", squares.corner.y},
          {"step", squares.step},           {"width", squares.width}, {"height", squares.height},
          {"class", set.class_layer},       {"legend", legendOf(set)}};
}

std::string captionOf(const layers::LayerSet& set, const Squares& squares)
{
  if (squares.step == 1)
  {
    return fmt::format("Cells of {} m.", set.lattice.cell_m());
  }
  return fmt::format(
      "The map is too large for a page: a square of {0} x {0} cells of {1} m shows one of them, of "
      "the highest class code. The GeoTIFFs have all cells.",
      squares.step, set.lattice.cell_m());
}
}  // namespace

LayerMap layerMap(
    const layers::LayerSet& set,
    std::span<const std::array<double, 3>> trajectory_m,
    const LayerMapLimits& limits)
{
  const std::vector<size_t> known = knownCells(set);
  const geometry::CellRect bounds = boundsOf(set, known);
  if (known.empty())
  {
    return {"No cell of the map is known.", ""};
  }
  for (int32_t step = 1;; step *= 2)
  {
    const size_t count = squaresAlong(bounds.width(), step) * squaresAlong(bounds.height(), step);
    if (count > limits.cells && count > 1)
    {
      continue;
    }
    const Squares squares = squaresOf(set, known, bounds, step);
    size_t bytes = 0;
    Json layers = layersOf(set, squares, bytes);
    if (bytes <= limits.bytes || count == 1)
    {
      Json json = head(set, squares);
      json["path"] = pathOf(trajectory_m);
      json["layers"] = std::move(layers);
      return {captionOf(set, squares), json.dump(-1, ' ', true, Json::error_handler_t::replace)};
    }
  }
}
}  // namespace traverse::formats
