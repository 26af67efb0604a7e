// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// What ways cost, and what is left at least.
#include <traverse/navigation/hybrid_search.h>

#include <algorithm>
#include <cmath>

namespace traverse::navigation
{
namespace
{
constexpr int32_t kNone = HeadingBins::kNone;

/** A metre on the tightest circle costs so much more than straight on. */
constexpr double kBendPrice = 0.05;

/** Shortest curves are reckoned so near the goal. */
constexpr double kNearRadii = 8;
}  // namespace

bool HybridSearch::isBackward(const Node& node) const
{
  return node.arc != kNone && arcs_[static_cast<size_t>(node.arc)].motion.length_m < 0;
}

double HybridSearch::priceOfTurn(int32_t node, bool is_backward) const
{
  const Node& before = nodes_[static_cast<size_t>(node)];
  return before.arc != kNone && isBackward(before) != is_backward ? params_.turn_price : 0;
}

double HybridSearch::distanceToGoal_m(const Posed& at) const
{
  return distance_m(at.stand.place, task_.goal);
}

double HybridSearch::leastFrom(const Posed& at)
{
  const double by_field = task_.field->priceFrom(task_.terrain->indexAt(at.stand.place));
  if (!task_.yaw_rad || !(by_field < PriceField::kNever) ||
      distanceToGoal_m(at) > kNearRadii * radius_m_)
  {
    return by_field;
  }
  const double by_curve =
      curves_.least_m(at, {task_.goal.x_m, task_.goal.y_m, *task_.yaw_rad}) * kLeastPrice;
  return std::max(by_field, by_curve);
}

/** kNever where it meets something. */
double HybridSearch::priceOf(
    const Posed& from, const Motion& motion, std::span<const Shift> steps) const
{
  double sum = 0;
  Place last = from.stand.place;
  for (const Shift& step : steps)
  {
    const Posed next = after(from, step);
    if (!task_.terrain->covers(next.stand.place))
    {
      return PriceField::kNever;
    }
    sum += task_.terrain->priceOfLine(last, next.stand.place);
    if (!(sum < PriceField::kNever) || task_.obstacles->isHit(*task_.footprint, next.stand))
    {
      return PriceField::kNever;
    }
    last = next.stand.place;
  }
  const double bend = 1 + kBendPrice * std::abs(motion.curvature_1pm) * radius_m_;
  return sum * bend * (motion.length_m < 0 ? params_.reverse_price : 1);
}

/** From the start, by this node; nothing where it meets something or is too dear. */
std::optional<double> HybridSearch::priceOf(int32_t from, std::span<const Motion> motions)
{
  constexpr double kMeets_m = 0.01;
  const Node& node = nodes_[static_cast<size_t>(from)];
  Posed at = node.at;
  double sum = node.price;
  bool is_backward = isBackward(node);
  bool has_driven = node.arc != kNone;
  for (const Motion& motion : motions)
  {
    if (motion.length_m == 0)
    {
      continue;
    }
    const bool turns = has_driven && is_backward != (motion.length_m < 0);
    is_backward = motion.length_m < 0;
    has_driven = true;
    const std::vector<Shift> steps = stepsOf(motion);
    sum += (turns ? params_.turn_price : 0) + priceOf(at, motion, steps);
    if (!(sum < PriceField::kNever) || (best_.node != kNone && sum >= best_.price))
    {
      return std::nullopt;
    }
    at = steps.empty() ? at : after(at, steps.back());
  }
  return distanceToGoal_m(at) <= kMeets_m ? std::optional<double>(sum) : std::nullopt;
}
}  // namespace traverse::navigation
