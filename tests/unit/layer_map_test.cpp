// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/layer_map.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <support/base64.h>
#include <support/every_type.h>
#include <zlib.h>

namespace
{
using namespace traverse::formats;
using namespace traverse::testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using traverse::layers::LayerSet;

/** Bytes of a layer's data, inflated. */
std::string bytesOf(const nlohmann::json& layer, size_t size)
{
  const std::string packed = fromBase64(layer["data"]);
  std::string bytes(size + 1, '?');
  uLongf got = bytes.size();
  EXPECT_EQ(
      uncompress(
          reinterpret_cast<Bytef*>(bytes.data()), &got,
          reinterpret_cast<const Bytef*>(packed.data()), packed.size()),
      Z_OK);
  EXPECT_EQ(got, size);
  return bytes.substr(0, size);
}

/** Value i of a layer of `count`, as the page reads it. */
double valueOf(const nlohmann::json& layer, size_t count, size_t i)
{
  const std::string type = layer["type"];
  const size_t planes = type == "u8" ? 1 : type == "f24" ? 3 : 4;
  const std::string bytes = bytesOf(layer, planes * count);
  uint32_t bits = 0;
  for (size_t p = 0; p < planes; ++p)
  {
    const size_t shift = type == "u8" ? 0 : 8 * (4 - planes + p);
    bits |= uint32_t{static_cast<uint8_t>(bytes[p * count + i])} << shift;
  }
  return type[0] == 'u' ? bits : double{std::bit_cast<float>(bits)} + layer["base"].get<double>();
}

nlohmann::json parsed(const LayerSet& set, const LayerMapLimits& limits = {})
{
  return nlohmann::json::parse(layerMap(set, {}, limits).json);
}

TEST(LayerMap, HasTheKnownRectangleWithEveryValue)
{
  const LayerSet set = everyType({-1, -3});
  const auto json = parsed(set);
  EXPECT_EQ(json["x"], -1);
  EXPECT_EQ(json["y"], -3);
  EXPECT_EQ(json["width"], 3);
  EXPECT_EQ(json["height"], 2);
  EXPECT_EQ(json["step"], 1);
  ASSERT_EQ(json["layers"].size(), set.layers.size());
  for (size_t k = 0; k < set.layers.size(); ++k)
  {
    EXPECT_EQ(json["layers"][k]["name"], set.layers[k].name);
    for (size_t i = 0; i < 6; ++i)
    {
      const double expected =
          std::visit([&](const auto& v) { return double(v[i]); }, set.layers[k].data);
      const double got = valueOf(json["layers"][k], 6, i);
      EXPECT_EQ(std::isnan(got), std::isnan(expected)) << set.layers[k].name << i;
      if (!std::isnan(expected) && k < 3)
      {
        EXPECT_NEAR(got, expected, std::abs(expected) * 1.6e-5) << "16 significant bits";
      }
    }
  }
}

TEST(LayerMap, TimesAreExactToAMillisecondOfHours)
{
  LayerSet set = drawnClasses({"12"});
  set.layers.push_back({"last_seen_s", "s", std::vector<double>{1519637026.125, 1519644226.126}});
  EXPECT_NEAR(valueOf(parsed(set)["layers"][1], 2, 0), 1519637026.125, 1e-3);
  EXPECT_NEAR(valueOf(parsed(set)["layers"][1], 2, 1), 1519644226.126, 1e-3) << "two hours later";
}

TEST(LayerMap, EmptyBordersAreLeftOut)
{
  const auto json = parsed(drawnClasses({"....", ".2..", "...."}, {10, 20}));
  EXPECT_EQ(json["width"], 1);
  EXPECT_EQ(json["height"], 1);
  EXPECT_EQ(json["x"], 11);
  EXPECT_EQ(json["y"], 21);
}

TEST(LayerMap, LargeMapsAreCoarserAndSaySo)
{
  const LayerSet set = drawnClasses({"1111", "11.1", "1.41", "1111"}, {-2, 0});
  const LayerMap map = layerMap(set, {}, {4, 1U << 20U});
  EXPECT_THAT(map.caption, HasSubstr("2 x 2 cells"));
  const auto json = nlohmann::json::parse(map.json);
  EXPECT_EQ(json["step"], 2);
  EXPECT_EQ(valueOf(json["layers"][0], 4, 1), 4) << "an obstacle is not lost in its square";
  EXPECT_EQ(valueOf(json["layers"][0], 4, 2), 1);
}

TEST(LayerMap, ThePageTakesNoMoreThanItsBytes)
{
  LayerSet set = drawnClasses(std::vector<std::string>(100, std::string(100, '1')));
  std::vector<float> noise(10000);
  uint32_t state = 1;
  for (float& value : noise)
  {
    state = state * 1664525U + 1013904223U;
    value = static_cast<float>(state);
  }
  set.layers.push_back({"noise", "", noise});
  EXPECT_GT(layerMap(set, {}).json.size(), 20000U);
  EXPECT_LT(layerMap(set, {}, {1U << 20U, 10000}).json.size(), 11000U);
  EXPECT_EQ(parsed(set, {1U << 20U, 1})["width"], 1) << "at the worst one square";
}

TEST(LayerMap, AMapOfOneCellAndOneOfNone)
{
  EXPECT_EQ(parsed(drawnClasses({"3"}, {-7, 7}))["x"], -7);
  EXPECT_EQ(layerMap(drawnClasses({"."}), {}).json, "");
  EXPECT_EQ(layerMap({}, {}).json, "");
}

TEST(LayerMap, TrajectoriesAreThinnedToTheirEnd)
{
  std::vector<std::array<double, 3>> path(100000);
  for (size_t i = 0; i < path.size(); ++i)
  {
    path[i] = {0.001 * double(i), -1, 5};
  }
  const auto json = nlohmann::json::parse(layerMap(drawnClasses({"1"}), path).json);
  EXPECT_LT(json["path"].size(), 9000U);
  EXPECT_EQ(json["path"][json["path"].size() - 2], 100) << "99.999 m to the centimetre";
}

TEST(LayerMap, HostileTextsStayTexts)
{
  const std::string evil = "</script><!--<script>\xE2\x80\xA8\xff&\"";
  LayerSet set = drawnClasses({"1"});
  set.legend.push_back({9, evil, {}});
  set.layers.push_back({evil, evil, std::vector<float>{1}});
  Report report;
  report.sections.push_back({"s", {layerMap(set, {})}});
  const std::string page = html(report);
  const size_t data = page.find("application/json\">") + 18;
  const std::string json = page.substr(data, page.find("</script>", data) - data);
  EXPECT_THAT(json, Not(HasSubstr("<")));
  EXPECT_THAT(json, Not(HasSubstr("\xE2\x80\xA8"))) << "U+2028 ends a line in old scripts";
  EXPECT_EQ(
      nlohmann::json::parse(json)["layers"][1]["name"],
      "</script><!--<script>\xE2\x80\xA8\xEF\xBF\xBD&\"");
}

TEST(LayerMap, OnlyPagesWithAMapMayRunAScriptAndOnlyOurs)
{
  Report report;
  report.sections.push_back({"s", {Paragraph{"p"}}});
  EXPECT_THAT(html(report), Not(HasSubstr("script")));
  report.sections.push_back({"m", {layerMap(drawnClasses({"1"}), {})}});
  const std::string page = html(report);
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  EXPECT_THAT(page, HasSubstr("script-src 'sha256-"));
  EXPECT_THAT(page, Not(HasSubstr("script-src 'unsafe")));
  EXPECT_EQ(page, html(report));
}
}  // namespace
