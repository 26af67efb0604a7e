// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "watcher.h"

#include <traverse/nav_app/picture.h>

#include <algorithm>

namespace traverse::app
{
namespace
{
constexpr int kCell_px = 2;
constexpr int kShownCs = 12;  // a picture, hundredths of a second
}  // namespace

Watcher::Watcher(const NavSettings& settings, bool quiet) :
    settings_(settings), progress_("driving", "steps", quiet)
{
}

void Watcher::see(const Pilot& pilot, const DriveResult& so_far)
{
  const DriveRecord& record = so_far.records.back();
  steps_ = so_far.records.size();
  progress_.show(std::min(1.0, record.t_s / settings_.run.max_time_s), steps_);
  const double every_s = settings_.run.frames_every_s;
  if (every_s <= 0 || record.t_s < next_frame_s_ || pilot.costmap().size() == 0)
  {
    return;
  }
  next_frame_s_ = record.t_s + every_s;
  const formats::Raster frame = costPicture(
      pilot.costmap(), {so_far.records, &pilot.plan(), {}, &settings_.robot.vehicle}, kCell_px);
  if (!film_)
  {
    film_.emplace(static_cast<int>(frame.width), static_cast<int>(frame.height), kShownCs);
  }
  film_->add(frame);
}

void Watcher::finish(formats::OutputFolder& folder)
{
  progress_.finish(steps_);
  if (film_)
  {
    folder.write("drive.gif", film_->take());
  }
}
}  // namespace traverse::app
