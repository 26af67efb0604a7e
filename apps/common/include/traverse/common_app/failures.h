// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/common_app/exit_code.h>
#include <traverse/config/ini_document.h>
#include <traverse/formats/safe_file.h>

#include <exception>

namespace traverse::app
{
/** The exit code of run(), or of what it throws, after tell(kind, message): a configuration that
 * cannot be used, a file that cannot be written, and whatever else there is. What is input to a
 * program it catches itself. */
template <class Tell, class Run>
ExitCode reported(const Tell& tell, const Run& run)
{
  try
  {
    return run();
  }
  catch (const config::ConfigError& e)
  {
    tell("configuration", e.what());
    return ExitCode::configuration;
  }
  catch (const formats::FileError& e)
  {
    tell("file", e.what());
    return ExitCode::internal;
  }
  catch (const std::exception& e)
  {
    tell("internal error", e.what());
    return ExitCode::internal;
  }
}
}  // namespace traverse::app
