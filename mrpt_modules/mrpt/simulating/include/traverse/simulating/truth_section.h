// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/config/ini_document.h>
#include <traverse/simulation/truth.h>

#include <string>
#include <vector>

namespace traverse::simulating
{
/** Section [Truth]: how cells are judged, and when. */
struct TruthSection
{
  simulation::TruthParams cells;
  std::vector<double> at_s;

  friend bool operator==(const TruthSection&, const TruthSection&) = default;
};

template <class P, class F>
void visitTruthSection(P& p, F&& f)
{
  visit(p.cells, f);
  f(
      options::Option{
          "at_s",
          "times since the beginning at which the truth is written, s, each later than the one "
          "before it; the last one's files have no time in their names; empty: the end of the "
          "recording",
          {0, 3600}},
      p.at_s);
}

template <class F>
void visit(TruthSection& p, F&& f)
{
  visitTruthSection(p, f);
}

template <class F>
void visit(const TruthSection& p, F&& f)
{
  visitTruthSection(p, f);
}

/** What an ini says; sections that are not its own are left to others. Throws config::ConfigError
 * with file and line for unknown keys, values out of range and times that do not grow. */
TruthSection readTruthSection(const config::IniDocument& ini);

/** The same as an ini, every key written out. */
std::string truthText(const TruthSection& section);
}  // namespace traverse::simulating
