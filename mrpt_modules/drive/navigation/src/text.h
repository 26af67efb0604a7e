// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/options/option.h>

#include <cmath>
#include <string>

namespace traverse::navigation
{
/** A number for people, to three decimals. */
inline std::string inShort(double value)
{
  constexpr double kScale = 1000;
  if (!std::isfinite(value))
  {
    return std::isnan(value) ? "unknown" : "without limit";
  }
  return options::format(std::round(value * kScale) / kScale);
}
}  // namespace traverse::navigation
