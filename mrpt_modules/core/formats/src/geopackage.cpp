// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gdal_memory.h"
#include "html_text.h"
#include "known_cells.h"

#include <traverse/formats/bytes.h>
#include <traverse/formats/geopackage.h>

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_string.h>
#include <fmt/format.h>
#include <ogrsf_frmts.h>

namespace traverse::formats
{
namespace
{
[[noreturn]] void refuse()
{
  throw FormatError(fmt::format("GeoPackage: {}", CPLGetLastErrorMsg()));
}

void orRefuse(bool good)
{
  if (!good)
  {
    refuse();
  }
}

/** gpkg_contents wants to know when it was changed: always then, for this scope and thread. */
struct NoClock
{
  NoClock() { CPLSetThreadLocalConfigOption("OGR_CURRENT_DATE", "2000-01-01T00:00:00.000Z"); }

  ~NoClock() { CPLSetThreadLocalConfigOption("OGR_CURRENT_DATE", nullptr); }

  NoClock(const NoClock&) = delete;
  NoClock& operator=(const NoClock&) = delete;
};

enum Field : int
{
  kCellX,
  kCellY,
  kClassName,
  kColour,
  kFirstLayer
};

OGRLayer& createTable(GDALDataset& dataset, const char* name, OGRwkbGeometryType type)
{
  OGRSpatialReference reference;
  orRefuse(setMapFrame(reference));
  OGRLayer* table = dataset.CreateLayer(name, &reference, type, nullptr);
  orRefuse(table != nullptr);
  return *table;
}

void addField(OGRLayer& table, OGRFieldDefn&& field)
{
  orRefuse(table.CreateField(&field) == OGRERR_NONE);
}

/** In the order of Field. */
void addFields(OGRLayer& table, const layers::LayerSet& set)
{
  addField(table, OGRFieldDefn("cell_x", OFTInteger));
  addField(table, OGRFieldDefn("cell_y", OFTInteger));
  addField(table, OGRFieldDefn("class_name", OFTString));
  addField(table, OGRFieldDefn("colour", OFTString));
  const auto names =
      fieldNames(set, {"fid", "geom", "cell_x", "cell_y", "class_name", "colour", "rowid", "oid"});
  for (size_t k = 0; k < names.size(); ++k)
  {
    const layers::Layer& layer = set.layers[k];
    const bool whole = layer.data.index() < 2;
    OGRFieldDefn field(names[k].c_str(), whole ? OFTInteger64 : OFTReal);
    if (std::holds_alternative<std::vector<float>>(layer.data))
    {
      field.SetSubType(OFSTFloat32);
    }
    addField(table, std::move(field));
  }
}

OGRPolygon square(const geometry::Lattice& lattice, geometry::CellIndex cell)
{
  const double x0 = lattice.edge_m(cell.x);
  const double y0 = lattice.edge_m(cell.y);
  const double x1 = lattice.edge_m(cell.x + 1);
  const double y1 = lattice.edge_m(cell.y + 1);
  OGRLinearRing ring;
  ring.addPoint(x0, y0);
  ring.addPoint(x1, y0);
  ring.addPoint(x1, y1);
  ring.addPoint(x0, y1);
  ring.closeRings();
  OGRPolygon polygon;
  polygon.addRing(&ring);
  return polygon;
}

void setValue(OGRFeature& feature, int field, const layers::Layer& layer, size_t place)
{
  std::visit(
      [&](const auto& values)
      {
        const auto value = values[place];
        if constexpr (std::is_integral_v<decltype(value)>)
        {
          feature.SetField(field, static_cast<GIntBig>(value));
        }
        else if (std::isnan(value))
        {
          feature.SetFieldNull(field);
        }
        else
        {
          feature.SetField(field, static_cast<double>(value));
        }
      },
      layer.data);
}

void addCells(GDALDataset& dataset, const layers::LayerSet& set)
{
  OGRLayer& table = createTable(dataset, "cells", wkbPolygon);
  addFields(table, set);
  const CellClass classes(set);
  OGRFeature feature(table.GetLayerDefn());
  for (const size_t place : knownCells(set))
  {
    const geometry::CellIndex cell = cellAt(set, place);
    const layers::LegendEntry& entry = classes.entry(classes.at(place));
    const OGRPolygon outline = square(set.lattice, cell);
    feature.SetFID(OGRNullFID);
    feature.SetField(kCellX, cell.x);
    feature.SetField(kCellY, cell.y);
    feature.SetField(kClassName, entry.name.c_str());
    feature.SetField(kColour, cssColour(entry.colour).c_str());
    for (size_t k = 0; k < set.layers.size(); ++k)
    {
      setValue(feature, kFirstLayer + static_cast<int>(k), set.layers[k], place);
    }
    orRefuse(
        feature.SetGeometry(&outline) == OGRERR_NONE &&
        table.CreateFeature(&feature) == OGRERR_NONE);
  }
}

void addTrajectory(GDALDataset& dataset, std::span<const std::array<double, 3>> trajectory_m)
{
  OGRLayer& table = createTable(dataset, "trajectory", wkbLineString25D);
  OGRLineString line;
  for (const auto& p : trajectory_m)
  {
    line.addPoint(p[0], p[1], p[2]);
  }
  OGRFeature feature(table.GetLayerDefn());
  orRefuse(
      feature.SetGeometry(&line) == OGRERR_NONE && table.CreateFeature(&feature) == OGRERR_NONE);
}
}  // namespace

std::string geoPackage(
    const layers::LayerSet& set, std::span<const std::array<double, 3>> trajectory_m)
{
  checkSizes(set);
  const QuietGdal quiet;
  const NoClock no_clock;
  const MemoryFile file(".gpkg");
  Dataset dataset(gdalDriver("GPKG").Create(file.path(), 0, 0, 0, GDT_Unknown, nullptr));
  orRefuse(dataset != nullptr && dataset->StartTransaction() == OGRERR_NONE);
  addCells(*dataset, set);
  if (trajectory_m.size() > 1)
  {
    addTrajectory(*dataset, trajectory_m);
  }
  orRefuse(dataset->CommitTransaction() == OGRERR_NONE);
  dataset.reset();  // writes the rest; its only word about failure is the last error
  orRefuse(!quiet.failed());
  return file.take();
}
}  // namespace traverse::formats
