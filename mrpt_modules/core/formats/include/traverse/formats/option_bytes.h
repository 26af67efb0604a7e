// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/formats/bytes.h>
#include <traverse/options/option.h>

#include <string>
#include <vector>

namespace traverse::formats
{
/** Options as keys and values, for archives: u32 count, then key and value of each (str). A key
 * that is not there keeps its default when read, so that options may be added later. */
template <class P>
std::string optionBytes(const P& p)
{
  ByteWriter out;
  const std::vector<options::Row> rows = options::rows(p);
  out.u32(static_cast<uint32_t>(rows.size()));
  for (const options::Row& row : rows)
  {
    out.str(row.key);
    out.str(row.value);
  }
  return out.take();
}

/** The reverse, of bytes that may be hostile. Throws FormatError for unknown keys and for values
 * that are not allowed. */
template <class P>
P readOptionBytes(ByteReader in)
{
  constexpr size_t kLongestKey = 256;
  constexpr size_t kLongestValue = 65536;
  P p;
  const uint32_t count = in.u32();
  for (uint32_t i = 0; i < count; ++i)
  {
    const std::string key = in.str(kLongestKey);
    const std::string value = in.str(kLongestValue);
    bool known = false;
    try
    {
      known = options::set(p, key, value);
    }
    catch (const options::OptionError& e)
    {
      in.fail(e.what());
    }
    if (!known)
    {
      in.fail("unknown option '" + key + "'");
    }
  }
  in.expectEnd();
  return p;
}
}  // namespace traverse::formats
