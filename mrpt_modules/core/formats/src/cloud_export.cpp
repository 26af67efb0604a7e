// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "known_cells.h"

#include <traverse/formats/bytes.h>
#include <traverse/formats/cloud_export.h>

#include <fmt/format.h>

namespace traverse::formats
{
namespace
{
/** A type's name in PLY, its letter in PCD. */
struct FieldType
{
  const char* ply;
  char pcd;
  size_t bytes;
};

FieldType typeOf(const layers::Layer& layer)
{
  constexpr FieldType kTypes[] = {
      {"uchar", 'U', 1}, {"uint", 'U', 4}, {"float", 'F', 4}, {"double", 'F', 8}};
  return kTypes[layer.data.index()];
}

std::string plyHeader(const layers::LayerSet& set, size_t points)
{
  std::string header = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment cells of {} m, a point each; metres of the "
      "map frame\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\n"
      "property int cell_x\nproperty int cell_y\n",
      set.lattice.cell_m(), points);
  const auto names = fieldNames(set, {"x", "y", "z", "red", "green", "blue", "cell_x", "cell_y"});
  for (size_t k = 0; k < names.size(); ++k)
  {
    header += fmt::format("property {} {}\n", typeOf(set.layers[k]).ply, names[k]);
  }
  return header + "end_header\n";
}

std::string pcdHeader(const layers::LayerSet& set, size_t points)
{
  std::string fields = "x y z rgb cell_x cell_y";
  std::string sizes = "4 4 4 4 4 4";
  std::string types = "F F F U I I";
  std::string counts = "1 1 1 1 1 1";
  const auto names = fieldNames(set, {"x", "y", "z", "rgb", "cell_x", "cell_y", "_"});
  for (size_t k = 0; k < names.size(); ++k)
  {
    const FieldType type = typeOf(set.layers[k]);
    fields += " " + names[k];
    sizes += fmt::format(" {}", type.bytes);
    types += fmt::format(" {}", type.pcd);
    counts += " 1";
  }
  return fmt::format(
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS {}\nSIZE {}\nTYPE {}\n"
      "COUNT {}\nWIDTH {}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {}\nDATA binary\n",
      fields, sizes, types, counts, points, points);
}

void putLayers(ByteWriter& out, const layers::LayerSet& set, size_t place)
{
  for (const layers::Layer& layer : set.layers)
  {
    std::visit(
        [&](const auto& values)
        {
          const auto value = values[place];
          out.raw({reinterpret_cast<const char*>(&value), sizeof value});
        },
        layer.data);
  }
}
}  // namespace

std::string plyCloud(const layers::LayerSet& set)
{
  const std::vector<size_t> places = knownCells(set);
  const CellHeight height(set);
  const CellClass classes(set);
  ByteWriter out;
  out.raw(plyHeader(set, places.size()));
  for (const size_t place : places)
  {
    const geometry::CellIndex cell = cellAt(set, place);
    const layers::Colour colour = classes.entry(classes.at(place)).colour;
    out.f64(set.lattice.centre_m(cell.x));
    out.f64(set.lattice.centre_m(cell.y));
    out.f64(height.at(place));
    out.u8(colour.r);
    out.u8(colour.g);
    out.u8(colour.b);
    out.i32(cell.x);
    out.i32(cell.y);
    putLayers(out, set, place);
  }
  return out.take();
}

std::string pcdCloud(const layers::LayerSet& set)
{
  const std::vector<size_t> places = knownCells(set);
  const CellHeight height(set);
  const CellClass classes(set);
  ByteWriter out;
  out.raw(pcdHeader(set, places.size()));
  for (const size_t place : places)
  {
    const geometry::CellIndex cell = cellAt(set, place);
    const layers::Colour colour = classes.entry(classes.at(place)).colour;
    out.f32(static_cast<float>(set.lattice.centre_m(cell.x)));
    out.f32(static_cast<float>(set.lattice.centre_m(cell.y)));
    out.f32(static_cast<float>(height.at(place)));
    out.u32((uint32_t{colour.r} << 16U) | (uint32_t{colour.g} << 8U) | colour.b);
    out.i32(cell.x);
    out.i32(cell.y);
    putLayers(out, set, place);
  }
  return out.take();
}
}  // namespace traverse::formats
