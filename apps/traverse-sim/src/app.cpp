// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"
#include "outputs.h"
#include "part.h"
#include "part_store.h"
#include "settings.h"

#include <traverse/common_app/failures.h>
#include <traverse/common_app/interrupt.h>
#include <traverse/common_app/progress.h>
#include <traverse/config/ini_document.h>
#include <traverse/formats/safe_file.h>
#include <traverse/sim_app/app.h>
#include <traverse/simulating/defaults.h>

#include <algorithm>
#include <fmt/format.h>
#include <iostream>
#include <thread>

namespace traverse::app
{
namespace
{
using Events = std::vector<simulation::Recording::Planned>;
using simulation::Recording;

void tell(const std::string& kind, const std::string& message)
{
  fmt::print(stderr, "traverse-sim: {}: {}\n", kind, message);
}

const std::string& labelOf(
    const Recording::Planned& event, const simulation::RecordingParams& params)
{
  if (event.sensor < params.lidars.size())
  {
    return params.lidars[event.sensor].label;
  }
  return event.sensor == params.lidars.size() ? params.ins.label : params.odometry.label;
}

/** All events by the part that they arrive in; counts them. */
std::vector<Events> plannedParts(
    Recording& recording, const simulation::RecordingParams& params, SimRun& run)
{
  constexpr auto kPartNs = static_cast<poses::TimeNs>(kPartSeconds * 1e9);
  std::vector<Events> parts(1);
  while (const auto event = recording.plan())
  {
    const auto part = static_cast<size_t>((event->arrival - simulation::kRecordingStart) / kPartNs);
    parts.resize(std::max(parts.size(), part + 1));
    parts[part].push_back(*event);
    ++run.observations[labelOf(*event, params)];
  }
  return parts;
}

/** All that are not there yet; false where a signal came first. */
bool makeParts(
    const Recording& recording,
    const SimSettings& settings,
    const std::vector<Events>& parts,
    const SimCommand& command,
    const PartStore& store)
{
  const auto processors = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const int threads = command.threads > 0 ? command.threads : processors;
  Progress progress("simulating", "observations", command.quiet);
  uint64_t done = 0;
  for (size_t i = 0; i < parts.size(); ++i)
  {
    if (!store.has(i))
    {
      const Part part = makePart(recording, settings.recording, parts[i], threads);
      if (Interrupt::flag())
      {
        return false;
      }
      store.put(i, part);
    }
    done += parts[i].size();
    progress.show(static_cast<double>(i + 1) / static_cast<double>(parts.size()), done);
  }
  progress.finish(done);
  return true;
}

/** All that the parts of a run depend on. */
std::string madeOf(const SimSettings& settings, uint64_t seed)
{
  return fmt::format(
      "// traverse-sim {}, seed {}, parts of {} s\n{}{}", TRAVERSE_VERSION, seed, kPartSeconds,
      settings.files, settings.text);
}

ExitCode simulate(const SimCommand& command, const SimSettings& settings)
{
  const Interrupt interrupt;
  formats::OutputFolder folder(
      command.output, command.force ? formats::Overwrite::replace : formats::Overwrite::refuse);
  Recording recording(settings.scene, settings.recording, command.seed);
  SimRun run;
  run.seed = command.seed;
  run.duration_s = recording.durationSeconds();
  const std::vector<Events> parts = plannedParts(recording, settings.recording, run);
  run.parts = parts.size();
  const PartStore store(folder.finalPath(), madeOf(settings, command.seed));
  if (!makeParts(recording, settings, parts, command, store))
  {
    tell("interrupted", "the same command goes on where it was");
    return Interrupt::exitCode().value_or(ExitCode::interrupted);
  }
  std::cout << writeOutputs(folder, store, settings, recording, run);
  store.remove();
  return ExitCode::done;
}

ExitCode runCommand(const SimCommand& command)
{
  if (command.print_defaults)
  {
    std::cout << simulating::defaultsText();
    return ExitCode::done;
  }
  const SimSettings settings = readSettings(command);
  if (command.check_config)
  {
    return ExitCode::done;
  }
  return simulate(command, settings);
}
}  // namespace

ExitCode runSimApp(int argc, const char* const* argv)
{
  return reported(
      tell,
      [&]
      {
        const Parsed<SimCommand> parsed = parseSimCommand(argc, argv);
        return parsed.command ? runCommand(*parsed.command) : parsed.exit_code;
      });
}
}  // namespace traverse::app
