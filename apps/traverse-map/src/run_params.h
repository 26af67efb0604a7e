// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/options/option.h>

#include <string>

namespace traverse::app
{
/** Section [traverse-map]. */
struct RunParams
{
  std::string rawlog;
  std::string output;
  std::string title;
  bool deskew = true;
  int threads = 2;
  int max_scans = 0;
  double snapshot_every_s = 0;
  bool snapshot_classes = false;
  bool pictures = true;
  int picture_width_px = 1200;
  bool scene = true;
  bool export_ply = false;
  bool export_pcd = false;
  bool export_geopackage = false;
};

template <class P, class F>
void visitRunParams(P& p, F&& f)
{
  using options::Option;
  f(Option{"rawlog", "the log to read; relative names start at the ini's folder"}, p.rawlog);
  f(Option{"output", "the folder to write; relative names start at the working folder"}, p.output);
  f(Option{"title", "headline of the report; empty: the log's name"}, p.title);
  f(Option{"deskew", "place every point with the pose at its own time"}, p.deskew);
  f(
      Option{
          "threads",
          "1: one thing after the other; 2: reading and deskewing run ahead of the maps; each more "
          "lets one more map take the scan at the same time. The results are the same",
          {1, 64}},
      p.threads);
  f(Option{"max_scans", "stop after so many scans; 0 = all", {0, 1e9}}, p.max_scans);
  f(
      Option{
          "snapshot_every_s",
          "a picture of the map every so many seconds of the log; 0 = only at the end",
          {0, 1e6}},
      p.snapshot_every_s);
  f(
      Option{
          "snapshot_classes",
          "with snapshot_every_s: the classes of the cells, too, as snapshot_NNNN_class.tif with "
          "its time in metrics.json, for traverse-evaluate"},
      p.snapshot_classes);
  f(Option{"pictures", "write pictures (map_top.png, map_3d.png, snapshots)"}, p.pictures);
  f(Option{"picture_width_px", "width of pictures, pixels", {200, 4096}}, p.picture_width_px);
  f(Option{"scene", "write the 3-D view for SceneViewer3D (map.3Dscene)"}, p.scene);
  f(Option{"export_ply", "write all layers as a point per cell (map.ply)"}, p.export_ply);
  f(Option{"export_pcd", "the same for PCL (map.pcd)"}, p.export_pcd);
  f(
      Option{
          "export_geopackage",
          "write all layers as a table of cells, and the trajectory, for QGIS (map.gpkg)"},
      p.export_geopackage);
}

template <class F>
void visit(RunParams& p, F&& f)
{
  visitRunParams(p, f);
}

template <class F>
void visit(const RunParams& p, F&& f)
{
  visitRunParams(p, f);
}
}  // namespace traverse::app
