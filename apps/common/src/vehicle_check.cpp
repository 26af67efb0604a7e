// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/common_app/vehicle_check.h>
#include <traverse/config/ini_document.h>

namespace traverse::app
{
void checkVehicle(const geometry::Vehicle& vehicle)
{
  const size_t corners = vehicle.footprint_xs_m.size();
  if (vehicle.footprint_ys_m.size() != corners || corners < 3)
  {
    throw config::ConfigError(
        "[Vehicle] footprint_xs_m and footprint_ys_m need as many corners, at least 3");
  }
}
}  // namespace traverse::app
