// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/options/option.h>

#include <stdexcept>
#include <string>

namespace traverse::simulation
{
/** Throws OptionError with the number. */
[[noreturn]] inline void refuse(const std::string& key, double value, const std::string& allowed)
{
  throw options::OptionError(key, options::format(value), allowed);
}

/** Calls f(); what it throws gets the section in front. */
template <class F>
auto inSection(const std::string& section, F&& f)
{
  try
  {
    return f();
  }
  catch (const std::exception& e)
  {
    throw std::runtime_error("[" + section + "] " + e.what());
  }
}
}  // namespace traverse::simulation
