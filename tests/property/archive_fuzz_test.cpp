// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/archive.h>
#include <traverse/formats/checksum.h>

#include <gtest/gtest.h>

#include <cstring>
#include <random>

namespace
{
using namespace traverse::formats;

std::string sample()
{
  ArchiveWriter writer("grid", 1);
  ByteWriter cells;
  cells.array(std::vector<float>(20, 1.5F));
  cells.str("hello");
  writer.section("CELL", cells.take());
  writer.section("TAIL", std::string(9, 'z'));
  return writer.finish();
}

/** What a map's reader does; true where everything was accepted. */
bool accepted(std::string_view bytes)
{
  try
  {
    const ArchiveReader reader(bytes, "grid", 1);
    ByteReader in = reader.reader("CELL");
    in.array<float>();
    in.str();
    in.expectEnd();
    reader.section("TAIL");
    return true;
  }
  catch (const FormatError&)
  {
    return false;
  }
}

/** A forger's archive: the last CRC fits again, so that the parser behind it is reached. */
void mendCrc(std::string& bytes)
{
  const uint32_t crc = crc32(std::string_view(bytes).substr(0, bytes.size() - 4));
  std::memcpy(bytes.data() + bytes.size() - 4, &crc, 4);
}

TEST(ArchiveFuzz, EveryFlippedBitIsNoticed)
{
  const std::string good = sample();
  ASSERT_TRUE(accepted(good));
  for (size_t bit = 0; bit < good.size() * 8; ++bit)
  {
    std::string bytes = good;
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1U << (bit % 8)));
    ASSERT_FALSE(accepted(bytes)) << "bit " << bit;
  }
}

TEST(ArchiveFuzz, EveryTruncationIsNoticed)
{
  const std::string good = sample();
  for (size_t size = 0; size < good.size(); ++size)
  {
    // A copy of its own, so that the address sanitizer sees a read beyond its end.
    const std::vector<char> part(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size));
    ASSERT_FALSE(accepted({part.data(), part.size()})) << size;
  }
}

TEST(ArchiveFuzz, LengthBombsAreRefusedWithoutAllocating)
{
  const std::string good = sample();
  const std::vector<uint64_t> bombs = {
      0xFFFFFFFFFFFFFFFFULL, 0x7FFFFFFFFFFFFFFFULL, 0xFFFFFFFFULL, 0x80000000ULL, 1ULL << 40U};
  for (size_t at = 20; at + 12 <= good.size(); ++at)
  {
    for (const uint64_t bomb : bombs)
    {
      std::string bytes = good;
      std::memcpy(bytes.data() + at, &bomb, sizeof bomb);
      mendCrc(bytes);
      // The section's own CRC stops what is inside one; the headers must stand by themselves.
      ASSERT_FALSE(accepted(bytes)) << "at " << at;
    }
  }
}

TEST(ArchiveFuzz, RandomDamageWithMendedChecksumsNeverCrashes)
{
  std::mt19937 random(20260101);
  const std::string good = sample();
  int refused = 0;
  for (int i = 0; i < 20000; ++i)
  {
    std::string bytes = good;
    for (int n = 0; n < 1 + i % 5; ++n)
    {
      bytes[20 + random() % (bytes.size() - 24)] = static_cast<char>(random());
    }
    mendCrc(bytes);
    refused += static_cast<int>(!accepted(bytes));
  }
  EXPECT_GT(refused, 19000) << "all but changes of a byte to itself, and of unread bytes";
}

TEST(ArchiveFuzz, RandomBytesInASectionNeverCrashItsReader)
{
  std::mt19937 random(7);
  for (int i = 0; i < 20000; ++i)
  {
    std::vector<char> bytes(random() % 64);
    for (char& c : bytes)
    {
      c = static_cast<char>(random() % 4 == 0 ? random() : 0);
    }
    ByteReader in({bytes.data(), bytes.size()}, "random");
    try
    {
      while (in.remaining() > 0)
      {
        const auto what = random() % 3;
        what == 0 ? (void)in.array<uint16_t>() : what == 1 ? (void)in.str() : (void)in.f64();
      }
    }
    catch (const FormatError&)
    {
      continue;
    }
  }
}
}  // namespace
