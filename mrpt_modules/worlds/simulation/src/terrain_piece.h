// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "raster.h"
#include "strip.h"

#include <traverse/simulation/scene_params.h>

#include <memory>
#include <optional>
#include <span>

namespace traverse::simulation
{
/** The heights of a place while the pieces are added. */
struct GroundSum
{
  double base_m = 0;
  double rough_m = 0;  //!< fine roughness; a road takes it away
  double bumps_m = 0;  //!< banks up, ruts down
  double ditch_m = 0;
  Material material = Material::soil;
  Label label = Label::ground;
};

/** One [Terrain_NN], ready for use. */
class TerrainPiece
{
 public:
  /** Throws OptionError. */
  TerrainPiece(const TerrainParams& params, const SceneParams& scene);

  /** Its line; empty where it is everywhere, or round (hole). */
  const std::vector<Segment>& line() const { return line_; }

  /** How far from its line it changes something. */
  double reach_m() const { return half_m_; }

  bool isEverywhere() const { return line_.empty(); }

  /** True where a mesh of 25 cm may lose something of it in the area. */
  bool isSharpIn(const Area& area) const;

  /** The ground looks otherwise there. */
  bool paints() const { return material_ || label_; }

  /** `near`: those pieces of its line that may be in reach. */
  void add(GroundSum& sum, const Eigen::Vector2d& place, std::span<const Segment> near) const;

 private:
  /** How far inside its border a place is, and where. */
  struct Inside
  {
    double border_m = 0;
    AlongLine where;
  };

  Inside insideOf(const Eigen::Vector2d& place, std::span<const Segment> near) const;
  double sides(double border_m) const;
  double noise(const Eigen::Vector2d& place) const;
  void addRuts(GroundSum& sum, const AlongLine& where) const;
  void addBank(GroundSum& sum, const Eigen::Vector2d& place, double border_m) const;
  void paint(GroundSum& sum) const;

  TerrainParams params_;
  std::vector<Segment> line_;
  double line_m_ = 0;
  double half_m_ = 0;
  bool sharp_ = false;
  bool round_ = false;
  bool flat_inside_ = false;                           //!< only its border is sharp
  Eigen::Vector2d turned_ = Eigen::Vector2d::UnitX();  //!< axis of its noise, 1/m
  std::optional<Material> material_;
  std::optional<Label> label_;
  std::shared_ptr<const Raster> raster_;
};
}  // namespace traverse::simulation
