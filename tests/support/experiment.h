// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

namespace traverse::testing
{
/** The figures one on a line, then all as one JSON object, which is what the last line must be. */
inline void print(const nlohmann::ordered_json& figures)
{
  for (const auto& [key, value] : figures.items())
  {
    std::cout << key << " " << value.dump() << "\n";
  }
  std::cout << figures.dump() << "\n";
}

/** What main() of an experiment returns: run()'s, or 4 with a word on stderr for what it throws. */
template <class Run>
int reported(const char* name, const Run& run)
{
  try
  {
    return run();
  }
  catch (const std::exception& e)
  {
    std::fputs((std::string(name) + ": " + e.what() + "\n").c_str(), stderr);
    return 4;
  }
}
}  // namespace traverse::testing
