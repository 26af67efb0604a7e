// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/exact_trig.h>
#include <traverse/navigation/grid_path.h>

#include <algorithm>
#include <cmath>

namespace traverse::navigation
{
namespace
{
/** What rounding may add to a price. */
double about(double price)
{
  return price * (1 + 1e-12) + 1e-12;
}
}  // namespace

std::vector<Place> downTheField(const PriceField& field, const Terrain& terrain, size_t from)
{
  std::vector<Place> places = {terrain.centre(from)};
  for (size_t next = field.next(from); next != from; next = field.next(from))
  {
    from = next;
    places.push_back(terrain.centre(from));
  }
  return places;
}

std::vector<Place> shortened(const Terrain& terrain, std::span<const Place> places)
{
  // A line may be dearer than the way at one place and not at the next, so the search goes on for a
  // while after the last that was good.
  constexpr size_t kLookAhead = 25;
  std::vector<double> price(places.size(), 0);
  for (size_t k = 1; k < places.size(); ++k)
  {
    price[k] = price[k - 1] + terrain.priceOfLine(places[k - 1], places[k]);
  }
  std::vector<Place> kept;
  size_t from = 0;
  while (from + 1 < places.size())
  {
    kept.push_back(places[from]);
    size_t best = from + 1;
    for (size_t to = from + 2; to < places.size() && to <= best + kLookAhead; ++to)
    {
      if (terrain.priceOfLine(places[from], places[to]) <= about(price[to] - price[from]))
      {
        best = to;
      }
    }
    from = best;
  }
  kept.push_back(places.back());
  return kept;
}

std::vector<Place> resampled(std::span<const Place> places, double step_m)
{
  std::vector<Place> all;
  for (size_t k = 1; k < places.size(); ++k)
  {
    const Place a = places[k - 1];
    const Place b = places[k];
    const auto parts = static_cast<int64_t>(std::ceil(distance_m(a, b) / step_m));
    for (int64_t part = 0; part < parts; ++part)
    {
      const double share = static_cast<double>(part) / static_cast<double>(parts);
      all.push_back({a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m)});
    }
  }
  all.push_back(places.back());
  return all;
}

void smooth(const Terrain& terrain, std::vector<Place>& places)
{
  constexpr int kSweeps = 30;
  constexpr double kLeastMove_m = 1e-4;
  std::vector<double> price(places.size(), 0);  // of the leg that ends there
  for (size_t k = 1; k < places.size(); ++k)
  {
    price[k] = terrain.priceOfLine(places[k - 1], places[k]);
  }
  bool has_moved = true;
  for (int sweep = 0; sweep < kSweeps && has_moved; ++sweep)
  {
    has_moved = false;
    for (size_t k = 1; k + 1 < places.size(); ++k)
    {
      const Place before = places[k - 1];
      const Place after = places[k + 1];
      const Place to = {
          (places[k].x_m + (before.x_m + after.x_m) / 2) / 2,
          (places[k].y_m + (before.y_m + after.y_m) / 2) / 2};
      if (distance_m(places[k], to) < kLeastMove_m)
      {
        continue;
      }
      const double first = terrain.priceOfLine(before, to);
      const double second = terrain.priceOfLine(to, after);
      if (first + second <= price[k] + price[k + 1])
      {
        places[k] = to;
        price[k] = first;
        price[k + 1] = second;
        has_moved = true;
      }
    }
  }
}

double priceOf(const Terrain& terrain, std::span<const Place> places)
{
  double sum = 0;
  for (size_t k = 1; k < places.size(); ++k)
  {
    sum += terrain.priceOfLine(places[k - 1], places[k]);
  }
  return sum;
}

Path pathThrough(std::span<const Place> places, std::optional<double> last_yaw_rad)
{
  Path path(places.size());
  for (size_t k = 0; k < places.size(); ++k)
  {
    const Place before = places[k == 0 ? 0 : k - 1];
    const Place after = places[std::min(k + 1, places.size() - 1)];
    path[k].pose = {
        places[k].x_m, places[k].y_m,
        geometry::angleOf(after.y_m - before.y_m, after.x_m - before.x_m)};
    path[k].along_m = k == 0 ? 0 : path[k - 1].along_m + distance_m(before, places[k]);
  }
  for (size_t k = 0; k + 1 < path.size(); ++k)
  {
    const double turn = path[k + 1].pose.yaw_rad - path[k].pose.yaw_rad;
    const double step_m = path[k + 1].along_m - path[k].along_m;
    path[k].curvature_1pm = step_m > 0 ? std::remainder(turn, 2 * geometry::kPi) / step_m : 0;
  }
  if (last_yaw_rad && !path.empty())
  {
    path.back().pose.yaw_rad = std::remainder(*last_yaw_rad, 2 * geometry::kPi);
  }
  return path;
}
}  // namespace traverse::navigation
