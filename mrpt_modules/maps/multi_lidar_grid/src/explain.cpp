// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/multi_lidar_grid/fusion.h>
#include <traverse/multi_lidar_grid/multi_lidar_grid.h>
#include <traverse/options/untrusted_text.h>

#include <cmath>
#include <limits>
#include <string>

namespace traverse::multi_lidar_grid
{
namespace
{
using layers::OccupancyState;
using Facts = std::vector<layers::Fact>;

std::string metres(double value)
{
  return options::format(
             std::round(value * geometry::kMillimetresPerMetre) / geometry::kMillimetresPerMetre) +
         " m";
}

std::string along(const geometry::Lattice& lattice, int32_t i)
{
  return metres(lattice.edge_m(i)) + " to " + metres(lattice.edge_m(i) + lattice.cell_m());
}

std::string secondsAgo(poses::TimeNs now, poses::TimeNs time)
{
  const double s = (static_cast<double>(now) - static_cast<double>(time)) * poses::kSecondsPerNs;
  return options::format(std::round(s * 1000) / 1000) + " s ago";
}

std::string nameOf(OccupancyState state)
{
  switch (state)
  {
    case OccupancyState::free:
      return "free";
    case OccupancyState::obstacle:
      return "obstacle";
    case OccupancyState::negative:
      return "negative obstacle";
    case OccupancyState::overhang:
      return "free under an overhang";
    case OccupancyState::unknown:
      break;
  }
  return "unknown";
}

std::string nameOf(layers::BufferZone zone)
{
  switch (zone)
  {
    case layers::BufferZone::soft:
      return "soft: may be driven, is not planned through";
    case layers::BufferZone::hard:
      return "hard: the vehicle would touch";
    case layers::BufferZone::strip:
      return "strip: as far from one obstacle as from another, may be planned through";
    case layers::BufferZone::none:
      break;
  }
  return "none";
}

std::string labelOf(const Sensor& sensor)
{
  return sensor.label.empty() ? "a sensor without label" : options::printable(sensor.label);
}

std::string labelsOf(const Sensors& sensors, uint32_t bits)
{
  std::string all;
  for (const Sensor& sensor : sensors.all())
  {
    if ((bits & sensors.bitOf(sensor)) != 0)
    {
      all += (all.empty() ? "" : ", ") + labelOf(sensor);
    }
  }
  return all.empty() ? "none" : all;
}

std::string evidence(const Cell& cell, const Params& params)
{
  if (params.accumulation == Accumulation::log_odds)
  {
    return "log-odds of an obstacle are " + options::format(cell.belief * kLogOddsStep);
  }
  if (cell.state == OccupancyState::obstacle || cell.state == OccupancyState::negative)
  {
    const double percent = std::round(100.0 * cell.belief / std::numeric_limits<int8_t>::max());
    return "late looks hit it in " + options::format(percent) + " %, the last " +
           std::to_string(cell.passes) + " contradicted it; " +
           std::to_string(params.clear_after_sweeps) +
           " clear what was hit by every look (clear_after_sweeps)";
  }
  return "beams passed, and no sweep hit it since";
}

void explainCell(const State& state, const Params& params, const Cell& cell, Facts& facts)
{
  facts.push_back({"state", nameOf(cell.state)});
  if (cell.state == OccupancyState::unknown)
  {
    facts.push_back(
        {"decided by", cell.last_seen == 0 ? "no sensor said anything of it"
                                           : "nothing that was said of it still counts"});
    return;
  }
  facts.push_back({"decided by", evidence(cell, params)});
  facts.push_back({"seen by", labelsOf(state.sensors, cell.seen_by)});
  facts.push_back({"last seen", secondsAgo(state.now, cell.last_seen)});
  if (cell.last_hit != 0)
  {
    facts.push_back({"last hit", secondsAgo(state.now, cell.last_hit)});
  }
  const std::string height = metres(cell.up_to * kFreeStep_m) + " over the ground";
  if (cell.state == OccupancyState::obstacle)
  {
    facts.push_back({"hit from", metres(cell.hit_from * kFreeStep_m) + " to " + height});
  }
  else if (cell.up_to > 0)
  {
    facts.push_back({"known free up to", height});
  }
}

/** What the latest clouds say, each for itself. */
void explainLatest(const State& state, const Params& params, geometry::CellIndex at, Facts& facts)
{
  for (const Sensor& sensor : state.sensors.all())
  {
    const Health health = healthOf(sensor, state.now, params);
    std::string text(nameOf(health));
    text += ", newest cloud " + secondsAgo(state.now, sensor.newest);
    const UnitCell* cell =
        sensor.latest.touched.contains(at) ? sensor.latest.cells.get(at) : nullptr;
    if (!sensor.has_cloud || !counts(health))
    {
      text += ", which no longer counts";
    }
    else if (cell != nullptr)
    {
      text += ": " + nameOf(cell->state) + ", " + std::to_string(cell->returns) + " returns";
    }
    else
    {
      text += ": says nothing of this cell";
    }
    if (sensor.clock_offset_s != 0)
    {
      text += "; clock offset " + options::format(sensor.clock_offset_s) + " s in use";
    }
    facts.push_back({"sensor " + labelOf(sensor), text});
  }
}

void explainBuffer(
    const State& state,
    const Params& params,
    const geometry::Vehicle& vehicle,
    geometry::CellIndex at,
    Facts& facts)
{
  const layers::LayerSet one =
      layerSet(state, params, vehicle, geometry::CellRect{at, {at.x + 1, at.y + 1}});
  const auto zone = static_cast<layers::BufferZone>(
      std::get<std::vector<uint8_t>>(one.find("safety_buffer")->data).front());
  facts.push_back({"safety_buffer", nameOf(zone)});
}
}  // namespace

std::vector<layers::Fact> explain(
    const State& state,
    const Params& params,
    const geometry::Vehicle& vehicle,
    geometry::CellIndex cell)
{
  Facts facts;
  facts.push_back({"cell", std::to_string(cell.x) + ", " + std::to_string(cell.y)});
  facts.push_back({"x", along(state.lattice, cell.x)});
  facts.push_back({"y", along(state.lattice, cell.y)});
  const Cell* found = state.cells.get(cell);
  if (found == nullptr)
  {
    facts.push_back({"state", nameOf(OccupancyState::unknown)});
    facts.push_back(
        {"decided by", "it is outside the map's window of " + metres(params.window_m) +
                           " around the robot (window_m)"});
    return facts;
  }
  explainCell(state, params, *found, facts);
  const double ground_m = state.mapper.groundAt(cell);
  facts.push_back(
      {"ground height",
       std::isfinite(ground_m) ? metres(ground_m) : "not known, or not kept with a saved map"});
  explainBuffer(state, params, vehicle, cell, facts);
  explainLatest(state, params, cell, facts);
  return facts;
}
}  // namespace traverse::multi_lidar_grid
