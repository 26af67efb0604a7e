// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace traverse::testing
{
/** cmake/arrows.txt: what each room may use. */
struct Arrows
{
  struct Room
  {
    std::set<std::string> rooms;      // itself and those it may use
    std::set<std::string> libraries;  // words of arrows.txt, those of its rooms included
  };

  std::map<std::string, Room> rooms;

  static Arrows read(const std::filesystem::path& file);
};

/** Every #include line under `root` that arrows.txt does not allow, as "file:line: what; where to
 * look". */
std::vector<std::string> forbiddenIncludes(const std::filesystem::path& root, const Arrows& arrows);
}  // namespace traverse::testing
