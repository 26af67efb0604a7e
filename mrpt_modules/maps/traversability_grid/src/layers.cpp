// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/traversability_grid/traversability_grid.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace traverse::traversability_grid
{
namespace
{
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr double kNanDouble = std::numeric_limits<double>::quiet_NaN();

int64_t cellsOf(const geometry::CellRect& rect)
{
  const int64_t width = int64_t{rect.max.x} - rect.min.x;
  const int64_t height = int64_t{rect.max.y} - rect.min.y;
  if (width <= 0 || height <= 0)
  {
    return 0;
  }
  return width > kMostLayerCells || height > kMostLayerCells ? kMostLayerCells + 1 : width * height;
}

std::vector<layers::LegendEntry> legend()
{
  return {
      {0, "undefined", {128, 128, 128}},
      {1, "flat", {40, 90, 220}},
      {2, "small roughness", {200, 162, 200}},
      {3, "large roughness", {220, 20, 60}},
      {4, "obstacle", {255, 214, 0}}};
}

/** The layers' arrays while they are filled. */
class Filler
{
 public:
  explicit Filler(size_t size) :
      of_(size, 0),
      index_(size, kNan),
      mean_(size, kNan),
      deviation_(size, kNan),
      slope_(size, kNan),
      variance_(size, kNan),
      min_(size, kNan),
      max_(size, kNan),
      ground_(size, kNan),
      count_(size, 0),
      last_(size, kNanDouble)
  {
  }

  void put(size_t i, const Cell& cell, const Features& f)
  {
    of_[i] = static_cast<uint8_t>(cell.of);
    index_[i] = cell.index == kNoIndex ? kNan : static_cast<float>(cell.index);
    ground_[i] = cell.ground_m;
    mean_[i] = static_cast<float>(f.mean_m);
    deviation_[i] = static_cast<float>(f.deviation_m);
    slope_[i] = static_cast<float>(f.slope_deg());
    variance_[i] = static_cast<float>(f.variance_m2);
    min_[i] = static_cast<float>(f.min_m);
    max_[i] = static_cast<float>(f.max_m);
    count_[i] =
        static_cast<uint32_t>(std::min<uint64_t>(f.n, std::numeric_limits<uint32_t>::max()));
    last_[i] = static_cast<double>(f.last_seen) * poses::kSecondsPerNs;
  }

  std::vector<layers::Layer> take()
  {
    std::vector<layers::Layer> all;
    all.push_back({"traversability_class", "1", std::move(of_)});
    all.push_back({"traversability_index", "1", std::move(index_)});
    all.push_back({"height_mean", "m", std::move(mean_)});
    all.push_back({"height_deviation", "m", std::move(deviation_)});
    all.push_back({"slope_deg", "deg", std::move(slope_)});
    all.push_back({"height_variance", "m^2", std::move(variance_)});
    all.push_back({"point_count", "1", std::move(count_)});
    all.push_back({"height_min", "m", std::move(min_)});
    all.push_back({"height_max", "m", std::move(max_)});
    all.push_back({"ground_height", "m", std::move(ground_)});
    all.push_back({"last_seen_s", "s", std::move(last_)});
    return all;
  }

 private:
  std::vector<uint8_t> of_;
  std::vector<float> index_, mean_, deviation_, slope_, variance_, min_, max_, ground_;
  std::vector<uint32_t> count_;
  std::vector<double> last_;
};
}  // namespace

geometry::CellRect extentOf(const State& state, const Params& params)
{
  if (state.window)
  {
    return *state.window;
  }
  return params.extent == Extent::fixed ? fixedRect(state.lattice, params) : occupiedRect(state);
}

layers::LayerSet layerSet(
    const State& state,
    const Params& params,
    const geometry::Vehicle& vehicle,
    std::optional<geometry::CellRect> window)
{
  layers::LayerSet set;
  set.lattice = state.lattice;
  set.extent = window ? *window : extentOf(state, params);
  if (cellsOf(set.extent) > kMostLayerCells)
  {
    throw std::length_error(
        "the map's extent has more than 100 million cells: ask for a window of it");
  }
  if (cellsOf(set.extent) == 0)
  {
    set.extent = {};
  }
  set.class_layer = "traversability_class";
  set.legend = legend();

  const SlabReading reading = slabReading(state, params, vehicle);
  const auto width = static_cast<size_t>(set.extent.width());
  Filler filler(set.size());
  const auto put = [&](Cells::Place place, const Cell& cell)
  {
    const geometry::CellIndex c = state.cells.indexOf(place);
    const size_t i = static_cast<size_t>(c.y - set.extent.min.y) * width +
                     static_cast<size_t>(c.x - set.extent.min.x);
    filler.put(i, cell, featuresOf(state.slabs, state.slabs.get(cell.slabs), reading));
  };
  if (window && state.rule == classRule(params, vehicle))
  {
    forEachOccupiedIn(state, *window, put);
  }
  else
  {
    judgeAll(
        state, params, vehicle, set.extent,
        [&](Cells::Place place, const Judgement& judgement)
        {
          Cell cell = state.cells.at(place);
          setClass(cell, judgement, params);
          put(place, cell);
        });
  }
  set.layers = filler.take();
  return set;
}
}  // namespace traverse::traversability_grid
