// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/common_app/run_options.h>

#include <charconv>
#include <fmt/format.h>
#include <limits>
#include <system_error>

namespace traverse::app
{
namespace
{
/** CLI11 takes -1 and what is too large for the largest number, and 010 for 8. */
uint64_t seedOf(const std::string& text)
{
  uint64_t seed = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (error != std::errc{} || stop != text.data() + text.size())
  {
    throw CLI::ValidationError(
        "--seed", fmt::format(
                      "'{}': allowed: whole numbers from 0 to {}", text,
                      std::numeric_limits<uint64_t>::max()));
  }
  return seed;
}
}  // namespace

void declare(CLI::App& cli, const RunOptionTexts& texts, RunOptions& options)
{
  cli.add_option(texts.ini_name, options.ini, texts.ini);
  cli.add_option("--output", options.output, "folder to write")->type_name("DIR");
  cli.add_option_function<std::string>(
         "--seed", [&](const std::string& text) { options.seed = seedOf(text); }, texts.seed)
      ->type_name("N");
  cli.add_option("--set", options.assignments, "override one key; may be given many times")
      ->type_name("SECTION.KEY=VALUE")
      ->expected(1)
      ->take_all();
  cli.add_flag("--check-config", options.check_config, texts.check_config);
  cli.add_flag("--print-defaults", options.print_defaults, texts.print_defaults);
  cli.add_flag("--force", options.force, "replace an output folder that is there");
  cli.add_flag("--quiet", options.quiet, "no progress on stderr");
}

void check(const RunOptionTexts& texts, const RunOptions& options)
{
  if (options.print_defaults)
  {
    return;
  }
  if (options.ini.empty())
  {
    throw CLI::RequiredError(texts.ini_name);
  }
  if (options.output.empty() && !options.check_config)
  {
    throw CLI::RequiredError("--output");
  }
}
}  // namespace traverse::app
