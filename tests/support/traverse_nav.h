// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/nav_app/app.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <support/scratch_folder.h>
#include <vector>

namespace traverse::testing
{
/** traverse-nav as a program would run it, in a folder of its own. */
class NavRun : public ::testing::Test
{
 protected:
  /** Quietly; `args` without the program's name. */
  static app::ExitCode run(std::vector<std::string> args)
  {
    args.insert(args.begin(), {"traverse-nav", "--quiet"});
    std::vector<const char*> argv;
    argv.reserve(args.size());
    for (const std::string& arg : args)
    {
      argv.push_back(arg.c_str());
    }
    return app::runNavApp(static_cast<int>(argv.size()), argv.data());
  }

  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  void write(const std::string& name, const std::string& bytes) const
  {
    std::ofstream(path(name), std::ios::binary) << bytes;
  }

  std::string bytes(const std::string& name) const
  {
    std::ifstream in(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

 private:
  ScratchFolder folder_;
};
}  // namespace traverse::testing
