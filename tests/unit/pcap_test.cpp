// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/data.h"
#include "support/pcap_bytes.h"

#include <traverse/formats/pcap.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <string>
#include <unistd.h>
#include <vector>
#include <zlib.h>

namespace traverse::testing
{
namespace
{
using ::testing::HasSubstr;
using traverse::formats::PcapEnd;
using traverse::formats::PcapReader;
using traverse::formats::PcapReport;

/** A file that is gone with the test. */
class PcapFile : public ::testing::Test
{
 protected:
  ~PcapFile() override { std::filesystem::remove(path_); }

  std::filesystem::path write(const Bytes& bytes)
  {
    std::ofstream(path_, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<long>(bytes.size()));
    return path_;
  }

  std::filesystem::path writeGz(const Bytes& bytes)
  {
    gzFile gz = gzopen(path_.c_str(), "wb");
    gzwrite(gz, bytes.data(), static_cast<unsigned>(bytes.size()));
    gzclose(gz);
    return path_;
  }

  /** Why a file is refused; empty where it is not. */
  static std::string refusal(const std::filesystem::path& path)
  {
    try
    {
      const PcapReader reader(path);
      return {};
    }
    catch (const std::runtime_error& error)
    {
      return error.what();
    }
  }

  static PcapReport readAll(const std::filesystem::path& path)
  {
    PcapReader reader(path);
    while (reader.next())
    {
    }
    return reader.report();
  }

  std::filesystem::path path_ = std::filesystem::temp_directory_path() /
                                ("traverse_pcap_" + std::to_string(::getpid()) + ".pcap");
};

TEST_F(PcapFile, YieldsTimePortAndPayload)
{
  Bytes bytes = fileHeader(1);
  append(bytes, record(ethernet(ipv4_type, udpInIp(sample_payload))));
  PcapReader reader(write(bytes));
  const auto datagram = reader.next();
  ASSERT_TRUE(datagram);
  EXPECT_EQ(datagram->time, 1'600'000'000'000'500'000);
  EXPECT_EQ(datagram->destination_port, 2368);
  EXPECT_EQ(Bytes(datagram->payload.begin(), datagram->payload.end()), sample_payload);
  EXPECT_FALSE(reader.next());
  EXPECT_EQ(reader.report().end, PcapEnd::clean);
  EXPECT_EQ(reader.report().message, "");
  EXPECT_FALSE(reader.next()) << "the end stays the end";
}

TEST_F(PcapFile, MayBeBigEndianWithNanoseconds)
{
  Bytes bytes = fileHeader(101, 0xA1B23C4D, true);
  append(bytes, record(udpInIp(sample_payload), 999'999'999, true));
  PcapReader reader(write(bytes));
  const auto datagram = reader.next();
  ASSERT_TRUE(datagram);
  EXPECT_EQ(datagram->time, 1'600'000'000'999'999'999);
}

TEST_F(PcapFile, MayBeGzipped)
{
  Bytes bytes = fileHeader(1);
  append(bytes, record(ethernet(ipv4_type, udpInIp(sample_payload))));
  const PcapReport report = readAll(writeGz(bytes));
  EXPECT_EQ(report.datagrams, 1U);
  EXPECT_EQ(report.end, PcapEnd::clean);
}

TEST_F(PcapFile, MayHaveVlanTagsOrLinuxCookedFrames)
{
  Bytes bytes = fileHeader(1);
  append(bytes, record(ethernet({0x88, 0xA8, 0, 1, 0x81, 0, 0, 2, 8, 0}, udpInIp(sample_payload))));
  EXPECT_EQ(readAll(write(bytes)).datagrams, 1U);
  bytes = fileHeader(113);
  Bytes cooked(14, 0);
  append(cooked, ipv4_type);
  append(cooked, udpInIp(sample_payload));
  append(bytes, record(cooked));
  EXPECT_EQ(readAll(write(bytes)).datagrams, 1U);
}

TEST_F(PcapFile, HasItsFragmentsAndOtherProtocolsSkippedAndCounted)
{
  Bytes bytes = fileHeader(1);
  append(bytes, record(ethernet(ipv4_type, udpInIp(sample_payload, 0x20))));
  append(bytes, record(ethernet({0x86, 0xDD}, Bytes(60))));
  append(bytes, record({}));
  Bytes tcp = udpInIp(sample_payload);
  tcp[9] = 6;
  append(bytes, record(ethernet(ipv4_type, tcp)));
  append(bytes, record(ethernet(ipv4_type, udpInIp(sample_payload))));
  const PcapReport report = readAll(write(bytes));
  EXPECT_EQ(report.records, 5U);
  EXPECT_EQ(report.fragments, 1U);
  EXPECT_EQ(report.other, 3U);
  EXPECT_EQ(report.datagrams, 1U);
}

TEST_F(PcapFile, SaysWhereItIsCut)
{
  Bytes whole = fileHeader(1);
  append(whole, record(ethernet(ipv4_type, udpInIp(sample_payload))));
  const size_t second = whole.size();
  append(whole, record(ethernet(ipv4_type, udpInIp(sample_payload))));
  for (size_t size = second + 1; size < whole.size(); ++size)
  {
    const PcapReport report =
        readAll(write(Bytes(whole.begin(), whole.begin() + static_cast<long>(size))));
    ASSERT_EQ(report.end, PcapEnd::truncated) << size;
    ASSERT_EQ(report.datagrams, 1U);
    ASSERT_EQ(report.offset, second);
    ASSERT_THAT(report.message, HasSubstr("at byte " + std::to_string(second)));
  }
}

TEST_F(PcapFile, SaysWhereItIsCorrupt)
{
  Bytes bytes = fileHeader(1);
  append(bytes, record(Bytes(10)));
  Bytes absurd = record(Bytes(10));
  absurd[11] = 0x7F;
  append(bytes, absurd);
  PcapReport report = readAll(write(bytes));
  EXPECT_EQ(report.end, PcapEnd::corrupt);
  EXPECT_THAT(report.message, HasSubstr("at byte 50: a record of 2130706442 bytes"));
  bytes = fileHeader(1);
  append(bytes, record(Bytes(10), 1'000'000));
  report = readAll(write(bytes));
  EXPECT_EQ(report.end, PcapEnd::corrupt);
  EXPECT_THAT(report.message, HasSubstr("1000000 ticks"));
}

TEST_F(PcapFile, TellsBrokenGzipDataFromAnEnd)
{
  Bytes bytes = fileHeader(1);
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i)
  {
    Bytes frame(200);
    std::generate(frame.begin(), frame.end(), [&] { return static_cast<uint8_t>(random()); });
    append(bytes, record(frame));
  }
  const auto path = writeGz(bytes);
  const auto size = std::filesystem::file_size(path);
  std::filesystem::resize_file(path, size / 2);
  EXPECT_EQ(readAll(path).end, PcapEnd::truncated);
  writeGz(bytes);
  std::fstream(path, std::ios::in | std::ios::out | std::ios::binary)
      .seekp(static_cast<long>(size) - 6)
      .put('!');
  const PcapReport report = readAll(path);
  EXPECT_EQ(report.end, PcapEnd::corrupt) << "the checksum at the end is wrong";
  EXPECT_THAT(report.message, HasSubstr("broken gzip data"));
}

TEST_F(PcapFile, IsRefusedWithAReason)
{
  EXPECT_THAT(refusal("/nonexistent.pcap"), HasSubstr("No such file"));
  EXPECT_THAT(refusal(std::filesystem::temp_directory_path()), HasSubstr("a folder"));
  EXPECT_THAT(refusal(write({})), HasSubstr("not a pcap file"));
  EXPECT_THAT(refusal(write(Bytes(100, 0x55))), HasSubstr("not a pcap file"));
  EXPECT_THAT(refusal(write(fileHeader(1, 0x0A0D0D0A))), HasSubstr("pcapng"));
  EXPECT_THAT(refusal(write(fileHeader(105))), HasSubstr("link type 105"));
  Bytes cut = fileHeader(1);
  cut.resize(20);
  EXPECT_THAT(refusal(write(cut)), HasSubstr("within the pcap file header"));
  EXPECT_THAT(refusal(path_), HasSubstr(path_.string()));
}

TEST_F(PcapFile, SurvivesDamageEverywhere)
{
  Bytes good = fileHeader(1);
  for (int i = 0; i < 5; ++i)
  {
    append(good, record(ethernet({0x81, 0, 0, 2, 8, 0}, udpInIp(sample_payload))));
  }
  std::mt19937 random(4);
  for (int round = 0; round < 500; ++round)
  {
    Bytes bytes = good;
    for (int flip = 0; flip < 4; ++flip)
    {
      bytes[random() % bytes.size()] ^= static_cast<uint8_t>(1U << random() % 8);
    }
    bytes.resize(bytes.size() - random() % 40);
    write(bytes);
    if (refusal(path_).empty())
    {
      const PcapReport report = readAll(path_);
      ASSERT_NE(report.end, PcapEnd::not_yet);
      ASSERT_EQ(report.message.empty(), report.end == PcapEnd::clean);
      ASSERT_EQ(report.records, report.datagrams + report.fragments + report.other);
    }
  }
}

TEST(MalformedCaptures, AreEachReadOrRefusedWithAMessage)
{
  const auto folder = sharedData("malformed/pcap");
  TRAVERSE_NEEDS(folder);
  size_t files = 0;
  size_t refused = 0;
  size_t clean = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    ++files;
    try
    {
      PcapReader reader(entry.path());
      while (reader.next())
      {
      }
      const PcapReport& report = reader.report();
      ASSERT_NE(report.end, PcapEnd::not_yet);
      clean += report.end == PcapEnd::clean ? 1 : 0;
      if (report.end != PcapEnd::clean)
      {
        ASSERT_THAT(report.message, HasSubstr(entry.path().string()));
      }
    }
    catch (const std::runtime_error& error)
    {
      ++refused;
      ASSERT_THAT(error.what(), HasSubstr(entry.path().string()));
    }
  }
  EXPECT_GT(files, 300U);
  EXPECT_GT(refused, 50U) << "link types that are not ours, pcapng";
  EXPECT_GT(clean, 100U) << "most are whole, if strange";
  EXPECT_GT(files - refused - clean, 0U);
}
}  // namespace
}  // namespace traverse::testing
