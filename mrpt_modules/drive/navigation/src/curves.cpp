// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/navigation/curves.h>

#include <cmath>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>

namespace traverse::navigation
{
namespace
{
using ompl::base::DubinsStateSpace;
using ompl::base::ReedsSheppStateSpace;
using ompl::base::SE2StateSpace;

/** A state of OMPL that frees itself. */
class State
{
 public:
  State(const SE2StateSpace& space, const geometry::Pose2& pose) :
      space_(space), state_(space.allocState()->as<SE2StateSpace::StateType>())
  {
    state_->setXY(pose.x_m, pose.y_m);
    state_->setYaw(pose.yaw_rad);
  }

  State(const State&) = delete;
  State& operator=(const State&) = delete;

  ~State() { space_.freeState(state_); }

  const SE2StateSpace::StateType* get() const { return state_; }

 private:
  const SE2StateSpace& space_;
  SE2StateSpace::StateType* state_;
};

geometry::Pose2 poseOf(const Posed& p)
{
  return {p.stand.place.x_m, p.stand.place.y_m, p.yaw_rad};
}
}  // namespace

struct Curves::Spaces
{
  explicit Spaces(double radius_m) : both_ways(radius_m), forward(radius_m) {}

  ReedsSheppStateSpace both_ways;
  DubinsStateSpace forward;
};

Curves::Curves(double radius_m, bool drives_backward) :
    radius_m_(radius_m),
    drives_backward_(drives_backward),
    spaces_(std::make_unique<Spaces>(radius_m))
{
}

Curves::~Curves() = default;
Curves::Curves(Curves&&) noexcept = default;
Curves& Curves::operator=(Curves&&) noexcept = default;

std::vector<std::vector<Motion>> Curves::to(
    const Posed& from, Place place, std::optional<double> yaw_rad) const
{
  std::vector<std::vector<Motion>> ways;
  if (!yaw_rad)
  {
    addArcAndLine(ways, from, place, false);
    if (drives_backward_)
    {
      addArcAndLine(ways, from, place, true);
    }
    return ways;
  }
  const geometry::Pose2 goal = {place.x_m, place.y_m, *yaw_rad};
  const State a(spaces_->forward, poseOf(from));
  const State b(spaces_->forward, goal);
  const DubinsStateSpace::DubinsPath forward = spaces_->forward.dubins(a.get(), b.get());
  ways.emplace_back();
  for (int k = 0; k < 3; ++k)
  {
    const int side = 1 - static_cast<int>(forward.type_[k]);  // left 1, straight 0, right -1
    ways.back().push_back({side / radius_m_, forward.length_[k] * radius_m_});
  }
  if (drives_backward_)
  {
    const ReedsSheppStateSpace::ReedsSheppPath both =
        spaces_->both_ways.reedsShepp(a.get(), b.get());
    ways.emplace_back();
    for (int k = 0; k < 5 && both.type_[k] != ReedsSheppStateSpace::RS_NOP; ++k)
    {
      const int side = 2 - static_cast<int>(both.type_[k]);
      ways.back().push_back({side / radius_m_, both.length_[k] * radius_m_});
    }
  }
  return ways;
}

double Curves::least_m(const Posed& from, const geometry::Pose2& to) const
{
  const State a(spaces_->forward, poseOf(from));
  const State b(spaces_->forward, to);
  return drives_backward_ ? spaces_->both_ways.distance(a.get(), b.get())
                          : spaces_->forward.distance(a.get(), b.get());
}

// The arc of a circle through the vehicle's origin, up to its tangent through the place. Backward,
// and to the right, it is the same in a mirror.
void Curves::addArcAndLine(
    std::vector<std::vector<Motion>>& ways, const Posed& from, Place place, bool is_backward) const
{
  const double dx = place.x_m - from.stand.place.x_m;
  const double dy = place.y_m - from.stand.place.y_m;
  const geometry::SinCos& yaw = from.stand.yaw;
  const double along = (dx * yaw.cos + dy * yaw.sin) * (is_backward ? -1 : 1);
  const double left = -dx * yaw.sin + dy * yaw.cos;
  for (const int side : {1, -1})
  {
    // From the circle's middle, which lies at (0, radius) of the mirrored frame.
    const double up = side * left - radius_m_;
    const double line_squared = along * along + up * up - radius_m_ * radius_m_;
    if (line_squared < 0)
    {
      continue;
    }
    const double line = std::sqrt(line_squared);
    const double turn = geometry::angleOf(up, along) + geometry::angleOf(radius_m_, line);
    const double arc = turn < -1e-12 ? turn + 2 * geometry::kPi : std::max(turn, 0.0);
    const double sign = is_backward ? -1 : 1;
    ways.push_back({{side / radius_m_, sign * arc * radius_m_}, {0, sign * line}});
  }
}
}  // namespace traverse::navigation
