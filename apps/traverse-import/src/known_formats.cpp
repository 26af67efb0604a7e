// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "known_formats.h"

#include "time_window.h"

#include <traverse/common_app/interrupt.h>
#include <traverse/importing/format.h>

namespace traverse::app
{
namespace
{
std::unique_ptr<importing::Source> openBag(const ImportCommand& command)
{
  const importing::ImportParams& params = command.params;
  if (!params.sensor_label.empty() || params.T_base_sensor || params.camera || params.rate_hz > 0)
  {
    throw importing::ImportError(
        "a bag has many sensors, with labels, poses and stamps of their own: --sensor-label, "
        "--sensor-pose, --camera and --rate-hz are not for it");
  }
  return std::make_unique<TimeWindow>(
      ros_bags::openBag(params.input, command.bag, &Interrupt::flag()), params.from_s, params.to_s);
}

std::vector<KnownFormat> makeFormats()
{
  std::vector<KnownFormat> formats = {{"ros-bag", "a ROS 1 bag", ros_bags::looksLikeBag, openBag}};
  for (const importing::Format& format : importing::allFormats())
  {
    formats.push_back(
        {format.name, format.what, format.recognises,
         [open = format.open](const ImportCommand& command) { return open(command.params); }});
  }
  return formats;
}
}  // namespace

const std::vector<KnownFormat>& knownFormats()
{
  static const std::vector<KnownFormat> formats = makeFormats();
  return formats;
}
}  // namespace traverse::app
