// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/sandbox/input_file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <byte_source.h>
#include <random>
#include <support/scratch_folder.h>
#include <support/synthetic_logs.h>

namespace
{
using namespace traverse;
using ::testing::HasSubstr;

struct Unpacked
{
  std::string bytes, damage;
  uint64_t offset = 0;
};

Unpacked unpack(const std::string& stored)
{
  const traverse::testing::ScratchFolder dir;
  traverse::testing::writeText(dir / "f", stored);
  const sandbox::InputFile file = sandbox::openInput(dir / "f");
  logs::ByteSource source(file.fd.get());
  Unpacked out;
  std::string some(777, '\0');
  for (size_t n = 1; n > 0;)
  {
    n = source.read(some.data(), some.size());
    out.bytes.append(some, 0, n);
  }
  out.damage = source.damage();
  out.offset = source.offset();
  return out;
}

/** Hardly compressible, and longer than the chunks that are read. */
std::string noise()
{
  std::mt19937 random(3);
  std::string bytes(200'000, '\0');
  for (char& c : bytes)
  {
    c = static_cast<char>(random());
  }
  bytes[0] = 'x';
  return bytes;
}

TEST(ByteSource, ReadsPlainAndPackedFiles)
{
  const std::string bytes = noise();
  for (const std::string& stored : {bytes, traverse::testing::gzipped(bytes)})
  {
    const Unpacked out = unpack(stored);
    EXPECT_EQ(out.bytes, bytes);
    EXPECT_EQ(out.damage, "");
    EXPECT_EQ(out.offset, stored.size());
  }
}

TEST(ByteSource, ReadsOneMemberAfterTheOther)
{
  const std::string bytes = noise();
  // Split where a chunk that is read ends in the middle of the second header, among others.
  for (const size_t split : {size_t{1}, size_t{65'000}, size_t{65'500}, size_t{100'000}})
  {
    const Unpacked out = unpack(
        traverse::testing::gzipped(bytes.substr(0, split)) +
        traverse::testing::gzipped(bytes.substr(split)));
    EXPECT_EQ(out.bytes, bytes);
    EXPECT_EQ(out.damage, "");
  }
}

TEST(ByteSource, KnowsACutFromAnEnd)
{
  const std::string bytes = noise();
  const std::string packed = traverse::testing::gzipped(bytes);
  for (const size_t kept : {packed.size() - 1, packed.size() - 8, packed.size() / 2, size_t{12}})
  {
    const Unpacked out = unpack(packed.substr(0, kept));
    EXPECT_THAT(out.damage, HasSubstr("cut short")) << kept;
    EXPECT_EQ(out.bytes, bytes.substr(0, out.bytes.size())) << "what came before it is good";
  }
}

TEST(ByteSource, ChecksTheSumAndWhatFollows)
{
  std::string packed = traverse::testing::gzipped(noise());
  packed[packed.size() - 8] = static_cast<char>(packed[packed.size() - 8] ^ 1);
  EXPECT_THAT(unpack(packed).damage, HasSubstr("corrupt"));
  EXPECT_THAT(unpack(traverse::testing::gzipped("abc") + "garbage").damage, HasSubstr("follows"));
}
}  // namespace
