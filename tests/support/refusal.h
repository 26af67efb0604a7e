// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/formats/archive.h>

#include <string>

namespace traverse::testing
{
/** Why reading refuses bytes: what a FormatError says; "accepted" where there is none. */
template <class Read>
std::string refusalOf(Read&& read)
{
  try
  {
    read();
  }
  catch (const formats::FormatError& e)
  {
    return e.what();
  }
  return "accepted";
}
}  // namespace traverse::testing
