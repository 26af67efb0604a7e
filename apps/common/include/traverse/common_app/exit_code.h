// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace traverse::app
{
/** What a program of the suite says by its exit code. */
enum class ExitCode : int
{
  done = 0,
  internal = 1,       //!< a fault of the program, or output that cannot be written
  usage = 2,          //!< command line
  configuration = 3,  //!< ini file
  unreadable = 4,     //!< the input is missing, foreign, or holds nothing that can be used
  partial = 5,        //!< the input is damaged; what came before the damage was saved
  interrupted = 130,  //!< SIGINT; what was finished was saved
  terminated = 143,   //!< SIGTERM; what was finished was saved
};
}  // namespace traverse::app
