// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// traverse-inspect on maps: what they are, --diff, --why.
#include "support/traverse_inspect.h"
#include "support/traverse_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace
{
using namespace traverse::testing;
using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;

class InspectMaps : public ::testing::Test
{
 protected:
  /** Maps of one Velodyne turn: the same twice, with another threshold, with larger cells. */
  static void SetUpTestSuite()
  {
    scratch = new ScratchFolder;
    make("one", "traverse-map.title=one");
    make("same", "traverse-map.title=same");
    make("other", "Maps_CTraversabilityGridMap_00_insertOpts.large_max_deviation_m=0.4");
    make("larger", "Maps_CTraversabilityGridMap_00_insertOpts.cell_size_m=0.5");
  }

  static void make(const std::string& name, const std::string& setting)
  {
    const Finished ran = traverseMap(
        {ini("vlp16"), "--output", *scratch / name, "--set", "Vehicle.base_height_m=0", "--set",
         "traverse-map.pictures=false", "--set", setting});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
  }

  static void TearDownTestSuite()
  {
    delete scratch;
    scratch = nullptr;
  }

  static Finished diff(
      const std::string& a, const std::string& b, std::vector<std::string> more = {})
  {
    more.insert(more.begin(), {"--diff", *scratch / a, *scratch / b});
    return traverseInspect(more);
  }

  static inline ScratchFolder* scratch = nullptr;
};

TEST_F(InspectMaps, TellsWhatTheyAre)
{
  const Finished ran = traverseInspect({*scratch / "one"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(
      ran.out, AllOf(
                   HasSubstr("complete: true"), HasSubstr("map.traverse: traversability_grid"),
                   HasSubstr("cells of 0.25 m"), HasSubstr("layer traversability_class")));
  const json answer = json::parse(traverseInspect({*scratch / "one/map.traverse", "--json"}).out);
  EXPECT_EQ(
      answer["maps"][0]["cells_by_class"]["obstacle"],
      metricsOf(*scratch / "one")["maps"][0]["cells_by_class"]["obstacle"]);
}

TEST_F(InspectMaps, TheSameMapIsTheSame)
{
  const Finished ran = diff("one", "same");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(ran.out, HasSubstr("same\n"));
}

TEST_F(InspectMaps, AnotherThresholdIsADifferenceOfClassesOnly)
{
  const Finished ran = diff("one", "other", {"--json"});
  EXPECT_EQ(ran.exit_code, 1);
  for (const json& layer : json::parse(ran.out)["maps"][0]["layers"])
  {
    const bool height = layer["layer"] == "mean_height";
    EXPECT_TRUE(!height || layer["same"] == true) << layer;
    if (layer["layer"] == "traversability_class")
    {
      EXPECT_EQ(layer["same"], false);
      EXPECT_GT(layer["changed"], 0);
      EXPECT_EQ(layer["only_in_a"], 0);
    }
  }
  EXPECT_EQ(diff("one", "other", {"--cells-tolerance", "1"}).exit_code, 0);
  EXPECT_EQ(diff("one", "other", {"--cells-tolerance", "0.0001"}).exit_code, 1);
}

TEST_F(InspectMaps, MapsOfOtherCellsAreNotCompared)
{
  const Finished ran = diff("one", "larger");
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_THAT(ran.out, HasSubstr("not to be compared"));
}

TEST_F(InspectMaps, WhyIsThatOfTraverseMap)
{
  EXPECT_EQ(
      traverseInspect({"--why", "5.1,-2.3", *scratch / "one"}).out,
      traverseMap({"--why", "5.1,-2.3", *scratch / "one"}).out);
  EXPECT_EQ(traverseInspect({"--why", "5.1", *scratch / "one"}).exit_code, 2);
}

TEST_F(InspectMaps, DamagedArchivesAreRefused)
{
  std::string bytes = readText(*scratch / "one/map.traverse");
  bytes[bytes.size() / 2] ^= 1;
  writeText(*scratch / "bad.traverse", bytes);
  EXPECT_EQ(traverseInspect({*scratch / "bad.traverse"}).exit_code, 4);
  EXPECT_EQ(diff("one/map.traverse", "bad.traverse").exit_code, 4);
  EXPECT_EQ(diff("one", "nowhere").exit_code, 4);
}

TEST_F(InspectMaps, MetricsNestedDeeperThanAnyStackAreNoMetrics)
{
  constexpr size_t kDeep = 300'000;
  std::filesystem::create_directory(*scratch / "deep");
  std::filesystem::copy(*scratch / "one/map.traverse", *scratch / "deep/map.traverse");
  writeText(
      *scratch / "deep/metrics.json",
      "{\"problems\":[" + std::string(kDeep, '[') + std::string(kDeep, ']') + "]}");
  for (const char* format : {"--quiet", "--json"})
  {
    const Finished ran = traverseInspect({*scratch / "deep", format});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("traversability_grid"));
  }
}
}  // namespace
