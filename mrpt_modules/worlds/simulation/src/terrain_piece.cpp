// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "terrain_piece.h"

#include "refuse.h"
#include "terrain_usual.h"
#include "value_noise.h"

#include <traverse/geometry/exact_trig.h>

#include <algorithm>
#include <cmath>

namespace traverse::simulation
{
namespace
{
constexpr double kEndless_m = 1e6;
constexpr double kMargin_m = 1e-6;  // for rounding
constexpr double kUsualGroove_m = 0.22;

double orUsual(double value, double usual)
{
  return value > 0 ? value : usual;
}

template <class T>
std::optional<T> orUsual(const std::optional<T>& usual, bool is_usual, T chosen)
{
  return is_usual ? usual : std::optional<T>(chosen);
}

/** The line of a strip without corners. Endless ones go both ways where there is no direction in
 * which they must begin. */
std::vector<Segment> straightLine(const TerrainParams& p)
{
  const auto [s, c] = geometry::sinCosOf(p.yaw_deg * (geometry::kPi / 180));
  const double length_m = p.length_m > 0 ? p.length_m : kEndless_m;
  return {{Eigen::Vector2d(p.x_m, p.y_m), Eigen::Vector2d(c, s), length_m, 0}};
}

/** Hills and the like without length and width are everywhere. */
bool isEndless(const TerrainParams& p)
{
  const bool may = p.kind == TerrainKind::hills || p.kind == TerrainKind::roughness ||
                   p.kind == TerrainKind::raster;
  return may && p.xs_m.empty() && p.length_m == 0 && p.width_m == 0;
}

/** Whether the 25 cm of a coarse mesh lose it. */
bool needsFineMesh(const TerrainParams& p)
{
  switch (p.kind)
  {
    case TerrainKind::hills:
    case TerrainKind::road:
    case TerrainKind::raster:
      return false;
    case TerrainKind::ramp:
      return p.width_m > 0;
    case TerrainKind::roughness:
      return p.wavelength_m < 0.4 && p.height_m > 0.004;
    default:
      return true;
  }
}
}  // namespace

TerrainPiece::TerrainPiece(const TerrainParams& params, const SceneParams& scene) : params_(params)
{
  options::check(params);
  const UsualTerrain usual = usualTerrain(params.kind);
  params_.length_m = orUsual(params.length_m, usual.length_m);
  params_.width_m = orUsual(params.width_m, usual.width_m);
  params_.height_m = orUsual(params.height_m, usual.height_m);
  params_.edge_m = std::max(1e-4, orUsual(params.edge_m, usual.edge_m));
  params_.groove_m = orUsual(params.groove_m, kUsualGroove_m);
  params_.wavelength_m = std::max(0.01, orUsual(params.wavelength_m, usual.wavelength_m));
  material_ = orUsual(
      usual.material, params.material == MaterialChoice::usual,
      chosenOr(params.material, Material::soil));
  label_ = orUsual(
      usual.label, params.label == LabelChoice::usual, chosenOr(params.label, Label::ground));
  round_ = params_.kind == TerrainKind::hole && params_.length_m == 0;
  if (round_)
  {
    line_ = {{Eigen::Vector2d(params_.x_m, params_.y_m), Eigen::Vector2d::UnitX(), 0, 0}};
  }
  else if (!isEndless(params_))
  {
    const bool bends = !params_.xs_m.empty() || !params_.ys_m.empty();
    line_ = bends ? lineThrough(params_.xs_m, params_.ys_m, "xs_m, ys_m") : straightLine(params_);
    line_m_ = lengthOf(line_);
  }
  half_m_ = params_.width_m > 0 ? params_.width_m / 2 : kEndless_m;
  if (params_.kind == TerrainKind::ruts)
  {
    half_m_ += params_.groove_m / 2;
  }
  sharp_ = needsFineMesh(params_);
  flat_inside_ = params_.kind == TerrainKind::kerb || params_.kind == TerrainKind::step ||
                 params_.kind == TerrainKind::ditch || params_.kind == TerrainKind::hole;
  // each its own axes, so that two lattices of random heights do not lie on each other
  const auto [s, c] = geometry::sinCosOf(0.3 + 0.7 * (params_.seed % 97));
  turned_ = Eigen::Vector2d(c, s) / params_.wavelength_m;
  if (params_.kind == TerrainKind::raster)
  {
    raster_ = loadRaster(params_, scene);
  }
}

TerrainPiece::Inside TerrainPiece::insideOf(
    const Eigen::Vector2d& place, std::span<const Segment> near) const
{
  if (line_.empty())
  {
    return {kEndless_m, {}};
  }
  const AlongLine where = alongLine(near, line_m_, place);
  if (round_)
  {
    return {half_m_ - std::sqrt(where.square_m2), where};
  }
  const double from_end = std::min(where.along_m, line_m_ - where.along_m);
  return {std::min(half_m_ - std::abs(where.left_m), from_end), where};
}

bool TerrainPiece::isSharpIn(const Area& area) const
{
  if (!sharp_ || isEverywhere())
  {
    return sharp_;
  }
  const bool meets = std::any_of(
      line_.begin(), line_.end(),
      [&](const Segment& s) { return mayReach(s, half_m_ + kMargin_m, area); });
  if (!meets || !flat_inside_)
  {
    return meets;
  }
  const double half_x = (area.max_x_m - area.min_x_m) / 2;
  const double half_y = (area.max_y_m - area.min_y_m) / 2;
  const Eigen::Vector2d middle(area.min_x_m + half_x, area.min_y_m + half_y);
  const double radius = std::sqrt(half_x * half_x + half_y * half_y);
  return insideOf(middle, line_).border_m < params_.edge_m + radius + kMargin_m;
}

double TerrainPiece::sides(double border_m) const
{
  return std::clamp(border_m / params_.edge_m, 0.0, 1.0);
}

double TerrainPiece::noise(const Eigen::Vector2d& place) const
{
  const double x = place.x() * turned_.x() + place.y() * turned_.y();
  const double y = place.y() * turned_.x() - place.x() * turned_.y();
  return valueNoise(x, y, static_cast<uint64_t>(params_.seed));
}

void TerrainPiece::paint(GroundSum& sum) const
{
  sum.material = material_.value_or(sum.material);
  sum.label = label_.value_or(sum.label);
}

void TerrainPiece::addRuts(GroundSum& sum, const AlongLine& where) const
{
  const double beside = std::abs(std::abs(where.left_m) - params_.width_m / 2);
  const double from_end = std::min(where.along_m, line_m_ - where.along_m);
  const double border = std::min(params_.groove_m / 2 - beside, from_end);
  if (border > 0)
  {
    sum.bumps_m -= params_.height_m * sides(border);
    paint(sum);
  }
}

void TerrainPiece::addBank(GroundSum& sum, const Eigen::Vector2d& place, double border_m) const
{
  const double top = 1 - 0.25 * (0.5 + 0.5 * noise(place));
  sum.bumps_m += params_.height_m * top * sides(border_m);
  paint(sum);
}

void TerrainPiece::add(
    GroundSum& sum, const Eigen::Vector2d& place, std::span<const Segment> near) const
{
  const auto [border, where] = insideOf(place, near);
  const bool on_top = params_.kind == TerrainKind::ramp && half_m_ == kEndless_m &&
                      where.along_m > line_m_;  // a ramp without a width leads up to a plain
  if (!(border > 0) && !on_top)
  {
    return;
  }
  switch (params_.kind)
  {
    case TerrainKind::ruts:
      return addRuts(sum, where);
    case TerrainKind::bank:
      return addBank(sum, place, border);
    case TerrainKind::hills:
      sum.base_m += params_.height_m * noise(place) * sides(border);
      break;
    case TerrainKind::roughness:
      sum.rough_m += params_.height_m * noise(place) * sides(border);
      break;
    case TerrainKind::ramp:
      sum.base_m += params_.height_m * std::min(1.0, where.along_m / line_m_);
      break;
    case TerrainKind::kerb:
      sum.rough_m = 0;
      [[fallthrough]];
    case TerrainKind::step:
      sum.base_m += params_.height_m * sides(border);
      break;
    case TerrainKind::road:
      sum.rough_m = 0;
      sum.base_m += params_.height_m * (1 - where.left_m * where.left_m / (half_m_ * half_m_));
      break;
    case TerrainKind::ditch:
    case TerrainKind::hole:
      sum.ditch_m = std::max(sum.ditch_m, params_.height_m * sides(border));
      break;
    case TerrainKind::raster:
      sum.base_m += raster_->at(place.x(), place.y());
      break;
  }
  paint(sum);
}
}  // namespace traverse::simulation
