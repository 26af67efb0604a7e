// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "navigator_ini.h"
#include "places.h"
#include "senses_interface.h"
#include "simulated_clock.h"
#include "watched_navigator.h"

#include <traverse/geometry/outline.h>
#include <traverse/reactive/reactive_driver.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <optional>

namespace traverse::reactive
{
namespace
{
// Further off than any map; squares of it are still numbers.
constexpr double kFarthest_m = 1e8;

// Corrections of a pose that are no jump.
constexpr double kJump_m = 0.2;

// Places of a plan that obstacles may stand on before there is no way.
constexpr int kMostSkipped = 2;

bool isSane(const Senses& senses)
{
  const double numbers[] = {
      senses.pose.x_m, senses.pose.y_m, senses.pose.yaw_rad, senses.motion.speed_mps,
      senses.motion.yaw_rate_radps};
  return std::all_of(
      std::begin(numbers), std::end(numbers), [](double n) { return std::abs(n) < kFarthest_m; });
}
}  // namespace

class ReactiveDriver::Impl
{
 public:
  Impl(
      const geometry::Vehicle& vehicle,
      const geometry::Drivetrain& drivetrain,
      const ReactiveParams& params,
      const std::filesystem::path& cache,
      const std::filesystem::path& log_folder) :
      vehicle_(vehicle),
      drivetrain_(drivetrain),
      params_(params),
      ini_(reactive::navigatorIni(vehicle, drivetrain, params)),
      senses_(vehicle.height_m),
      navigator_(makeNavigator(params.navigator, ini_, cache, senses_))
  {
    if (!log_folder.empty())
    {
      writeLog(*navigator_, log_folder);
    }
  }

  void follow(const std::vector<Eigen::Vector2d>& places)
  {
    places_ = Places(
        places, {.turning_radius = geometry::minTurningRadius_m(drivetrain_),
                 .tolerance = params_.waypoint_tolerance_m,
                 .goal_tolerance = params_.goal_tolerance_m,
                 .near = params_.waypoint_spacing_m + params_.waypoint_tolerance_m,
                 .half_width = geometry::halfWidth_m(vehicle_) + params_.grid_resolution_m});
    is_sent_ = false;
    has_arrived_ = false;
  }

  Command step(const Senses& senses)
  {
    if (places_.empty())
    {
      return {{}, Outcome::idle, "there is nothing to follow"};
    }
    if (has_arrived_)
    {
      return {{}, Outcome::arrived, ""};
    }
    if (!isSane(senses))
    {
      return {{}, Outcome::failed, "the pose or motion is none that a vehicle can have"};
    }
    if (!isContinued(senses))
    {
      navigator_->forgetPoses();
      is_sent_ = false;
    }
    last_ = {senses.now, senses.pose};
    if (places_.goOn(senses.pose, senses.obstacles))
    {
      is_sent_ = false;
    }
    if (places_.isOver(senses.pose))
    {
      has_arrived_ = true;
      return {{}, Outcome::arrived, ""};
    }
    const SimulatedClock clock(senses.now);
    senses_.show(senses);
    const Command command = outcomeOf(navigate(), senses);
    return command.outcome == Outcome::no_motion ? tryFurther(command, senses) : command;
  }

  const std::string& ini() const { return ini_; }

 private:
  /** Whether the vehicle can have come here from where it was in the last step. MRPT's navigator
   * takes the line between the two as its way, and what lies on it as reached. */
  bool isContinued(const Senses& senses) const
  {
    if (!last_ || senses.now <= last_->time)
    {
      return false;
    }
    const double most_m =
        kJump_m + 2 * drivetrain_.max_speed_mps * poses::secondsBetween(last_->time, senses.now);
    const double x_m = senses.pose.x_m - last_->pose.x_m;
    const double y_m = senses.pose.y_m - last_->pose.y_m;
    return x_m * x_m + y_m * y_m <= most_m * most_m;
  }

  /** One step of MRPT's navigator; what it threw or stopped for. */
  std::string navigate()
  {
    auto& navigator = navigator_->mrptNavigator();
    try
    {
      if (!is_sent_)
      {
        send(navigator);
      }
      navigator.navigationStep();
      if (navigator.getCurrentState() == mrpt::nav::CAbstractNavigator::IDLE)
      {
        send(navigator);  // it saw the goal on its way from the last step, and is beyond it now
        navigator.navigationStep();
      }
    }
    catch (const std::exception& error)
    {
      return error.what();
    }
    return senses_.events().error;
  }

  /** No motion to the next place, which an obstacle may stand on: if there is one to a place soon
   * after it, that is next. */
  Command tryFurther(const Command& standing, const Senses& senses)
  {
    const size_t next = places_.next();
    for (int n = 0; n < kMostSkipped && places_.skip(); ++n)
    {
      is_sent_ = false;
      senses_.show(senses);
      const Command command = outcomeOf(navigate(), senses);
      if (command.outcome == Outcome::driving)
      {
        return command;
      }
    }
    is_sent_ = is_sent_ && places_.next() == next;
    places_.goBackTo(next);
    return standing;
  }

  void send(mrpt::nav::CAbstractPTGBasedReactive& navigator)
  {
    mrpt::nav::TWaypointSequence sequence;
    for (size_t n = places_.next(); n < places_.size(); ++n)
    {
      const bool is_last = n + 1 == places_.size();
      sequence.waypoints.emplace_back(
          places_[n].x(), places_[n].y(),
          is_last ? params_.goal_tolerance_m : params_.waypoint_tolerance_m, false);
    }
    navigator.cancel();
    navigator.resetNavError();
    navigator.navigateWaypoints(sequence);
    is_sent_ = true;
  }

  Command outcomeOf(const std::string& error, const Senses& senses)
  {
    const StepEvents& events = senses_.events();
    const auto& navigator = navigator_->mrptNavigator();
    if (!error.empty() || navigator.getCurrentState() == mrpt::nav::CAbstractNavigator::NAV_ERROR)
    {
      is_sent_ = false;
      return {{}, Outcome::failed, error.empty() ? whyNot(senses) : error};
    }
    if (!events.twist)
    {
      return {{}, Outcome::no_motion, whyNot(senses)};
    }
    return {held(*events.twist, senses.speed_limit_mps), Outcome::driving, ""};
  }

  /** Why it finds no motion, or gave up. */
  std::string whyNot(const Senses& senses)
  {
    if (senses_.events().target_blocked)
    {
      return "an obstacle stands on the place that it drives to";
    }
    if (senses_.events().way_blocked)
    {
      return "it has come no nearer to the place that it drives to for 30 s";
    }
    const geometry::Outline outline = geometry::footprintOf(vehicle_);
    const auto inside = std::count_if(
        senses.obstacles.begin(), senses.obstacles.end(),
        [&](const Eigen::Vector3f& p)
        { return geometry::contains(outline, p.head<2>().cast<double>()); });
    return fmt::format(
        "no trajectory to the next place is free: {} obstacle points, {} of them in the outline",
        senses.obstacles.size(), inside);
  }

  /** Slowed down along its arc to what is allowed, and turning no tighter than a car can. */
  geometry::Twist2 held(geometry::Twist2 twist, double limit_mps) const
  {
    const double own_mps =
        twist.speed_mps < 0 ? drivetrain_.max_reverse_mps : drivetrain_.max_speed_mps;
    const double most_mps = limit_mps > 0 ? std::min(limit_mps, own_mps) : 0.0;  // NaN stands too
    const double speed_mps = std::abs(twist.speed_mps);
    if (speed_mps > most_mps)
    {
      twist.yaw_rate_radps *= most_mps / speed_mps;
      twist.speed_mps *= most_mps / speed_mps;
    }
    if (drivetrain_.steering == geometry::Steering::ackermann)
    {
      const double turn = std::abs(twist.speed_mps) / geometry::minTurningRadius_m(drivetrain_);
      twist.yaw_rate_radps = std::clamp(twist.yaw_rate_radps, -turn, turn);
    }
    return twist;
  }

  struct Seen
  {
    poses::TimeNs time;
    geometry::Pose2 pose;
  };

  geometry::Vehicle vehicle_;
  geometry::Drivetrain drivetrain_;
  ReactiveParams params_;
  std::string ini_;
  SensesInterface senses_;
  std::unique_ptr<WatchedNavigator> navigator_;
  Places places_;
  bool is_sent_ = false;
  bool has_arrived_ = false;
  std::optional<Seen> last_;
};

ReactiveDriver::ReactiveDriver(
    const geometry::Vehicle& vehicle,
    const geometry::Drivetrain& drivetrain,
    const ReactiveParams& params,
    const std::filesystem::path& cache,
    const std::filesystem::path& log_folder) :
    impl_(std::make_unique<Impl>(vehicle, drivetrain, params, cache, log_folder))
{
}

ReactiveDriver::~ReactiveDriver() = default;
ReactiveDriver::ReactiveDriver(ReactiveDriver&&) noexcept = default;
ReactiveDriver& ReactiveDriver::operator=(ReactiveDriver&&) noexcept = default;

void ReactiveDriver::follow(const std::vector<Eigen::Vector2d>& places)
{
  impl_->follow(places);
}

Command ReactiveDriver::step(const Senses& senses)
{
  return impl_->step(senses);
}

const std::string& ReactiveDriver::navigatorIni() const
{
  return impl_->ini();
}
}  // namespace traverse::reactive
