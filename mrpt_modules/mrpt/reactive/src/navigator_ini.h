// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/reactive/reactive_driver.h>

#include <string>

namespace traverse::reactive
{
/** The ini text that MRPT's navigator reads: families of trajectories as the vehicle can drive
 * them, CHolonomicND in each. Throws options::OptionError. */
std::string navigatorIni(
    const geometry::Vehicle& vehicle,
    const geometry::Drivetrain& drivetrain,
    const ReactiveParams& params);

/** Most that it turns while it drives at full speed, deg/s: what its families are made for. */
double fullTurnDegps(const geometry::Drivetrain& drivetrain);
}  // namespace traverse::reactive
