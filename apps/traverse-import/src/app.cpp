// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"
#include "known_formats.h"
#include "summary.h"

#include <traverse/common_app/failures.h>
#include <traverse/common_app/interrupt.h>
#include <traverse/common_app/progress.h>
#include <traverse/formats/bytes.h>
#include <traverse/formats/safe_file.h>
#include <traverse/import_app/app.h>
#include <traverse/importing/log_writer.h>

#include <algorithm>
#include <fmt/format.h>
#include <iostream>

namespace traverse::app
{
namespace
{
using importing::ImportError;

void tell(const std::string& kind, const std::string& message)
{
  fmt::print(stderr, "traverse-import: {}: {}\n", kind, forTerminal(message));
}

const KnownFormat& formatOf(const ImportCommand& command)
{
  const std::filesystem::path& input = command.params.input;
  if (!std::filesystem::exists(input))
  {
    throw ImportError(input.string() + ": no such file or folder");
  }
  if (!std::filesystem::is_regular_file(input) && !std::filesystem::is_directory(input))
  {
    throw ImportError(input.string() + ": is neither a file nor a folder");
  }
  const std::vector<KnownFormat>& all = knownFormats();
  const auto format = std::find_if(
      all.begin(), all.end(),
      [&](const KnownFormat& known) {
        return command.format == "auto" ? known.recognises(input) : known.name == command.format;
      });
  if (format == all.end())
  {
    throw ImportError(input.string() + ": is of no layout that is known; --format names one");
  }
  if (command.format == "auto" && !command.quiet)
  {
    tell("format", fmt::format("{} ({})", format->name, format->what));
  }
  return *format;
}

/** Files that cannot be read are here a fault of the input. */
std::unique_ptr<importing::Source> openSource(const ImportCommand& command)
{
  try
  {
    return formatOf(command).open(command);
  }
  catch (const formats::FileError& e)
  {
    throw ImportError(e.what());
  }
}

/** Everything, or what came before an interruption. Returns the number of observations. */
uint64_t copyAll(importing::Source& source, importing::LogWriter& log, bool quiet)
{
  Progress progress("importing", "observations", quiet);
  uint64_t count = 0;
  while (!Interrupt::flag())
  {
    const std::optional<importing::Entry> entry = source.next();
    if (!entry)
    {
      break;
    }
    log.add(*entry);
    progress.show(source.progress(), ++count);
  }
  progress.finish(count);
  return count;
}

ExitCode importIt(const ImportCommand& command)
{
  const Interrupt interrupt;
  const auto source = openSource(command);
  importing::LogWriter log(command.output, command.force);
  const uint64_t count = copyAll(*source, log, command.quiet);
  tellProblems(source->report());
  if (count == 0)
  {
    tell("input", command.params.input.string() + ": nothing in it could be imported");
    return Interrupt::exitCode().value_or(ExitCode::unreadable);
  }
  log.commit();
  std::cout << command.output.string() << "\n" << summaryOf(source->report());
  if (log.hasChannels())
  {
    std::cout << "rings and times of points: " << formats::channelsFileOf(command.output).string()
              << "\n";
  }
  const ExitCode verdict = source->report().damage.empty() ? ExitCode::done : ExitCode::partial;
  return Interrupt::exitCode().value_or(verdict);
}

/** A log must not replace what it is made of. */
bool isItsOwnInput(const ImportCommand& command)
{
  std::error_code failed;
  return std::filesystem::equivalent(command.params.input, command.output, failed);
}

ExitCode runCommand(const ImportCommand& command)
{
  if (isItsOwnInput(command))
  {
    tell("error", "--output is the input itself");
    return ExitCode::usage;
  }
  return importIt(command);
}
}  // namespace

ExitCode runImportApp(int argc, const char* const* argv)
{
  return reported(
      tell,
      [&]
      {
        try
        {
          const Parsed<ImportCommand> parsed = parseImportCommand(argc, argv);
          return parsed.command ? runCommand(*parsed.command) : parsed.exit_code;
        }
        catch (const ImportError& e)
        {
          tell("input", e.what());
        }
        catch (const formats::FormatError& e)
        {
          tell("input", e.what());
        }
        return ExitCode::unreadable;
      });
}
}  // namespace traverse::app
