// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "strip.h"

#include "refuse.h"

#include <algorithm>
#include <cmath>

namespace traverse::simulation
{
namespace
{
constexpr double kLongest_m = 1e6;
}  // namespace

std::vector<Segment> lineThrough(
    const std::vector<double>& xs_m, const std::vector<double>& ys_m, const std::string& keys)
{
  if (xs_m.size() != ys_m.size() || xs_m.size() < 2)
  {
    throw options::OptionError(
        keys, std::to_string(xs_m.size()) + " x, " + std::to_string(ys_m.size()) + " y",
        "two corners or more, as many x as y");
  }
  std::vector<Segment> line(xs_m.size() - 1);
  double length_m = 0;
  for (size_t i = 0; i + 1 < xs_m.size(); ++i)
  {
    const Eigen::Vector2d from(xs_m[i], ys_m[i]);
    const Eigen::Vector2d step = Eigen::Vector2d(xs_m[i + 1], ys_m[i + 1]) - from;
    const double step_m = std::sqrt(step.x() * step.x() + step.y() * step.y());
    if (!(step_m > 0) || step_m > kLongest_m)
    {
      refuse(keys, xs_m[i + 1], "corners within 1000 km that differ from the one before");
    }
    line[i] = {from, step / step_m, step_m, length_m};
    length_m += step_m;
  }
  return line;
}

AlongLine alongLine(std::span<const Segment> segments, double line_m, const Eigen::Vector2d& place)
{
  AlongLine best;
  for (const Segment& s : segments)
  {
    const double dx = place.x() - s.from.x();
    const double dy = place.y() - s.from.y();
    const double along = dx * s.unit.x() + dy * s.unit.y();
    const double left = dy * s.unit.x() - dx * s.unit.y();
    const double on = std::clamp(along, 0.0, s.length_m);
    const double beyond = along - on;
    const double square = left * left + beyond * beyond;
    if (square < best.square_m2)
    {
      const bool first = s.begins_m == 0 && along < 0;
      const bool last = along > s.length_m && s.begins_m + s.length_m >= line_m;
      // at a bend's outer side the distance to the corner counts, beyond the ends that to the line
      const double aside = first || last ? std::abs(left) : std::sqrt(square);
      best = {s.begins_m + (first || last ? along : on), left < 0 ? -aside : aside, square};
    }
  }
  return best;
}

bool mayReach(const Segment& segment, double reach_m, const Area& area)
{
  const Eigen::Vector2d middle(
      (area.min_x_m + area.max_x_m) / 2, (area.min_y_m + area.max_y_m) / 2);
  const double half_x = (area.max_x_m - area.min_x_m) / 2;
  const double half_y = (area.max_y_m - area.min_y_m) / 2;
  const double whole = reach_m + std::sqrt(half_x * half_x + half_y * half_y);
  const Segment one{segment.from, segment.unit, segment.length_m, 0};
  const AlongLine where = alongLine({&one, 1}, segment.length_m, middle);
  const Eigen::Vector2d to = segment.from + segment.unit * segment.length_m;
  const bool boxes_meet = std::min(segment.from.x(), to.x()) - reach_m <= area.max_x_m &&
                          std::max(segment.from.x(), to.x()) + reach_m >= area.min_x_m &&
                          std::min(segment.from.y(), to.y()) - reach_m <= area.max_y_m &&
                          std::max(segment.from.y(), to.y()) + reach_m >= area.min_y_m;
  return boxes_meet && where.square_m2 <= whole * whole;
}

double lengthOf(const std::vector<Segment>& line)
{
  return line.back().begins_m + line.back().length_m;
}

const Segment& segmentAt(const std::vector<Segment>& line, double along_m)
{
  const auto after = std::upper_bound(
      line.begin() + 1, line.end(), along_m,
      [](double m, const Segment& s) { return m < s.begins_m; });
  return *(after - 1);
}

Eigen::Vector2d placeAlong(const std::vector<Segment>& line, double along_m)
{
  const Segment& s = segmentAt(line, along_m);
  return s.from + s.unit * (along_m - s.begins_m);
}
}  // namespace traverse::simulation
