// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/driven_velodyne.h"
#include "support/traverse_map.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace traverse::testing
{
inline const std::string kLaserLog = "2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog";
inline const std::string kInsert = "[Maps_CTraversabilityGridMap_00_insertOpts]\n";

/** An ini of one map that draws nothing. */
inline std::string iniOf(const std::string& source, const std::string& insert_options)
{
  return "[traverse-map]\nscene = false\npictures = false\n[Poses]\nsource = " + source +
         "\n[Maps]\nCTraversabilityGridMap_count = 1\n" + kInsert + insert_options;
}

/** Runs pieces and merges of them in a folder of its own. */
class TraverseMapPieces : public ::testing::Test
{
 protected:
  /** Maps into `folder`; the arguments come last. */
  Finished map(
      const std::string& folder,
      const std::string& log,
      const std::string& ini_text,
      std::vector<std::string> arguments = {}) const
  {
    const std::filesystem::path ini_file = scratch_ / (folder + ".ini");
    writeText(ini_file, ini_text);
    arguments.insert(
        arguments.begin(), {ini_file, "--rawlog", log, "--output", scratch_ / folder, "--quiet"});
    return traverseMap(arguments);
  }

  /** Maps piece k of n into folder "k". */
  void mapPiece(int k, int n, const std::string& log, const std::string& ini_text) const
  {
    const std::string piece = std::to_string(k) + "/" + std::to_string(n);
    const Finished ran = map(std::to_string(k), log, ini_text, {"--piece", piece});
    ASSERT_EQ(ran.exit_code, 0) << piece << ran.err;
  }

  Finished merge(const std::vector<std::string>& folders, const std::string& output) const
  {
    std::vector<std::string> arguments = {"--quiet", "--output", scratch_ / output, "--merge"};
    for (const std::string& folder : folders)
    {
      arguments.push_back(scratch_ / folder);
    }
    return traverseMap(arguments);
  }

  std::string archive(const std::string& folder) const
  {
    return readText(scratch_ / folder / "map.traverse");
  }

  /** Two pieces of the laser log in folders "1" and "2". */
  void mapTwoPieces() const
  {
    for (const int k : {1, 2})
    {
      mapPiece(k, 2, mrptData(kLaserLog), laserIni());
    }
  }

  static std::string laserIni() { return iniOf("odometry", "extent = growing\n"); }

  ScratchFolder scratch_;
};
}  // namespace traverse::testing
