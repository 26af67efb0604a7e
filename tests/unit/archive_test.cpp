// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/archive.h>
#include <traverse/formats/checksum.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
using namespace traverse::formats;
using ::testing::HasSubstr;

std::string sample(uint32_t version = 3)
{
  ArchiveWriter writer("grid", version);
  ByteWriter head;
  head.i32(-200);
  head.str("metres");
  writer.section("HEAD", head.take());
  ByteWriter cells;
  cells.array(std::vector<uint32_t>{1, 2, 4'000'000'000U});
  writer.section("CELL", cells.take());
  return writer.finish();
}

std::string errorOf(std::string_view bytes, std::string_view kind = "grid", uint32_t newest = 3)
{
  try
  {
    const ArchiveReader reader(bytes, kind, newest);
  }
  catch (const FormatError& e)
  {
    return e.what();
  }
  return "";
}

TEST(Archive, GivesBackWhatWasWritten)
{
  const std::string bytes = sample();
  const ArchiveReader reader(bytes, "grid", 3);
  EXPECT_EQ(reader.version(), 3U);
  EXPECT_TRUE(reader.has("CELL"));
  EXPECT_FALSE(reader.has("cell"));
  ByteReader head = reader.reader("HEAD");
  EXPECT_EQ(head.i32(), -200);
  EXPECT_EQ(head.str(), "metres");
  EXPECT_NO_THROW(head.expectEnd());
  EXPECT_EQ(reader.reader("CELL").array<uint32_t>(), (std::vector<uint32_t>{1, 2, 4'000'000'000U}));
}

TEST(Archive, SameSectionsGiveTheSameBytes)
{
  EXPECT_EQ(sample(), sample());
}

TEST(Archive, LayoutIsPinned)
{
  ArchiveWriter writer("k", 7);
  writer.section("ABCD", "xy");
  const std::string bytes = writer.finish();
  const std::string expected(
      "\x89TRAV\r\n\x1a"
      "\x01\0\0\0"
      "\x37\0\0\0\0\0\0\0"
      "\x01\0\0\0k"
      "\x07\0\0\0"
      "\x01\0\0\0"
      "ABCD\x02\0\0\0\0\0\0\0",
      8 + 4 + 8 + 5 + 4 + 4 + 12);
  EXPECT_EQ(bytes.substr(0, expected.size()), expected);
  EXPECT_EQ(bytes.size(), 0x37U);
}

TEST(Archive, NewerContentIsRefusedNamingBothVersions)
{
  EXPECT_THAT(errorOf(sample(5)), HasSubstr("version 5, this program knows up to 3"));
}

TEST(Archive, NewerLayoutIsRefusedNamingBothVersions)
{
  std::string bytes = sample();
  bytes[8] = 9;
  EXPECT_THAT(errorOf(bytes), HasSubstr("layout version 9, this program knows up to 1"));
}

TEST(Archive, OlderContentIsTheCallersToRead)
{
  EXPECT_EQ(errorOf(sample(1)), "");
}

TEST(Archive, AnotherKindIsRefusedNamingBoth)
{
  EXPECT_EQ(errorOf(sample(), "surface"), "archive holds a 'grid', not a 'surface'");
}

TEST(Archive, TruncationIsToldFromDamage)
{
  const std::string bytes = sample();
  EXPECT_EQ(
      errorOf(bytes.substr(0, 60)),
      "archive truncated: 60 of " + std::to_string(bytes.size()) + " bytes are there");
  EXPECT_THAT(errorOf(bytes + "x"), HasSubstr("1 bytes follow the end"));
}

TEST(Archive, DamageNamesTheSectionAndTheByte)
{
  std::string bytes = sample();
  bytes[bytes.size() - 6] ^= 1;  // last byte of CELL
  EXPECT_THAT(errorOf(bytes), HasSubstr("section 'CELL' at byte"));
}

TEST(Archive, WhatIsNoArchiveIsSaidToBeNone)
{
  EXPECT_THAT(errorOf(""), HasSubstr("empty"));
  EXPECT_THAT(errorOf("PK\x03\x04 something else"), HasSubstr("not a Traverse archive"));
}

TEST(Archive, AMissingSectionIsNamed)
{
  const std::string bytes = sample();
  const ArchiveReader reader(bytes, "grid", 3);
  try
  {
    reader.section("NONE");
    FAIL() << "no section is there, and one came back";
  }
  catch (const FormatError& e)
  {
    EXPECT_STREQ(e.what(), "archive of a 'grid' has no section 'NONE'");
  }
}

TEST(Archive, SectionNamesAreFourBytesAndUnique)
{
  ArchiveWriter writer("k", 1);
  EXPECT_THROW(writer.section("TOOLONG", ""), std::invalid_argument);
  writer.section("SAME", "");
  EXPECT_THROW(writer.section("SAME", ""), std::invalid_argument);
}

TEST(ByteReader, KeepsNumbersExactly)
{
  ByteWriter out;
  out.u8(255);
  out.u16(65535);
  out.u64(std::numeric_limits<uint64_t>::max());
  out.i64(std::numeric_limits<int64_t>::min());
  out.f32(-0.1F);
  out.f64(std::nan(""));
  const std::string bytes = out.bytes();
  EXPECT_EQ(bytes.size(), 31U);
  ByteReader in(bytes);
  EXPECT_EQ(in.u8(), 255);
  EXPECT_EQ(in.u16(), 65535);
  EXPECT_EQ(in.u64(), std::numeric_limits<uint64_t>::max());
  EXPECT_EQ(in.i64(), std::numeric_limits<int64_t>::min());
  EXPECT_EQ(in.f32(), -0.1F);
  EXPECT_TRUE(std::isnan(in.f64()));
}

TEST(ByteReader, ReadingBeyondTheEndSaysWhere)
{
  ByteReader in("abc", "file.x", 100);
  in.u8();
  try
  {
    in.u32();
    FAIL() << "4 bytes out of 2";
  }
  catch (const FormatError& e)
  {
    EXPECT_STREQ(e.what(), "file.x, byte 101: 4 bytes are needed, 2 are left");
  }
}

TEST(ByteReader, ACountIsCheckedBeforeAnythingIsAllocated)
{
  ByteWriter out;
  out.u64(std::numeric_limits<uint64_t>::max() / 2);
  out.u64(7);
  const std::string bytes = out.bytes();
  EXPECT_THROW(ByteReader(bytes).array<double>(), FormatError);
  ByteWriter text;
  text.u32(0xFFFFFFFFU);
  EXPECT_THROW(ByteReader(text.bytes()).str(), FormatError);
}

TEST(Checksum, IsTheUsualCrc32)
{
  EXPECT_EQ(crc32("123456789"), 0xCBF43926U);
}
}  // namespace
