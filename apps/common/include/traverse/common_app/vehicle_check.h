// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/vehicle.h>

namespace traverse::app
{
/** What no single key of [Vehicle] can say. Throws config::ConfigError. */
void checkVehicle(const geometry::Vehicle& vehicle);
}  // namespace traverse::app
