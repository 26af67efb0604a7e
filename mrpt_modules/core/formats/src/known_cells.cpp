// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "known_cells.h"

#include <algorithm>
#include <fmt/format.h>
#include <set>
#include <stdexcept>

namespace traverse::formats
{
namespace
{
char lower(char c)
{
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool plain(char c)
{
  return (c >= '0' && c <= '9') || (lower(c) >= 'a' && lower(c) <= 'z') || c == '_';
}

std::string lowered(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), lower);
  return text;
}
}  // namespace

void checkSizes(const layers::LayerSet& set)
{
  for (const layers::Layer& layer : set.layers)
  {
    const size_t cells = std::visit([](const auto& values) { return values.size(); }, layer.data);
    if (cells != (set.extent.empty() ? 0 : set.size()))
    {
      throw std::invalid_argument(fmt::format(
          "layer '{}': {} cells for an extent of {} x {}", layer.name, cells, set.extent.width(),
          set.extent.height()));
    }
  }
}

std::vector<size_t> knownCells(const layers::LayerSet& set)
{
  checkSizes(set);
  std::vector<bool> known(set.extent.empty() ? 0 : set.size());
  for (const layers::Layer& layer : set.layers)
  {
    std::visit(
        [&](const auto& values)
        {
          for (size_t i = 0; i < values.size(); ++i)
          {
            known[i] = known[i] || isKnown(values[i]);
          }
        },
        layer.data);
  }
  std::vector<size_t> places;
  for (size_t i = 0; i < known.size(); ++i)
  {
    if (known[i])
    {
      places.push_back(i);
    }
  }
  return places;
}

geometry::CellIndex cellAt(const layers::LayerSet& set, size_t place)
{
  const auto width = static_cast<size_t>(set.extent.width());
  return {
      set.extent.min.x + static_cast<int32_t>(place % width),
      set.extent.min.y + static_cast<int32_t>(place / width)};
}

CellHeight::CellHeight(const layers::LayerSet& set)
{
  for (const char* name : {"height_mean", "ground_height", "height"})
  {
    const layers::Layer* layer = set.find(name);
    const auto* values = layer == nullptr ? nullptr : std::get_if<std::vector<float>>(&layer->data);
    if (values != nullptr)
    {
      sources_.push_back(values);
    }
  }
}

double CellHeight::at(size_t place) const
{
  for (const std::vector<float>* source : sources_)
  {
    if (std::isfinite((*source)[place]))
    {
      return (*source)[place];
    }
  }
  return 0;
}

CellClass::CellClass(const layers::LayerSet& set)
{
  const layers::Layer* layer = set.find(set.class_layer);
  codes_ = layer == nullptr ? nullptr : std::get_if<std::vector<uint8_t>>(&layer->data);
  constexpr layers::Colour kGrey = {128, 128, 128};
  entries_.fill({0, "", kGrey});
  for (const layers::LegendEntry& entry : set.legend)
  {
    entries_[entry.code] = entry;
  }
}

std::vector<std::string> fieldNames(
    const layers::LayerSet& set, const std::vector<std::string>& reserved)
{
  constexpr size_t kMostCharacters = 60;
  std::set<std::string> taken(reserved.begin(), reserved.end());
  std::vector<std::string> names;
  names.reserve(set.layers.size());
  for (const layers::Layer& layer : set.layers)
  {
    std::string name = layer.name.empty() ? "layer" : layer.name.substr(0, kMostCharacters);
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !plain(c); }, '_');
    const std::string stem = name;
    for (int i = 2; !taken.insert(lowered(name)).second; ++i)
    {
      name = fmt::format("{}_{}", stem, i);
    }
    names.push_back(name);
  }
  return names;
}
}  // namespace traverse::formats
