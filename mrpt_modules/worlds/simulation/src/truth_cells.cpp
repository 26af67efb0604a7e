// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "truth_cells.h"

#include <traverse/geometry/exact_trig.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace traverse::simulation
{
namespace
{
constexpr int kSubs = kSubsPerCell * kSubsPerCell;

/** Largest distance of heights on 4 x 4 places from their plane of least squares, m, vertically. */
float offPlane(const std::array<float, kSubs>& height_m)
{
  // places at -1.5, -0.5, 0.5, 1.5 along both axes: the normal equations are diagonal
  constexpr float kMiddle = (kSubsPerCell - 1) / 2.0F;
  constexpr float kSquares = 20;
  const float base = height_m[0];  // small numbers keep their digits
  float mean = 0;
  float along_x = 0;
  float along_y = 0;
  const auto u = [](int k) { return static_cast<float>(k % kSubsPerCell) - kMiddle; };
  const auto v = [](int k)
  {
    const int row = k / kSubsPerCell;
    return static_cast<float>(row) - kMiddle;
  };
  for (int k = 0; k < kSubs; ++k)
  {
    const float h = height_m[k] - base;
    mean += h / kSubs;
    along_x += u(k) * h / kSquares;
    along_y += v(k) * h / kSquares;
  }
  float off = 0;
  for (int k = 0; k < kSubs; ++k)
  {
    off = std::max(off, std::abs(height_m[k] - base - mean - along_x * u(k) - along_y * v(k)));
  }
  return off;
}
}  // namespace

CellJudge::CellJudge(
    const SubSquares& subs, const geometry::Vehicle& vehicle, const TruthParams& params) :
    subs_(subs),
    vehicle_(vehicle),
    params_(params),
    stacker_(subs.pieces, static_cast<float>(vehicle.height_m))
{
}

void CellJudge::addSub(Gathered& cell, int k, size_t sub)
{
  const float ground_m = subs_.ground.height_m[sub];
  const float base_m = subs_.ground.base_m[sub];
  const Stack stack = stacker_.at(sub, ground_m);
  const float climb_m = subs_.climb_m[sub];
  cell.hard_m[k] = stack.hard_m;
  cell.top_m[k] = stack.top_m;
  cell.hard_step_m = std::max({cell.hard_step_m, std::abs(stack.hard_m - base_m), climb_m});
  cell.top_step_m = std::max({cell.top_step_m, std::abs(stack.top_m - base_m), climb_m});
  cell.ditch_m = std::max(cell.ditch_m, subs_.ground.ditch_m[sub]);
  cell.ground_m += base_m / kSubs;
  cell.known = cell.known && std::isfinite(ground_m) && std::isfinite(base_m);
  cell.reached = cell.reached || subs_.reached[sub] != 0;
  cell.overhang = cell.overhang || stack.overhang;
  const float decides_m = std::abs(stack.top_m - base_m);
  if (decides_m > cell.decides_m)
  {
    cell.decides_m = decides_m;
    cell.object = stack.top_object;
    cell.label = stack.top_object == Scene::kGround
                     ? static_cast<Label>(subs_.ground.label[sub])
                     : subs_.scene.objects[stack.top_object - Scene::kFirstObject].label;
  }
}

CellJudge::Gathered CellJudge::gather(int32_t x, int32_t y)
{
  Gathered cell;
  for (int k = 0; k < kSubs; ++k)
  {
    addSub(
        cell, k,
        subs_.grid.at(x * kSubsPerCell + k % kSubsPerCell, y * kSubsPerCell + k / kSubsPerCell));
  }
  return cell;
}

TrueClass CellJudge::classOf(float roughness_m) const
{
  if (roughness_m < static_cast<float>(params_.flat_max_m))
  {
    return TrueClass::flat;
  }
  if (roughness_m < static_cast<float>(params_.small_max_m))
  {
    return TrueClass::small_roughness;
  }
  return roughness_m < static_cast<float>(params_.large_max_m) ? TrueClass::large_roughness
                                                               : TrueClass::obstacle;
}

/** Rise per metre of the smooth ground over 1 m around a cell, without its steps. */
double CellJudge::riseAlong(int32_t middle, int32_t line, bool along_x) const
{
  const SubGrid& grid = subs_.grid;
  const int half = std::max(1, static_cast<int>(std::lround(0.5 / grid.sub_m())));
  const int count = along_x ? grid.width() : grid.height();
  const int from = std::max(0, middle * kSubsPerCell + kSubsPerCell / 2 - half);
  const int to = std::min(count - 1, middle * kSubsPerCell + kSubsPerCell / 2 - 1 + half);
  const int beside = line * kSubsPerCell + kSubsPerCell / 2;
  const auto step_m = static_cast<float>(grid.sub_m());  // steeper than 45 deg is no slope
  const auto base_at = [&](int i)
  { return subs_.ground.base_m[along_x ? grid.at(i, beside) : grid.at(beside, i)]; };
  double rise_m = 0;
  float before_m = base_at(from);
  for (int i = from + 1; i <= to; ++i)
  {
    const float here_m = base_at(i);
    rise_m += std::abs(here_m - before_m) > step_m ? 0 : here_m - before_m;
    before_m = here_m;
  }
  return rise_m / ((to - from) * grid.sub_m());
}

float CellJudge::slopeDegAt(int32_t x, int32_t y) const
{
  const double rise_x = riseAlong(x, y, true);
  const double rise_y = riseAlong(y, x, false);
  const double steepness = std::sqrt(rise_x * rise_x + rise_y * rise_y);
  return static_cast<float>(geometry::angleOf(steepness, 1) / geometry::kPi * 180);
}

TrueState CellJudge::stateOf(const Gathered& cell, TrueClass of) const
{
  if (cell.ditch_m > static_cast<float>(params_.large_max_m))
  {
    return TrueState::ditch;
  }
  if (of == TrueClass::obstacle)
  {
    return TrueState::occupied;
  }
  return cell.overhang ? TrueState::overhang : TrueState::free;
}

TrueCell CellJudge::at(int32_t x, int32_t y)
{
  const Gathered cell = gather(x, y);
  TrueCell result;
  if (!cell.known)
  {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    result.roughness_m = result.step_m = result.slope_deg = result.ground_m = kNan;
    return result;
  }
  const float hard_m = std::max(offPlane(cell.hard_m), cell.hard_step_m);
  // what gives way makes driving rough, never impossible
  const float top_m = std::min(
      std::max(offPlane(cell.top_m), cell.top_step_m), static_cast<float>(params_.large_max_m));
  result.roughness_m = std::max(hard_m, top_m);
  result.step_m = std::max(
      cell.hard_step_m, std::min(cell.top_step_m, static_cast<float>(params_.large_max_m)));
  result.slope_deg = slopeDegAt(x, y);
  result.of = std::max(classOf(hard_m), std::min(classOf(top_m), TrueClass::large_roughness));
  if (!cell.reached || result.slope_deg > static_cast<float>(vehicle_.max_slope_deg))
  {
    result.of = TrueClass::obstacle;
  }
  result.state = stateOf(cell, result.of);
  result.ground_m = cell.ground_m;
  result.object = cell.object;
  result.label = cell.label;
  return result;
}

CellLayers::CellLayers(const geometry::CellRect& extent) : extent_(extent)
{
  const size_t size = static_cast<size_t>(extent.width()) * static_cast<size_t>(extent.height());
  for (auto* bytes : {&of_, &state_, &label_})
  {
    bytes->resize(size);
  }
  object_.resize(size);
  for (auto* numbers : {&roughness_, &step_, &slope_, &ground_})
  {
    numbers->resize(size);
  }
}

void CellLayers::put(int32_t x, int32_t y, const TrueCell& cell)
{
  const size_t i =
      static_cast<size_t>(y) * static_cast<size_t>(extent_.width()) + static_cast<size_t>(x);
  of_[i] = static_cast<uint8_t>(cell.of);
  state_[i] = static_cast<uint8_t>(cell.state);
  label_[i] = static_cast<uint8_t>(cell.label);
  object_[i] = cell.object;
  roughness_[i] = cell.roughness_m;
  step_[i] = cell.step_m;
  slope_[i] = cell.slope_deg;
  ground_[i] = cell.ground_m;
}

layers::LayerSet CellLayers::take(const geometry::Lattice& lattice)
{
  layers::LayerSet set;
  set.lattice = lattice;
  set.extent = extent_;
  set.class_layer = "truth_class";
  set.legend = {
      {0, "unknown", {128, 128, 128}},
      {1, "flat", {40, 90, 220}},
      {2, "small roughness", {200, 162, 200}},
      {3, "large roughness", {220, 20, 60}},
      {4, "obstacle", {255, 214, 0}}};
  set.layers.push_back({"truth_class", "1", std::move(of_)});
  set.layers.push_back({"truth_state", "1", std::move(state_)});
  set.layers.push_back({"truth_roughness", "m", std::move(roughness_)});
  set.layers.push_back({"truth_step", "m", std::move(step_)});
  set.layers.push_back({"truth_slope", "deg", std::move(slope_)});
  set.layers.push_back({"ground_height", "m", std::move(ground_)});
  set.layers.push_back({"truth_object", "1", std::move(object_)});
  set.layers.push_back({"truth_label", "1", std::move(label_)});
  return set;
}
}  // namespace traverse::simulation
