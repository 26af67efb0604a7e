// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// PCD and PLY as PCL's tools read them, value by value.
#include <traverse/formats/cloud_export.h>
#include <traverse/formats/safe_file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <support/command.h>
#include <support/data.h>
#include <support/every_type.h>
#include <support/scratch_folder.h>

namespace
{
using namespace traverse::formats;
using namespace traverse::testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using traverse::layers::LayerSet;

/** What PCL writes as text: names of the fields, and per point their values. */
struct AsText
{
  std::string fields;
  std::vector<std::vector<double>> points;
};

AsText asText(const std::filesystem::path& pcd)
{
  const std::string ascii = pcd.string() + ".txt";
  outputOf("pcl_convert_pcd_ascii_binary " + pcd.string() + " " + ascii + " 0 17");
  std::istringstream all(readText(ascii));
  AsText text;
  std::string line;
  while (std::getline(all, line) && line != "DATA ascii")
  {
    text.fields = line.rfind("FIELDS", 0) == 0 ? line : text.fields;
  }
  while (std::getline(all, line))
  {
    std::istringstream row(line);
    text.points.emplace_back();
    for (std::string value; row >> value;)
    {
      text.points.back().push_back(std::strtod(value.c_str(), nullptr));
    }
  }
  return text;
}

/** The same number, or both none. */
MATCHER_P(Is, expected, "")
{
  return arg == expected || (std::isnan(arg) && std::isnan(static_cast<double>(expected)));
}

/** Layers of everyType() from `column` on. */
void expectLayers(const AsText& text, size_t column)
{
  const LayerSet set = everyType({-1, -3});
  ASSERT_EQ(text.points.size(), 5U);
  for (size_t i = 0; i < 5; ++i)
  {
    ASSERT_EQ(text.points[i].size(), column + set.layers.size());
    for (size_t k = 0; k < set.layers.size(); ++k)
    {
      const double expected =
          std::visit([&](const auto& v) { return double(v[i]); }, set.layers[k].data);
      EXPECT_THAT(text.points[i][column + k], Is(expected)) << set.layers[k].name << " of " << i;
    }
  }
}

TEST(PclTools, ReadEveryValueOfThePcd)
{
  TRAVERSE_NEEDS("/usr/bin/pcl_convert_pcd_ascii_binary");
  const ScratchFolder folder;
  writeFile(folder / "map.pcd", pcdCloud(everyType({-1, -3})));
  const AsText text = asText(folder / "map.pcd");
  EXPECT_EQ(
      text.fields,
      "FIELDS x y z rgb cell_x cell_y traversability_class height_mean point_count last_seen_s");
  expectLayers(text, 6);
  EXPECT_THAT(
      std::vector<double>(text.points[0].begin(), text.points[0].begin() + 6),
      ElementsAre(-0.1F, -0.5F, 1.5F, 0xBE96DC, -1, -3));
}

TEST(PclTools, ReadThePly)
{
  TRAVERSE_NEEDS("/usr/bin/pcl_ply2pcd");
  const ScratchFolder folder;
  writeFile(folder / "map.ply", plyCloud(everyType({-1, -3})));
  outputOf("pcl_ply2pcd " + (folder / "map.ply").string() + " " + (folder / "map.pcd").string());
  const AsText text = asText(folder / "map.pcd");
  EXPECT_THAT(text.fields, HasSubstr("traversability_class height_mean point_count last_seen_s"));
  ASSERT_EQ(text.points.size(), 5U);
  expectLayers(text, text.points[0].size() - 4);
}

TEST(PclTools, MakeAPlyOfThePcd)
{
  TRAVERSE_NEEDS("/usr/bin/pcl_pcd2ply");
  const ScratchFolder folder;
  writeFile(folder / "map.pcd", pcdCloud(drawnClasses({"1"})));
  outputOf("pcl_pcd2ply " + (folder / "map.pcd").string() + " " + (folder / "map.ply").string());
  EXPECT_THAT(readText(folder / "map.ply"), HasSubstr("element vertex 1\n"));
}
}  // namespace
