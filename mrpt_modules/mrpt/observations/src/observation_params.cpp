// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/observations/observation_params.h>

#include <sstream>

namespace traverse::observations
{
void checkTogether(const ObservationParams& params)
{
  using options::format;
  using options::OptionError;
  if (params.max_range_m <= params.min_range_m)
  {
    throw OptionError("max_range_m", format(params.max_range_m), "more than min_range_m");
  }
  const std::vector<double>& low = params.own_body_min_m;
  const std::vector<double>& high = params.own_body_max_m;
  if (low.size() != high.size() || (!low.empty() && low.size() != 3))
  {
    throw OptionError(
        "own_body_min_m", format(low), "three numbers, as many as own_body_max_m, or none");
  }
  for (size_t i = 0; i < low.size(); ++i)
  {
    if (high[i] < low[i])
    {
      throw OptionError("own_body_max_m", format(high), "not below own_body_min_m");
    }
  }
}

bool hasLabel(const std::string& list, const std::string& label)
{
  std::istringstream words(list);
  for (std::string word; words >> word;)
  {
    if (word == label)
    {
      return true;
    }
  }
  return false;
}
}  // namespace traverse::observations
