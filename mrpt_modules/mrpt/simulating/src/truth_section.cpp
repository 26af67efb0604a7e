// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ini_sections.h"

#include <traverse/config/strict.h>
#include <traverse/simulating/truth_section.h>

#include <algorithm>
#include <fmt/format.h>
#include <functional>

namespace traverse::simulating
{
TruthSection readTruthSection(const config::IniDocument& ini)
{
  TruthSection section;
  config::load(ini, "Truth", section);
  const std::vector<double>& at_s = section.at_s;
  if (std::adjacent_find(at_s.begin(), at_s.end(), std::greater_equal<>()) != at_s.end())
  {
    throw config::ConfigError(
        fmt::format(
            "{}: [Truth] at_s = '{}': allowed: times that grow", ini.find("Truth", "at_s")->place,
            options::format(at_s)),
        "Truth", "at_s");
  }
  return section;
}

std::string truthText(const TruthSection& section)
{
  return wholeSection("Truth", section);
}
}  // namespace traverse::simulating
