// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/drivetrain.h>
#include <traverse/navigation/curves.h>
#include <traverse/navigation/heading_bins.h>
#include <traverse/navigation/plan_params.h>
#include <traverse/navigation/price_field.h>

#include <optional>
#include <vector>

namespace traverse::navigation
{
/** What is sought, and where. */
struct HybridTask
{
  const Terrain* terrain = nullptr;
  PriceField* field = nullptr;  //!< from the goal
  const ObstacleCounts* obstacles = nullptr;
  Footprint* footprint = nullptr;  //!< that keeps off them
  geometry::Pose2 start;
  Place goal;                     //!< of the terrain
  std::optional<double> yaw_rad;  //!< at the goal; nothing: any
  double loose_m = 0;             //!< so far from the goal will do
  double last_resort_m = 0;       //!< will do, if the goal itself cannot be reached
  int most_expansions = 0;        //!< then it gives up
};

/** Hybrid A*: over places and headings by arcs that the vehicle can drive (Dolgov, Thrun,
 * Montemerlo, Diebel 2010). What is left costs no less than the field says, nor than the shortest
 * curve without obstacles. Such curves are tried to the goal, the more often the nearer it is; the
 * search ends when no other way can be cheaper by more than 20 %, as far as the field knows, or
 * better ones have been sought for as long as the first took. */
class HybridSearch
{
 public:
  HybridSearch(const geometry::Drivetrain& drivetrain, const PlanParams& params);

  /** Empty where there is no way, or none was found in time. */
  Path search(const HybridTask& task);

  /** Of the last search. */
  int expansions() const { return expansions_; }

  bool gaveUp() const { return expansions_ >= task_.most_expansions; }

 private:
  struct Node
  {
    Posed at;
    double price = 0;  // from the start
    double left = 0;   // to the goal, estimated
    int32_t before = HeadingBins::kNone;
    int32_t arc = 0;
  };

  struct Waiting
  {
    double total = 0;
    int32_t node = 0;
  };

  /** A way from a node to the goal. */
  struct Ending
  {
    int32_t node = HeadingBins::kNone;
    double price = 0;  // from the start
    std::vector<Motion> motions;
  };

  struct Arc
  {
    Motion motion;
    std::vector<Shift> steps;
  };

  void begin(const HybridTask& task);
  void makeArcs(double width_m);
  void expand(int32_t from);
  void offer(int32_t from, int32_t arc);
  void shoot(int32_t from);
  void noteNear(int32_t node);
  bool isTimeToShoot(const Node& node);
  bool isBackward(const Node& node) const;
  double priceOfTurn(int32_t node, bool is_backward) const;
  double leastFrom(const Posed& at);
  double distanceToGoal_m(const Posed& at) const;
  double priceOf(const Posed& from, const Motion& motion, std::span<const Shift> steps) const;
  std::optional<double> priceOf(int32_t from, std::span<const Motion> motions);
  Path pathOf(const Ending& ending) const;

  PlanParams params_;
  double radius_m_;
  bool drives_backward_;
  Curves curves_;
  HybridTask task_;
  HeadingBins bins_;
  double arcs_width_m_ = 0;
  std::vector<Arc> arcs_;
  std::vector<Node> nodes_;
  std::vector<Waiting> queue_;
  Ending best_;
  Ending near_;
  int expansions_ = 0;
  int since_shot_ = 0;
};
}  // namespace traverse::navigation
