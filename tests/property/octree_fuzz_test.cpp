// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/bytes.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <support/octree_points.h>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using formats::FormatError;
using ::testing::HasSubstr;

constexpr size_t kFew = 1'000'000;

std::string sample(bool binary)
{
  std::mt19937 random(20260301);
  const formats::PointOctree octree = octreeOf(randomPoints(random, 60, 0.5));
  return binary ? octree.bt() : octree.ot();
}

/** "" where the bytes are taken. A copy of its own, so that a read beyond the end is seen. */
std::string refusal(std::string_view bytes)
{
  const std::vector<char> own(bytes.begin(), bytes.end());
  try
  {
    formats::readOctree({own.data(), own.size()}, kFew);
    return "";
  }
  catch (const FormatError& e)
  {
    return e.what();
  }
}

std::string file(const std::string& size, const std::string& res, const std::string& data)
{
  return "# Octomap OcTree binary file\nid OcTree\nsize " + size + "\nres " + res + "\ndata\n" +
         data;
}

TEST(OctreeFuzz, EveryTruncationIsNoticed)
{
  for (const bool binary : {true, false})
  {
    const std::string good = sample(binary);
    ASSERT_EQ(refusal(good), "");
    for (size_t size = 0; size < good.size(); ++size)
    {
      ASSERT_NE(refusal(good.substr(0, size)), "") << size;
    }
    EXPECT_THAT(refusal(good + "x"), HasSubstr("follow the end"));
  }
}

TEST(OctreeFuzz, RandomDamageNeverCrashes)
{
  std::mt19937 random(5);
  int refused = 0;
  for (int i = 0; i < 20000; ++i)
  {
    std::string bytes = sample(i % 2 == 0);
    for (int n = 0; n < 1 + i % 4; ++n)
    {
      bytes[random() % bytes.size()] = static_cast<char>(random());
    }
    refused += static_cast<int>(!refusal(bytes).empty());
  }
  EXPECT_GT(refused, 10000) << "changes of comments and log-odds pass";
}

TEST(OctreeFuzz, RandomTreesNeverCrash)
{
  std::mt19937 random(6);
  for (int i = 0; i < 20000; ++i)
  {
    std::string data(random() % 200, '\0');
    for (char& c : data)
    {
      c = static_cast<char>(random() % 3 == 0 ? 0xFF : random());
    }
    refusal(file(std::to_string(1 + random() % 100), "0.1", data));
    std::string full = file("9", "0.1", data);
    full.erase(full.find(" binary"), 7);
    refusal(full);
  }
}

TEST(OctreeFuzz, ATreeDeeperThanAnyIsRefused)
{
  // 0xC000: the last child is a node of its own. OctoMap's reader recurs as long as there are
  // bytes.
  std::string deep;
  for (int i = 0; i < 100000; ++i)
  {
    deep += std::string("\x00\xC0", 2);
  }
  EXPECT_THAT(refusal(file("100000", "0.1", deep)), HasSubstr("below the finest"));
}

TEST(OctreeFuzz, AFewBytesThatFillTheSpaceAreRefusedWithoutAllocating)
{
  EXPECT_THAT(refusal(file("9", "0.1", "\xAA\xAA")), HasSubstr("at most 1000000"));
}

TEST(OctreeFuzz, HeadersThatLieAreRefused)
{
  const std::string leaf("\x01\x00", 2);  // a free one
  EXPECT_THAT(refusal(""), HasSubstr("not an octree"));
  EXPECT_THAT(refusal(file("3", "0.1", leaf)), HasSubstr("damaged"));
  EXPECT_THAT(refusal(file("18446744073709551615", "0.1", "")), HasSubstr("needed"));
  EXPECT_THAT(refusal(file("-1", "0.1", leaf)), HasSubstr("size"));
  EXPECT_THAT(refusal(file("2", "0", leaf)), HasSubstr("resolution"));
  EXPECT_THAT(refusal(file("2", "nan", leaf)), HasSubstr("resolution"));
  EXPECT_THAT(refusal(file("2", "1e999", leaf)), HasSubstr("res"));
  EXPECT_THAT(refusal(file("2", "", leaf)), HasSubstr("res"));
  EXPECT_THAT(refusal(file("0", "0.1", leaf)), HasSubstr("follow the end"));
  std::string colour = sample(false);
  colour.replace(colour.find("id OcTree"), 9, "id ColorOcTree");
  EXPECT_THAT(refusal(colour), HasSubstr("another type"));
  std::string endless = "# Octomap OcTree file\n" + std::string(1000000, '#');
  EXPECT_THAT(refusal(endless), HasSubstr("no end"));
  EXPECT_EQ(refusal(file("0", "0.1", "")), "") << "an octree without nodes is one";
}

TEST(OctreeFuzz, DamagedBytesOfACopyAreRefusedOrSafe)
{
  std::mt19937 random(7);
  const std::string good = sample(true);
  for (int i = 0; i < 5000; ++i)
  {
    std::string bytes = good;
    bytes[random() % bytes.size()] = static_cast<char>(random());
    try
    {
      formats::PointOctree octree = formats::PointOctree::fromBt(bytes, {0.1, 1});
      octree.insert(scanOf(randomPoints(random, 10)).view(), Eigen::Isometry3d::Identity());
      EXPECT_FALSE(octree.ot().empty());
    }
    catch (const FormatError&)
    {
      continue;
    }
  }
}
}  // namespace
