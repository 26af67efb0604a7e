// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper_3.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace traverse::simulation
{
namespace
{
/** As far as the road must go to leave the area on both sides. */
double halfWay(const SceneExtentParams& e)
{
  const double x = e.max_x_m - e.min_x_m;
  const double y = e.max_y_m - e.min_y_m;
  return std::sqrt(x * x + y * y) * 0.75;
}
}  // namespace

Paper3::Paper3(SceneParams& scene, uint64_t seed) :
    scene_(scene),
    asks_(scene.random),
    seed_(mixed({seed, 0x9A9E2003})),
    first_(seed_),
    way_(first_, halfWay(scene.extent)),
    plot_(scene_.extent, way_),
    half_road_m_(rounded(first_, 2.3, 3.7)),
    winter_(first_.chance(0.5))
{
  if (first_.chance(asks_.kerb_chance))
  {
    kerb_side_ = first_.chance(0.5) ? 1 : -1;
    kerb_m_ = rounded(first_, 1.4, 3);
  }
  if (first_.chance(asks_.ditch_chance))
  {
    // not on the pavement's side
    ditch_side_ = kerb_side_ != 0 ? -kerb_side_ : (first_.chance(0.5) ? 1 : -1);
  }
  if (asks_.moving_vehicles > 0)
  {
    lane_side_ = openSide(first_);
    lane_m_ = std::max(kDriveFree_m + 1.15, half_road_m_ - 1);
  }
}

void Paper3::addAll()
{
  const double half = asks_.drive_m / 2;
  std::tie(scene_.drive_xs_m, scene_.drive_ys_m) = way_.beside(-half, half, 0);
  checkDrive(scene_);
  addGround();
  addMovingVehicles();
  addThings();
  addParkedVehicles();
  addPeople();
  scene_.random = {};
}

double Paper3::openSide(Random& random) const
{
  const double any = random.chance(0.5) ? 1 : -1;
  return kerb_side_ != 0 ? -kerb_side_ : any;
}

void Paper3::put(ObjectParams thing, const Eigen::Vector2d& at, Random& random)
{
  thing.x_m = inMillimetres(at.x());
  thing.y_m = inMillimetres(at.y());
  thing.seed = seedOf(random);
  scene_.objects.push_back(std::move(thing));
}

void Paper3::putSomewhere(ObjectParams thing, double radius_m, double farthest_m, Random& random)
{
  constexpr int kTries = 60;
  constexpr double kAlong_m = 26;
  for (int i = 0; i < kTries; ++i)
  {
    const double along = random.uniform(-kAlong_m, kAlong_m);
    const double share = random.uniform();
    const double off = half_road_m_ + 0.3 + radius_m + share * share * farthest_m;
    const Eigen::Vector2d at = way_.place(along, random.chance(0.5) ? off : -off);
    if (plot_.isFree({at, radius_m}, half_road_m_ + 0.2))
    {
      plot_.take({at, radius_m});
      put(std::move(thing), at, random);
      return;
    }
  }
}

void Paper3::follow(TerrainParams& strip, double from_m, double to_m, double left_m) const
{
  std::tie(strip.xs_m, strip.ys_m) = way_.beside(from_m, to_m, left_m);
}

}  // namespace traverse::simulation
