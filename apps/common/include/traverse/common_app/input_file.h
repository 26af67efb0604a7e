// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/formats/bytes.h>
#include <traverse/formats/safe_file.h>

namespace traverse::app
{
/** What `read` returns. A file that it cannot have is input here, not output: FormatError instead
 * of FileError, so that the exit code says so. */
template <class Read>
auto asInput(Read&& read)
{
  try
  {
    return read();
  }
  catch (const formats::FileError& e)
  {
    throw formats::FormatError(e.what());
  }
}
}  // namespace traverse::app
