// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/frame2.h>
#include <traverse/nav_app/picture.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace traverse::app
{
namespace
{
using layers::Colour;
using navigation::Costmap;
using navigation::Passage;

constexpr Colour kUnknown = {124, 124, 124};  // a grey that films have, too
constexpr Colour kSoft = {252, 224, 178};
constexpr Colour kHard = {240, 150, 70};
constexpr Colour kObstacle = {20, 20, 24};
constexpr Colour kPlan = {0, 150, 60};
constexpr Colour kGoal = {190, 0, 150};
constexpr Colour kVehicle = {0, 70, 220};

uint8_t between(uint8_t from, uint8_t to, double share)
{
  return static_cast<uint8_t>(std::lround(from + (to - from) * std::clamp(share, 0.0, 1.0)));
}

Colour ofCell(const Costmap& costmap, size_t cell)
{
  switch (costmap.passage[cell])
  {
    case Passage::unknown:
      return kUnknown;
    case Passage::soft:
      return kSoft;
    case Passage::hard:
      return kHard;
    case Passage::obstacle:
      return kObstacle;
    case Passage::open:
      break;
  }
  const uint8_t grey = between(250, 150, (costmap.price[cell] - navigation::kLeastPrice) / 5);
  return {grey, grey, grey};
}

/** Blue where it creeps, red where it drives 2 m/s and more. */
Colour ofSpeed(double speed_mps)
{
  const double share = std::abs(speed_mps) / 2;
  return {between(30, 225, share), between(90, 30, share), between(230, 30, share)};
}

/** Draws places of the map frame into a picture. */
class Pen
{
 public:
  Pen(formats::Raster& raster, const Costmap& costmap, int cell_px) :
      raster_(raster),
      min_x_m_(costmap.lattice.edge_m(costmap.extent.min.x)),
      max_y_m_(costmap.lattice.edge_m(costmap.extent.max.y)),
      px_per_m_(cell_px / costmap.lattice.cell_m())
  {
  }

  /** A square of 3 x 3 pixels. */
  void dot(double x_m, double y_m, Colour colour)
  {
    const auto column = static_cast<int64_t>((x_m - min_x_m_) * px_per_m_);
    const auto row = static_cast<int64_t>((max_y_m_ - y_m) * px_per_m_);
    for (int64_t y = std::max<int64_t>(0, row - 1); y <= row + 1; ++y)
    {
      for (int64_t x = std::max<int64_t>(0, column - 1); x <= column + 1; ++x)
      {
        if (x < static_cast<int64_t>(raster_.width) && y < static_cast<int64_t>(raster_.height))
        {
          raster_.at(static_cast<size_t>(x), static_cast<size_t>(y)) = colour;
        }
      }
    }
  }

  void line(double x0_m, double y0_m, double x1_m, double y1_m, Colour colour)
  {
    const double dx = x1_m - x0_m;
    const double dy = y1_m - y0_m;
    const int steps = 1 + static_cast<int>(std::min(1e5, std::sqrt(dx * dx + dy * dy) * px_per_m_));
    for (int i = 0; i <= steps; ++i)
    {
      dot(x0_m + dx * i / steps, y0_m + dy * i / steps, colour);
    }
  }

 private:
  formats::Raster& raster_;
  double min_x_m_;
  double max_y_m_;
  double px_per_m_;
};

void drawVehicle(Pen& pen, const geometry::Vehicle& vehicle, const geometry::Pose2& pose)
{
  const geometry::Outline corners = geometry::Frame2::of(pose).out(geometry::footprintOf(vehicle));
  for (size_t i = 0; i < corners.size(); ++i)
  {
    const Eigen::Vector2d& a = corners[i];
    const Eigen::Vector2d& b = corners[(i + 1) % corners.size()];
    pen.line(a.x(), a.y(), b.x(), b.y(), kVehicle);
  }
}

void drawOver(Pen& pen, const PictureContent& content)
{
  constexpr double kRing_m = 0.4;
  if (content.plan != nullptr)
  {
    for (const navigation::PathPoint& point : content.plan->path)
    {
      pen.dot(point.pose.x_m, point.pose.y_m, kPlan);
    }
  }
  for (const DriveRecord& record : content.driven)
  {
    const simulation::VehicleState& v = record.vehicle;
    pen.dot(v.pose.x_m, v.pose.y_m, ofSpeed(v.twist.speed_mps));
  }
  for (const navigation::Goal& goal : content.goals)
  {
    for (int i = 0; i < 48; ++i)
    {
      const geometry::SinCos at = geometry::sinCosOf(i * geometry::kPi / 24);
      pen.dot(goal.x_m + kRing_m * at.cos, goal.y_m + kRing_m * at.sin, kGoal);
    }
  }
  if (content.vehicle != nullptr && !content.driven.empty())
  {
    drawVehicle(pen, *content.vehicle, content.driven.back().vehicle.pose);
  }
}
}  // namespace

formats::Raster costPicture(const Costmap& costmap, const PictureContent& content, int cell_px)
{
  if (costmap.size() == 0 || cell_px < 1)
  {
    throw std::invalid_argument("a picture of no costmap");
  }
  const auto scale = static_cast<size_t>(cell_px);
  const auto columns = static_cast<size_t>(costmap.extent.width());
  const auto rows = static_cast<size_t>(costmap.extent.height());
  formats::Raster raster(columns * scale, rows * scale);
  for (size_t y = 0; y < raster.height; ++y)
  {
    const size_t row = rows - 1 - y / scale;
    for (size_t x = 0; x < raster.width; ++x)
    {
      raster.at(x, y) = ofCell(costmap, row * columns + x / scale);
    }
  }
  Pen pen(raster, costmap, cell_px);
  drawOver(pen, content);
  return raster;
}

std::vector<layers::LegendEntry> costLegend()
{
  return {
      {0, "open (darker: dearer)", {250, 250, 250}},
      {1, "unknown", kUnknown},
      {2, "soft buffer", kSoft},
      {3, "hard buffer", kHard},
      {4, "obstacle", kObstacle},
      {5, "planned way", kPlan},
      {6, "driven, slow to fast", {128, 60, 130}},
      {7, "goal", kGoal},
      {8, "vehicle", kVehicle}};
}
}  // namespace traverse::app
