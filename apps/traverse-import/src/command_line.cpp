// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"

#include "known_formats.h"

#include <traverse/common_app/parse.h>
#include <traverse/formats/decimal.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <numbers>

namespace traverse::app
{
namespace
{
constexpr const char* kExits =
    "Example: traverse-import sequences/00 --output 00.rawlog\n"
    "Rings and times of points, which a rawlog has no place for, go to LOG.rawlog.channels; keep "
    "it "
    "beside the log.\n"
    "Exit codes: 0 done, 1 internal or output cannot be written, 2 usage, 4 input unreadable, 5 "
    "partial (damaged\n"
    "parts were left out, and are named), 130/143 interrupted (what was imported is saved). "
    "doc/import.md says more.";

std::string footer()
{
  std::string text = "Formats:\n";
  for (const KnownFormat& format : knownFormats())
  {
    text += fmt::format("  {:<16} {}\n", format.name, format.what);
  }
  return text + kExits;
}

/** Numbers with commas between, exactly n. */
std::vector<double> numbers(const std::string& option, const std::string& text, size_t n)
{
  std::vector<double> values;
  size_t begin = 0;
  while (begin <= text.size())
  {
    const size_t end = std::min(text.find(',', begin), text.size());
    const auto value = formats::parseNumber(std::string_view(text).substr(begin, end - begin));
    if (!value || std::abs(*value) > 1e6)
    {
      throw CLI::ValidationError(option, "'" + text + "' are not numbers with commas between");
    }
    values.push_back(*value);
    begin = end + 1;
  }
  if (values.size() != n)
  {
    throw CLI::ValidationError(option, fmt::format("wants {} numbers", n));
  }
  return values;
}

/** Yaw about z, then pitch about y, then roll about x, as MRPT has it. */
Eigen::Isometry3d sensorPose(const std::string& text)
{
  const std::vector<double> v = numbers("--sensor-pose", text, 6);
  const auto turn = [&](size_t i, const Eigen::Vector3d& axis)
  { return Eigen::AngleAxisd(v[i] * std::numbers::pi / 180, axis); };
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() = Eigen::Vector3d(v[0], v[1], v[2]);
  T.linear() = (turn(3, Eigen::Vector3d::UnitZ()) * turn(4, Eigen::Vector3d::UnitY()) *
                turn(5, Eigen::Vector3d::UnitX()))
                   .toRotationMatrix();
  return T;
}

poses::TimeNs startTime(const std::string& text)
{
  constexpr poses::TimeNs k1980 = 315'532'800'000'000'000;
  constexpr poses::TimeNs k2100 = 4'102'444'800'000'000'000;
  const auto time = formats::parseSecondsAsNs(text);
  if (!time || *time < k1980 || *time >= k2100)
  {
    throw CLI::ValidationError("--start-time", "wants seconds since 1970, of 1980 to 2100");
  }
  return *time;
}

void declareSensor(CLI::App& cli, importing::ImportParams& params)
{
  cli.add_option("--sensor-label", params.sensor_label, "label of the range sensor's observations")
      ->check([](const std::string& label)
              { return label.size() <= 64 ? "" : "is longer than 64 bytes"; });
  cli.add_option_function<std::string>(
         "--sensor-pose", [&](const std::string& text) { params.T_base_sensor = sensorPose(text); },
         "where the range sensor sits on the vehicle, m and deg")
      ->type_name("X,Y,Z,YAW,PITCH,ROLL");
  cli.add_option_function<std::string>(
         "--camera",
         [&](const std::string& text)
         {
           const std::vector<double> v = numbers("--camera", text, 4);
           params.camera = {v[0], v[1], v[2], v[3]};
         },
         "pinhole of RGB-D images, pixels")
      ->type_name("FX,FY,CX,CY");
}

void declareTimes(CLI::App& cli, importing::ImportParams& params)
{
  cli.add_option(
         "--rate-hz", params.rate_hz, "of clouds and images without stamps (10; 7-scenes 30)")
      ->check(CLI::Range(0.001, 1e6));
  cli.add_option_function<std::string>(
         "--start-time", [&](const std::string& text) { params.start = startTime(text); },
         "of recordings without a clock, seconds since 1970 (2000-01-01)")
      ->type_name("S");
  cli.add_option(
         "--from", params.from_s, "leave out what is earlier, s after the first observation")
      ->check(CLI::Range(0.0, 1e9));
  cli.add_option("--to", params.to_s, "leave out that time and what is later, s")
      ->check(CLI::Range(0.0, 1e9));
}

void declareBag(CLI::App& cli, ros_bags::BagParams& bag)
{
  cli.add_option(
      "--base-frame", bag.base_frame, "tf frame of the vehicle in a ROS bag (base_link ...)");
  cli.add_option("--topics", bag.topics, "topics of a ROS bag to import, blanks between (all)");
}

void declare(CLI::App& cli, ImportCommand& command)
{
  cli.add_option("INPUT", command.params.input, "file or folder of the recording")->required();
  cli.add_option("--output", command.output, "the log to write")
      ->type_name("LOG.rawlog")
      ->required();
  cli.add_option("--format", command.format, "one of those below; auto: by what INPUT looks like")
      ->check(
          [](const std::string& name)
          {
            const auto& all = knownFormats();
            const bool known = std::any_of(
                all.begin(), all.end(),
                [&](const KnownFormat& format) { return format.name == name; });
            return name == "auto" || known ? "" : "'" + name + "' is none of the formats";
          });
  declareSensor(cli, command.params);
  declareTimes(cli, command.params);
  declareBag(cli, command.bag);
  cli.add_flag("--force", command.force, "replace a log that is there");
  cli.add_flag("--quiet", command.quiet, "no progress on stderr");
  cli.set_version_flag("--version", "traverse-import " TRAVERSE_VERSION);
  cli.footer(footer());
}
}  // namespace

Parsed<ImportCommand> parseImportCommand(int argc, const char* const* argv)
{
  ImportCommand command;
  CLI::App cli("Recordings of other layouts as an MRPT rawlog.", "traverse-import");
  declare(cli, command);
  return parse(
      cli, argc, argv, command,
      [&]
      {
        if (command.output.filename().empty())
        {
          throw CLI::ValidationError("--output", "names no file");
        }
        if (!(command.params.from_s < command.params.to_s))
        {
          throw CLI::ValidationError("--to", "is not after --from");
        }
      });
}
}  // namespace traverse::app
