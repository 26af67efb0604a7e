// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/convex_distance.h>
#include <traverse/geometry/frame2.h>
#include <traverse/simulation/footprints.h>
#include <traverse/simulation/surroundings.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace traverse::simulation
{
namespace
{
/** An outline, and a disc that holds it. */
struct Bounded
{
  Outline outline;
  geometry::Round round;

  explicit Bounded(Outline given) : outline(std::move(given)), round(geometry::roundOf(outline)) {}
};

/** What moves, in its own frame. */
struct Mover
{
  Motion motion;
  std::vector<Bounded> pieces;
};

/** Middles of cells of a ditch that lie near each other. */
struct DitchCells
{
  geometry::Round round;
  std::vector<Eigen::Vector2d> middles;
};

/** Least distance of a vehicle so far, and what it is looked for with. */
class Search
{
 public:
  Search(Outline outline, double most_m) : vehicle_(std::move(outline)), nearest_m_(most_m) {}

  bool mayReach(const geometry::Round& round) const
  {
    const Eigen::Vector2d d = round.middle - vehicle_.round.middle;
    const double reach = nearest_m_ + round.radius_m + vehicle_.round.radius_m;
    return reach >= 0 && d.dot(d) <= reach * reach;
  }

  void meet(const Outline& outline)
  {
    nearest_m_ = std::min(nearest_m_, geometry::apart(vehicle_.outline, outline));
  }

  void meet(const Eigen::Vector2d& place)
  {
    nearest_m_ = std::min(nearest_m_, geometry::apart(place, vehicle_.outline));
  }

  double nearest_m() const { return nearest_m_; }

 private:
  Bounded vehicle_;
  double nearest_m_;
};

constexpr double kCell_m = 0.1;
constexpr int kCellsOfBlock = 20;

DitchCells ditchIn(const Terrain& terrain, const Eigen::Vector2d& corner, double max_step_m)
{
  DitchCells cells;
  for (int i = 0; i < kCellsOfBlock * kCellsOfBlock; ++i)
  {
    const int row = i / kCellsOfBlock;
    const int column = i % kCellsOfBlock;
    const Eigen::Vector2d at = corner + kCell_m * Eigen::Vector2d(column + 0.5, row + 0.5);
    if (terrain.at(at.x(), at.y()).ditch_m > max_step_m)
    {
      cells.middles.push_back(at);
    }
  }
  cells.round = cells.middles.empty() ? geometry::Round() : geometry::roundOf(cells.middles);
  return cells;
}

std::vector<DitchCells> ditchesOf(const Scene& scene, double max_step_m)
{
  constexpr double kBlock_m = kCell_m * kCellsOfBlock;
  const Area& area = scene.area;
  const auto columns = static_cast<int>(std::ceil((area.max_x_m - area.min_x_m) / kBlock_m));
  const auto rows = static_cast<int>(std::ceil((area.max_y_m - area.min_y_m) / kBlock_m));
  std::vector<DitchCells> all;
  for (int block = 0; block < columns * rows; ++block)
  {
    const int row = block / columns;
    const double x = area.min_x_m + block % columns * kBlock_m;
    const double y = area.min_y_m + row * kBlock_m;
    if (!scene.terrain->isSharpIn({x, y, x + kBlock_m, y + kBlock_m}))
    {
      continue;
    }
    DitchCells cells = ditchIn(*scene.terrain, {x, y}, max_step_m);
    if (!cells.middles.empty())
    {
      all.push_back(std::move(cells));
    }
  }
  return all;
}
}  // namespace

struct Surroundings::Known
{
  Outline vehicle;  //!< in its frame
  std::vector<Bounded> standing;
  std::vector<Mover> movers;
  std::vector<DitchCells> ditches;

  void add(const Object& object, std::vector<Outline> outlines)
  {
    if (!object.motion.moves())
    {
      for (Outline& outline : outlines)
      {
        standing.emplace_back(std::move(outline));
      }
      return;
    }
    Mover mover{object.motion, {}};
    const geometry::Frame2 frame = geometry::Frame2::of(object.motion.at(0));
    for (const Outline& outline : outlines)
    {
      mover.pieces.emplace_back(frame.in(outline));
    }
    movers.push_back(std::move(mover));
  }
};

Surroundings::Surroundings(const Scene& scene, const geometry::Vehicle& vehicle)
{
  auto known = std::make_shared<Known>();
  known->vehicle = geometry::convexHull(geometry::footprintOf(vehicle));
  if (known->vehicle.empty())
  {
    throw std::invalid_argument("[Vehicle]: the footprint has no area");
  }
  for (Footprint& thing : footprints(scene, vehicle, 0))
  {
    if (thing.height_m > vehicle.max_step_m)
    {
      known->add(scene.objects[thing.object - Scene::kFirstObject], std::move(thing.outlines));
    }
  }
  known->ditches = ditchesOf(scene, vehicle.max_step_m);
  known_ = std::move(known);
}

double Surroundings::clearance_m(const geometry::Pose2& pose, double t_s, double most_m) const
{
  Search search(geometry::Frame2::of(pose).out(known_->vehicle), most_m);
  for (const Bounded& thing : known_->standing)
  {
    if (search.mayReach(thing.round))
    {
      search.meet(thing.outline);
    }
  }
  for (const Mover& mover : known_->movers)
  {
    const geometry::Frame2 frame = geometry::Frame2::of(mover.motion.at(t_s));
    for (const Bounded& piece : mover.pieces)
    {
      if (search.mayReach({frame.out(piece.round.middle), piece.round.radius_m}))
      {
        search.meet(frame.out(piece.outline));
      }
    }
  }
  for (const DitchCells& cells : known_->ditches)
  {
    if (search.mayReach(cells.round))
    {
      for (const Eigen::Vector2d& middle : cells.middles)
      {
        search.meet(middle);
      }
    }
  }
  return search.nearest_m();
}
}  // namespace traverse::simulation
