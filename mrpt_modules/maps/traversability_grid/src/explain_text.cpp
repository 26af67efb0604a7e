// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "explain_text.h"

#include <traverse/geometry/lattice.h>
#include <traverse/options/option.h>
#include <traverse/options/untrusted_text.h>

#include <algorithm>
#include <cmath>

namespace traverse::traversability_grid
{
std::string metres(double value)
{
  return options::format(
             std::round(value * geometry::kMillimetresPerMetre) / geometry::kMillimetresPerMetre) +
         " m";
}

std::string shortly(double value)
{
  if (!std::isfinite(value) || value == 0)
  {
    return value == 0 ? "0" : "none";
  }
  constexpr int kDigits = 4;
  const double scale =
      std::pow(10, kDigits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value)))));
  return options::format(std::round(value * scale) / scale);
}

std::string seconds(poses::TimeNs time)
{
  constexpr int64_t kNsPerS = 1'000'000'000;
  std::string decimals = std::to_string(geometry::floorMod(time, kNsPerS));
  decimals.insert(0, 9 - decimals.size(), '0');
  return std::to_string(geometry::floorDiv(time, kNsPerS)) + "." + decimals + " s since 1970";
}

std::string sensorsOf(const std::vector<std::string>& labels, uint32_t bits)
{
  std::string all;
  for (size_t i = 0; i < labels.size(); ++i)
  {
    if ((bits >> i & 1U) == 1)
    {
      all += (all.empty() ? " by " : ", ") +
             (labels[i].empty() ? "a sensor without label" : labels[i]);
    }
  }
  return options::printable(all);
}
}  // namespace traverse::traversability_grid
