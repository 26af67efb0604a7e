// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "explain_text.h"

#include <traverse/traversability_grid/explain.h>
#include <traverse/traversability_grid/traversability_grid.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>

namespace traverse::traversability_grid
{
namespace
{
using Facts = std::vector<layers::Fact>;

/** One feature against its limits. */
struct Measured
{
  std::string_view key;  //!< of the value, and the end of its limits' keys
  double value;
  Class alone;  //!< the class if the other features were 0
  std::array<double, 3> limits;
};

std::array<Measured, 3> measured(const Features& f, const Params& p)
{
  // Limits rise from class to class, so a cell's class is the worst of its features' own ones; each
  // is asked of the classifier itself, so that the two cannot disagree.
  // The sensor's noise that classifier = default takes off goes with it.
  const Classifier classify(p);
  Features only_deviation = f;
  Features only_slope = f;
  Features only_variance = f;
  only_deviation.variance_m2 = only_slope.variance_m2 = 0;
  only_slope.deviation_m = only_variance.deviation_m = 0;
  for (Features* flat : {&only_deviation, &only_variance})
  {
    flat->has_plane = true;
    flat->slope_x = flat->slope_y = 0;
  }
  return {
      Measured{
          "deviation_m",
          f.deviation_m,
          classify(only_deviation),
          {p.flat.deviation_m, p.small_roughness.deviation_m, p.large_roughness.deviation_m}},
      Measured{
          "slope_deg",
          f.slope_deg(),
          classify(only_slope),
          {p.flat.slope_deg, p.small_roughness.slope_deg, p.large_roughness.slope_deg}},
      Measured{
          "variance_m2",
          f.variance_m2,
          classify(only_variance),
          {p.flat.variance_m2, p.small_roughness.variance_m2, p.large_roughness.variance_m2}}};
}

constexpr std::array<std::string_view, 3> kPrefixes = {"flat_max_", "small_max_", "large_max_"};

/** The limit that was exceeded to become of this class (none for flat and undefined): its place. */
size_t exceededBy(Class of)
{
  return static_cast<size_t>(of) - static_cast<size_t>(Class::small_roughness);
}

/** Which option made the class of the cell by itself, with its value and the cell's. */
void explainLimits(Class of, const Features& f, const Params& params, Facts& facts)
{
  if (f.n < static_cast<uint64_t>(params.min_points))
  {
    facts.push_back(
        {"decided by", "points = " + std::to_string(f.n) +
                           ", below min_points = " + std::to_string(params.min_points)});
    return;
  }
  if (of == Class::undefined)
  {
    facts.push_back(
        {"decided by",
         "no plane fits (the points lie on a line seen from above), and deviation and variance "
         "alone make no obstacle"});
    return;
  }
  const std::array<Measured, 3> all = measured(f, params);
  for (const Measured& m : all)
  {
    if (of != Class::flat && m.alone == of)
    {
      const size_t exceeded = exceededBy(of);
      facts.push_back(
          {"decided by", std::string(m.key) + " = " + shortly(m.value) + ", above " +
                             std::string(kPrefixes.at(exceeded)) + std::string(m.key) + " = " +
                             options::format(m.limits.at(exceeded))});
    }
  }
  if (of == Class::flat)
  {
    facts.push_back({"decided by", "deviation, slope and variance are within all limits of flat"});
  }
}

/** What made the class where the ground around the cell had a part in it. */
void explainGround(
    const Cell& cell,
    const Features& f,
    const Params& params,
    const geometry::Vehicle& vehicle,
    Facts& facts)
{
  const double step_m = f.min_m - static_cast<double>(cell.ground_m);
  const std::string step =
      metres(std::abs(step_m)) + (step_m < 0 ? " below" : " above") + " the ground";
  if (cell.of == Class::undefined)
  {
    facts.push_back(
        {"decided by", "all points hang " + step + ": the vehicle of " + metres(vehicle.height_m) +
                           " fits under, and what it would drive on was not seen"});
    return;
  }
  const std::array<double, 3> limits = {
      params.flat.deviation_m, params.small_roughness.deviation_m,
      params.large_roughness.deviation_m};
  const size_t exceeded = exceededBy(cell.of);
  facts.push_back(
      {"decided by", "lowest point " + step + ", more than " + std::string(kPrefixes.at(exceeded)) +
                         "deviation_m = " + options::format(limits.at(exceeded))});
}

void explainFeatures(const Features& f, Facts& facts)
{
  facts.push_back({"points", std::to_string(f.n)});
  facts.push_back({"height mean", metres(f.mean_m)});
  facts.push_back({"height min", metres(f.min_m)});
  facts.push_back({"height max", metres(f.max_m)});
  facts.push_back({"deviation", shortly(f.deviation_m) + " m"});
  facts.push_back(
      {"slope", f.has_plane ? shortly(f.slope_deg()) + " deg" : std::string("no plane fits")});
  facts.push_back({"variance", shortly(f.variance_m2) + " m^2"});
  facts.push_back({"noise", shortly(std::sqrt(f.noise_m2)) + " m, standard deviation of heights"});
  facts.push_back({"last seen", seconds(f.last_seen)});
}

/** Why a slab is not among those that make the features; empty where it is. */
std::string leftOut(double min_m, double max_m, const Features& f, const geometry::Vehicle& vehicle)
{
  constexpr double kHalf_m = 0.0005;  // heights are whole millimetres
  if (max_m < f.min_m - kHalf_m)
  {
    return "; left out: far below the ground, a false return";
  }
  return min_m > f.max_m + kHalf_m ? "; left out: above a gap that the vehicle of " +
                                         metres(vehicle.height_m) + " fits under"
                                   : "";
}

void explainSlabs(
    const State& state,
    const layers::HeightSlab* lowest,
    const Features& f,
    const geometry::Vehicle& vehicle,
    Facts& facts)
{
  for (const auto* s = lowest; s != nullptr; s = state.slabs.get(s->next))
  {
    const double bottom_mm = static_cast<double>(s->level) * state.slab_mm;
    const auto height_m = [&](double above_mm)
    { return (bottom_mm + above_mm) / geometry::kMillimetresPerMetre; };
    facts.push_back(
        {"slab " + metres(height_m(0)) + " to " + metres(height_m(state.slab_mm)),
         "n = " + std::to_string(s->n) + ", min " + metres(height_m(s->min_z_mm)) + ", max " +
             metres(height_m(s->max_z_mm)) + ", last seen " + seconds(s->last_seen) +
             sensorsOf(state.sensors, s->seen_by) +
             leftOut(height_m(s->min_z_mm), height_m(s->max_z_mm), f, vehicle)});
  }
}

/** Class and index as the layers show them. */
Class explainClass(
    const State& state,
    const Params& params,
    const geometry::Vehicle& vehicle,
    geometry::CellIndex cell,
    Facts& facts)
{
  const layers::LayerSet set =
      layerSet(state, params, vehicle, geometry::CellRect{cell, {cell.x + 1, cell.y + 1}});
  const uint8_t code = std::get<std::vector<uint8_t>>(set.find(set.class_layer)->data).front();
  for (const layers::LegendEntry& entry : set.legend)
  {
    if (entry.code == code)
    {
      facts.push_back({"class", entry.name + " (" + std::to_string(code) + ")"});
    }
  }
  const float index = std::get<std::vector<float>>(set.find("traversability_index")->data).front();
  facts.push_back({"index", shortly(index)});
  return static_cast<Class>(code);
}

/** As Judge reads them: from near the ground upward where what lies lowest is a false return. */
Features featuresThatCount(
    const State& state, const Cell& cell, const Params& params, const geometry::Vehicle& vehicle)
{
  SlabReading reading = slabReading(state, params, vehicle);
  const layers::HeightSlab* lowest = state.slabs.get(cell.slabs);
  const Features all = featuresOf(state.slabs, lowest, reading);
  if (!(all.min_m < static_cast<double>(cell.ground_m - kFalseReturn_m)))  // also without a ground
  {
    return all;
  }
  reading.floor_mm = static_cast<int64_t>(
      std::floor(static_cast<double>(cell.ground_m - kFloor_m) * geometry::kMillimetresPerMetre));
  return featuresOf(state.slabs, lowest, reading);
}

std::string whyNothing(const State& state, const Params& params, geometry::CellIndex cell)
{
  if (state.window && !state.window->contains(cell))
  {
    return "outside the window around the robot that the map keeps (extent = rolling)";
  }
  if (params.extent == Extent::fixed && !fixedRect(state.lattice, params).contains(cell))
  {
    return "outside the map (extent = fixed)";
  }
  return "never seen: no point fell into the cell";
}
}  // namespace

std::vector<layers::Fact> explain(
    const State& state,
    const Params& params,
    const geometry::Vehicle& vehicle,
    geometry::CellIndex cell)
{
  Facts facts;
  const auto along = [&](int32_t i)
  { return metres(state.lattice.edge_m(i)) + " to " + metres(state.lattice.edge_m(i + 1)); };
  facts.push_back({"cell", std::to_string(cell.x) + ", " + std::to_string(cell.y)});
  facts.push_back({"x", along(cell.x)});
  facts.push_back({"y", along(cell.y)});
  const Class of = explainClass(state, params, vehicle, cell, facts);
  const Cell* stored = state.cells.get(cell);
  const auto* lowest = stored == nullptr ? nullptr : state.slabs.get(stored->slabs);
  if (lowest == nullptr)
  {
    facts.push_back({"decided by", whyNothing(state, params, cell)});
    return facts;
  }
  const Features f = featuresThatCount(state, *stored, params, vehicle);
  const Class by_itself = Classifier(params)(f);
  if (of == by_itself)
  {
    explainLimits(of, f, params, facts);
  }
  else
  {
    explainGround(*stored, f, params, vehicle, facts);
  }
  facts.push_back(
      {"ground", std::isnan(stored->ground_m) ? "not known" : metres(stored->ground_m)});
  explainFeatures(f, facts);
  explainSlabs(state, lowest, f, vehicle, facts);
  return facts;
}
}  // namespace traverse::traversability_grid
