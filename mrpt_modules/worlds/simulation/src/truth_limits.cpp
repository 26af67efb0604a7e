// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "truth_limits.h"

#include <traverse/geometry/lattice.h>

namespace traverse::simulation
{
int32_t checkedCell_mm(const TruthParams& params)
{
  options::check(params);
  const auto increasing = [](std::string_view key, double value, double before)
  {
    if (!(value > before))
    {
      throw options::OptionError(
          key, options::format(value), "more than the limit before it, " + options::format(before));
    }
  };
  increasing("small_max_m", params.small_max_m, params.flat_max_m);
  increasing("large_max_m", params.large_max_m, params.small_max_m);
  const auto cell_mm = static_cast<int32_t>(geometry::toMillimetres(params.cell_size_m));
  if (geometry::Lattice{cell_mm}.cell_m() != params.cell_size_m)
  {
    throw options::OptionError(
        "cell_size_m", options::format(params.cell_size_m), "whole millimetres");
  }
  return cell_mm;
}
}  // namespace traverse::simulation
