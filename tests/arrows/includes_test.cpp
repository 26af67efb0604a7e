// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/arrows.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace
{
namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using traverse::testing::Arrows;
using traverse::testing::forbiddenIncludes;

const fs::path kRoot = TRAVERSE_SOURCE_DIR;

Arrows arrows()
{
  return Arrows::read(kRoot / "cmake" / "arrows.txt");
}

/** A tree with one file, as a newcomer might write it. */
fs::path treeWith(const std::string& file, const std::string& text)
{
  const fs::path root = fs::path(::testing::TempDir()) / "arrows_tree";
  fs::remove_all(root);
  fs::create_directories(root / "apps");
  fs::create_directories(root / "mrpt_modules");
  fs::create_directories((root / file).parent_path());
  std::ofstream(root / file) << text;
  return root;
}

TEST(Arrows, EveryIncludeOfTheTreeIsAllowed)
{
  EXPECT_THAT(forbiddenIncludes(kRoot, arrows()), IsEmpty());
}

TEST(Arrows, MrptInGeometryIsRefusedAndSaysWhereToLook)
{
  const fs::path root = treeWith(
      "mrpt_modules/core/geometry/src/x.cpp",
      "#include <vector>\n#include <mrpt/poses/CPose3D.h>\n");
  EXPECT_THAT(
      forbiddenIncludes(root, arrows()), ElementsAre(AllOf(
                                             HasSubstr("core/geometry/src/x.cpp:2:"),
                                             HasSubstr("MRPT"), HasSubstr("doc/architecture.md"))));
}

TEST(Arrows, ARoomAboveIsRefused)
{
  const fs::path root = treeWith(
      "mrpt_modules/core/points/include/traverse/points/x.h",
      "#include <traverse/layers/layer_set.h>\n");
  EXPECT_THAT(
      forbiddenIncludes(root, arrows()),
      ElementsAre(HasSubstr("room 'points' may not use layers")));
}

TEST(Arrows, MapsReachMrptOnlyInTheirShell)
{
  const std::string include = "#include <mrpt/maps/CMetricMap.h>\n";
  const std::string map = "mrpt_modules/maps/traversability_grid";
  EXPECT_THAT(forbiddenIncludes(treeWith(map + "/mrpt/x.cpp", include), arrows()), IsEmpty());
  EXPECT_THAT(
      forbiddenIncludes(treeWith(map + "/src/x.cpp", include), arrows()),
      ElementsAre(HasSubstr("MRPT")));
}

TEST(Arrows, AppsReachMapsOnlyByIniName)
{
  const fs::path root =
      treeWith("apps/traverse-map/x.cpp", "#include <traverse/traversability_grid/params.h>\n");
  EXPECT_THAT(
      forbiddenIncludes(root, arrows()), ElementsAre(HasSubstr("may not use traversability_grid")));
}
}  // namespace
