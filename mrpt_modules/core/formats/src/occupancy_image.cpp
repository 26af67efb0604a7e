// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/occupancy_image.h>
#include <traverse/formats/safe_file.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

namespace traverse::formats
{
namespace
{
constexpr uint8_t kOccupied = 0;
constexpr uint8_t kUnknown = 205;
constexpr uint8_t kFree = 254;
constexpr double kWhite = 255;
constexpr double kHighestIndex = 100;
constexpr double kUnknownIndex = 50;

struct Thresholds
{
  const char* mode;
  double occupied;
  double free;
};

void check(const layers::LayerSet& set, size_t cells, const std::string& pgm_name)
{
  if (set.extent.empty() || cells != set.size())
  {
    throw std::invalid_argument("occupancy image: no cells, or not as many as the extent has");
  }
  if (safeFileName(pgm_name) != pgm_name)
  {
    throw std::invalid_argument("occupancy image: not a plain file name: '" + pgm_name + "'");
  }
}

std::string yaml(const layers::LayerSet& set, const std::string& pgm_name, const Thresholds& t)
{
  // Millimetres are written out whole: exact, and the same in every locale.
  return fmt::format(
      "image: {}\nmode: {}\nresolution: {:.3f}\norigin: [{:.3f}, {:.3f}, 0.0]\nnegate: 0\n"
      "occupied_thresh: {}\nfree_thresh: {}\n",
      pgm_name, t.mode, set.lattice.cell_m(), set.lattice.edge_m(set.extent.min.x),
      set.lattice.edge_m(set.extent.min.y), t.occupied, t.free);
}

/** grey_of(i) is the pixel of cell i. */
template <class F>
std::string pgm(const layers::LayerSet& set, F&& grey_of)
{
  const auto width = static_cast<size_t>(set.extent.width());
  const auto height = static_cast<size_t>(set.extent.height());
  std::string bytes = fmt::format("P5\n{} {}\n255\n", width, height);
  bytes.reserve(bytes.size() + set.size());
  for (size_t row = height; row-- > 0;)
  {
    for (size_t column = 0; column < width; ++column)
    {
      bytes += static_cast<char>(grey_of(row * width + column));
    }
  }
  return bytes;
}

/** NaN, and what is no index at all, is unknown. */
uint8_t greyOfIndex(double index)
{
  const double known = index >= 0 && index <= kHighestIndex ? index : kUnknownIndex;
  return static_cast<uint8_t>(std::lround(kWhite * (1 - known / kHighestIndex)));
}
}  // namespace

OccupancyImage occupancyOfClasses(
    const layers::LayerSet& set, const std::string& pgm_name, const OccupancyMeaning& meaning)
{
  const layers::Layer* layer = set.find(set.class_layer);
  const auto* codes = layer == nullptr ? nullptr : std::get_if<std::vector<uint8_t>>(&layer->data);
  check(set, codes == nullptr ? 0 : codes->size(), pgm_name);
  std::array<uint8_t, 256> grey{};
  grey.fill(kFree);
  std::for_each(
      meaning.occupied.begin(), meaning.occupied.end(), [&](uint8_t c) { grey[c] = kOccupied; });
  std::for_each(
      meaning.unknown.begin(), meaning.unknown.end(), [&](uint8_t c) { grey[c] = kUnknown; });
  return {
      pgm(set, [&](size_t i) { return grey[(*codes)[i]]; }),
      yaml(set, pgm_name, {"trinary", 0.65, 0.196})};
}

OccupancyImage occupancyOfIndex(
    const layers::LayerSet& set, const layers::Layer& index, const std::string& pgm_name)
{
  const layers::Layer* classes = set.find(set.class_layer);
  const auto* codes =
      classes == nullptr ? nullptr : std::get_if<std::vector<uint8_t>>(&classes->data);
  // map_server: 99 (p - free) / (occupied - free) between the two, 100 above: with 0 and 0.99 that
  // is the index.
  return std::visit(
      [&](const auto& cells) -> OccupancyImage
      {
        check(set, cells.size(), pgm_name);
        const bool with_classes = codes != nullptr && codes->size() == cells.size();
        const auto grey_of = [&](size_t i)
        {
          const bool undefined = with_classes && (*codes)[i] == 0;
          return greyOfIndex(undefined ? kUnknownIndex : static_cast<double>(cells[i]));
        };
        return {pgm(set, grey_of), yaml(set, pgm_name, {"scale", 0.99, 0.0})};
      },
      index.data);
}
}  // namespace traverse::formats
