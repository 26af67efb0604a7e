// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/navigation/hybrid_search.h>

#include <algorithm>
#include <cmath>

namespace traverse::navigation
{
namespace
{
constexpr int32_t kNone = HeadingBins::kNone;

/** Circles are so much wider than the vehicle could drive: to steer against errors. */
constexpr double kSteerReserve = 1.05;

/** Of a vehicle that turns on the spot. */
constexpr double kLeastRadius_m = 0.4;

/** What is left counts so much more than what is behind: a path may cost so much more than the best
 * one, and is found much sooner. */
constexpr double kHaste = 1.2;

/** After the first way, better ones are sought with as many expansions as it took and so many more.
 */
constexpr int kPatience = 500;

constexpr double kSameHeading_rad = 0.09;  // about a heading's width

/** Least total first; of equals, the later one. */
bool isLater(double total_a, int32_t node_a, double total_b, int32_t node_b)
{
  return total_a != total_b ? total_a > total_b : node_a < node_b;
}
}  // namespace

HybridSearch::HybridSearch(const geometry::Drivetrain& drivetrain, const PlanParams& params) :
    params_(params),
    radius_m_(std::max(geometry::minTurningRadius_m(drivetrain), kLeastRadius_m) * kSteerReserve),
    drives_backward_(drivetrain.max_reverse_mps > 0),
    curves_(radius_m_, drives_backward_)
{
}

Path HybridSearch::search(const HybridTask& task)
{
  begin(task);
  const auto by_total = [](const Waiting& a, const Waiting& b)
  { return isLater(a.total, a.node, b.total, b.node); };
  int enough = kPatience;
  while (!queue_.empty() && !gaveUp())
  {
    std::pop_heap(queue_.begin(), queue_.end(), by_total);
    const Waiting first = queue_.back();
    queue_.pop_back();
    if (best_.node != kNone && (best_.price <= first.total || expansions_ >= enough))
    {
      break;
    }
    if (bins_.at(nodes_[static_cast<size_t>(first.node)].at) == first.node)
    {
      expand(first.node);
      enough = best_.node == kNone ? kPatience + 2 * expansions_ : enough;
    }
  }
  return pathOf(best_.node != kNone ? best_ : near_);
}

void HybridSearch::begin(const HybridTask& task)
{
  task_ = task;
  bins_.clear(task.terrain->lattice(), task.terrain->extent());
  makeArcs(bins_.width_m());
  nodes_.clear();
  queue_.clear();
  best_ = {};
  near_ = {};
  expansions_ = 0;
  since_shot_ = 0;
  Node first;
  first.at = posed(task.start);
  first.left = leastFrom(first.at);
  first.arc = kNone;
  if (first.left < PriceField::kNever)
  {
    nodes_.push_back(first);
    bins_.at(first.at) = 0;
    queue_.push_back({first.left, 0});
  }
}

// An arc leaves its square, and turns by no more than an eighth of a circle.
void HybridSearch::makeArcs(double width_m)
{
  if (width_m == arcs_width_m_)
  {
    return;
  }
  arcs_width_m_ = width_m;
  arcs_.clear();
  const double straight_m = 1.5 * std::sqrt(2.0) * width_m;
  for (const int way : {1, -1})
  {
    if (way < 0 && !drives_backward_)
    {
      continue;
    }
    for (const int steer : {0, 1, -1, 2, -2})
    {
      Arc arc;
      arc.motion.curvature_1pm = steer / (2 * radius_m_);
      const double most_m =
          steer == 0 ? straight_m : geometry::kPi / 4 / std::abs(arc.motion.curvature_1pm);
      arc.motion.length_m = way * std::min(straight_m, most_m);
      arc.steps = stepsOf(arc.motion);
      arcs_.push_back(std::move(arc));
    }
  }
}

void HybridSearch::expand(int32_t from)
{
  ++expansions_;
  for (size_t arc = 0; arc < arcs_.size(); ++arc)
  {
    offer(from, static_cast<int32_t>(arc));
  }
  if (isTimeToShoot(nodes_[static_cast<size_t>(from)]))
  {
    shoot(from);
  }
}

void HybridSearch::offer(int32_t from, int32_t arc_index)
{
  const Arc& arc = arcs_[static_cast<size_t>(arc_index)];
  const Node& before = nodes_[static_cast<size_t>(from)];
  Node node;
  node.at = after(before.at, arc.steps.back());
  if (!task_.terrain->covers(node.at.stand.place))
  {
    return;
  }
  int32_t& bin = bins_.at(node.at);
  const double base = before.price + priceOfTurn(from, arc.motion.length_m < 0);
  double rival = PriceField::kNever;
  if (bin != kNone)
  {
    rival = nodes_[static_cast<size_t>(bin)].price;
  }
  if (base + std::abs(arc.motion.length_m) * kLeastPrice >= rival)
  {
    return;
  }
  node.price = base + priceOf(before.at, arc.motion, arc.steps);
  if (!(node.price < rival))
  {
    return;
  }
  node.left = leastFrom(node.at);
  if (!(node.left < PriceField::kNever))
  {
    return;
  }
  node.before = from;
  node.arc = arc_index;
  bin = static_cast<int32_t>(nodes_.size());
  nodes_.push_back(node);
  queue_.push_back({node.price + kHaste * node.left, bin});
  std::push_heap(
      queue_.begin(), queue_.end(),
      [](const Waiting& a, const Waiting& b) { return isLater(a.total, a.node, b.total, b.node); });
  noteNear(bin);
}

/** Places from which the goal is as good as reached. */
void HybridSearch::noteNear(int32_t index)
{
  const Node& node = nodes_[static_cast<size_t>(index)];
  const double off_m = distanceToGoal_m(node.at);
  const bool looks_there =
      !task_.yaw_rad ||
      std::abs(std::remainder(*task_.yaw_rad - node.at.yaw_rad, 2 * geometry::kPi)) <=
          kSameHeading_rad;
  const double total = node.price + node.left;
  if (off_m <= task_.loose_m && (best_.node == kNone || total < best_.price))
  {
    best_ = {index, total, {}};
  }
  if (off_m <= task_.last_resort_m && looks_there && (near_.node == kNone || total < near_.price))
  {
    near_ = {index, total, {}};
  }
}

bool HybridSearch::isTimeToShoot(const Node& node)
{
  const double off_m = distanceToGoal_m(node.at);
  if (++since_shot_ <= off_m / (2 * radius_m_))
  {
    return false;
  }
  since_shot_ = 0;
  return true;
}

void HybridSearch::shoot(int32_t from)
{
  for (std::vector<Motion>& way :
       curves_.to(nodes_[static_cast<size_t>(from)].at, task_.goal, task_.yaw_rad))
  {
    const std::optional<double> price = priceOf(from, way);
    if (price && (best_.node == kNone || *price < best_.price))
    {
      best_ = {from, *price, std::move(way)};
    }
  }
}

Path HybridSearch::pathOf(const Ending& ending) const
{
  std::vector<int32_t> chain;
  for (int32_t k = ending.node; k != kNone; k = nodes_[static_cast<size_t>(k)].before)
  {
    chain.push_back(k);
  }
  Path path;
  for (size_t k = chain.size(); k-- > 1;)
  {
    const Node& next = nodes_[static_cast<size_t>(chain[k - 1])];
    drive(
        path, nodes_[static_cast<size_t>(chain[k])].at,
        arcs_[static_cast<size_t>(next.arc)].motion);
  }
  if (ending.node == kNone)
  {
    return path;
  }
  Posed at = nodes_[static_cast<size_t>(ending.node)].at;
  drive(path, at, {});
  for (const Motion& motion : ending.motions)
  {
    drive(path, at, motion);
    const std::vector<Shift> steps = stepsOf(motion);
    at = steps.empty() ? at : after(at, steps.back());
  }
  return path;
}
}  // namespace traverse::navigation
