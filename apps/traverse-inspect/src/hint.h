// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

namespace traverse::app
{
/** How much a hint means. */
enum class Weight
{
  fine,      //!< looked at, nothing wrong
  open,      //!< the log cannot tell
  fact,      //!< to know, perhaps to put into the ini
  suspicion  //!< probably wrong
};

/** Something that the log says of its own set-up. */
struct Hint
{
  std::string key;    //!< for programs: "ground_lean"
  std::string about;  //!< a sensor, "poses", or "log"
  Weight weight = Weight::fact;
  std::string text;
  std::map<std::string, double> values;  //!< the figures in the text, by name with unit
};

using Hints = std::vector<Hint>;
}  // namespace traverse::app
