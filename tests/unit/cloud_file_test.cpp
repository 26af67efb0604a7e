// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/bytes.h>
#include <traverse/formats/cloud_file.h>
#include <traverse/formats/gzip.h>
#include <traverse/formats/safe_file.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <support/data.h>
#include <support/scratch_folder.h>

namespace
{
using namespace traverse::formats;
using namespace traverse::testing;

const std::string kAsciiPcd =
    "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z intensity ring timestamp rgb\n"
    "SIZE 8 8 8 4 2 8 4\nTYPE F F F F U F U\nCOUNT 1 1 1 1 1 1 1\nWIDTH 2\nHEIGHT 1\n"
    "VIEWPOINT 1 2 3 1 0 0 0\nPOINTS 2\nDATA ascii\n"
    "512345.25 5400000.5 200 0.5 3 1600000000.25 16711680\n"
    "nan nan nan 0 4 0 255\n";

TEST(CloudFiles, AsciiPcdHasAllChannels)
{
  const CloudFile cloud = readPcd(kAsciiPcd);
  ASSERT_EQ(cloud.size(), 2U);
  EXPECT_EQ(cloud.x[0], 512345.25) << "doubles stay doubles";
  EXPECT_EQ(cloud.y[0], 5400000.5);
  EXPECT_TRUE(std::isnan(cloud.x[1]));
  EXPECT_EQ(cloud.intensity[0], 0.5F);
  EXPECT_EQ(cloud.ring, (std::vector<uint16_t>{3, 4}));
  EXPECT_EQ(cloud.rgb, (std::vector<uint32_t>{0xFF0000, 0xFF}));
  EXPECT_EQ(cloud.stamp_ns, 1'600'000'000'250'000'000) << "not that of a beam without echo";
  EXPECT_EQ(cloud.viewpoint.translation(), Eigen::Vector3d(1, 2, 3));
}

/** A PCD of x y z (float32) and t (uint32, ns). */
std::string binaryPcd(const std::string& data, const std::string& kind)
{
  return "FIELDS x y z t\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\nWIDTH 2\nHEIGHT 1\nPOINTS "
         "2\nDATA " +
         kind + "\n" + data;
}

TEST(CloudFiles, BinaryAndCompressedPcdAgree)
{
  ByteWriter rows;
  ByteWriter columns;
  for (const uint32_t t : {0U, 50'000'000U})
  {
    rows.f32(1);
    rows.f32(2);
    rows.f32(3);
    rows.u32(t);
  }
  for (const float v : {1.0F, 2.0F, 3.0F})
  {
    columns.f32(v);
    columns.f32(v);
  }
  columns.u32(0);
  columns.u32(50'000'000);
  // One run of 32 literal bytes is a valid LZF stream.
  ByteWriter packed;
  packed.u32(33);
  packed.u32(32);
  packed.u8(31);
  packed.raw(columns.bytes());
  for (const std::string& bytes :
       {binaryPcd(rows.bytes(), "binary"), binaryPcd(packed.bytes(), "binary_compressed")})
  {
    const CloudFile cloud = readPcd(bytes);
    ASSERT_EQ(cloud.size(), 2U);
    EXPECT_EQ(cloud.z[1], 3.0);
    EXPECT_EQ(cloud.time_s, (std::vector<float>{0.0F, 0.05F})) << "integers are nanoseconds";
    EXPECT_FALSE(cloud.stamp_ns);
  }
}

const std::string kPlyHead =
    "element camera 2\nproperty list uchar short knots\nelement vertex 1\nproperty float x\n"
    "property float y\nproperty double z\nproperty uchar red\nproperty uchar green\n"
    "property uchar blue\nend_header\n";

TEST(CloudFiles, PlySkipsOtherElementsInEveryFormat)
{
  const auto expect_point = [](const CloudFile& cloud)
  {
    ASSERT_EQ(cloud.size(), 1U);
    EXPECT_EQ(cloud.x[0], 1.5);
    EXPECT_EQ(cloud.z[0], -2.25);
    EXPECT_EQ(cloud.rgb[0], 0x010203U);
  };
  expect_point(readPly("ply\nformat ascii 1.0\n" + kPlyHead + "2 7 8\n0\n1.5 0 -2.25 1 2 3\n"));
  ByteWriter little;
  little.u8(2);
  little.u32(0);
  little.u8(0);
  little.f32(1.5);
  little.f32(0);
  little.f64(-2.25);
  little.raw("\x01\x02\x03");
  std::string big = little.bytes();
  std::reverse(big.begin() + 6, big.begin() + 10);
  std::reverse(big.begin() + 14, big.begin() + 22);
  expect_point(readPly("ply\nformat binary_little_endian 1.0\n" + kPlyHead + little.bytes()));
  expect_point(readPly("ply\nformat binary_big_endian 1.0\n" + kPlyHead + big));
}

TEST(CloudFiles, CsvKeepsNanosecondsExactly)
{
  const CloudFile cloud = readCloudCsv(
      "x,y,z,laser_number,timestamp_ns\r\n1,2,3,31,1600000000000000001\r\n"
      "1,2,3,30,1600000000000000301\r\n");
  ASSERT_EQ(cloud.size(), 2U);
  EXPECT_EQ(cloud.stamp_ns, 1'600'000'000'000'000'001);
  EXPECT_EQ(cloud.ring[1], 30);
  EXPECT_FLOAT_EQ(cloud.time_s[1], 3e-7F);
  EXPECT_THROW(readCloudCsv("x,y,z\n1,2\n"), FormatError);
}

TEST(CloudFiles, WhatIsNoTimeIsToldAndLeftOut)
{
  const CloudFile cloud = readCloudCsv("x,y,z,time\n1,2,3,0.5\n1,2,3,1e7\n");
  EXPECT_TRUE(cloud.time_s.empty());
  EXPECT_NE(cloud.note.find("'time'"), std::string::npos);
}

TEST(CloudFiles, CountsThatTheBytesCannotHoldAreRefused)
{
  const std::string head = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 268435456\nHEIGHT 1\nDATA ";
  EXPECT_THROW(readPcd(head + "ascii\n1 2 3\n"), FormatError);
  EXPECT_THROW(readPcd(head + "binary\n123456789012"), FormatError);
  EXPECT_THROW(readPcd(head + "binary_compressed\n\1\0\0\0"), FormatError);
  EXPECT_THROW(
      readPly("ply\nformat ascii 1.0\nelement vertex 99999999999\nproperty float x\nproperty "
              "float y\nproperty float z\nend_header\n1 2 3\n"),
      FormatError);
  EXPECT_THROW(readCloudBin("12345678901234567"), FormatError);
  EXPECT_THROW(readPcd("FIELDS x y\nSIZE 4 4\nTYPE F F\nWIDTH 0\nDATA ascii\n"), FormatError);
}

TEST(CloudFiles, RealOnesAreWhatTheirSourcesSay)
{
  const auto top = sharedData("multilidar-top-left-right/top.pcd");
  TRAVERSE_NEEDS(top);
  const CloudFile cloud = readCloud(top);
  EXPECT_EQ(cloud.size(), 92677U);
  EXPECT_EQ(*std::max_element(cloud.ring.begin(), cloud.ring.end()), 63);
  EXPECT_TRUE(cloud.stamp_ns);
  EXPECT_LT(*std::max_element(cloud.time_s.begin(), cloud.time_s.end()), 0.12F) << "one turn";

  const CloudFile vls = readCloud(sharedData("vls128-organised/000000.pcd"));
  EXPECT_EQ(vls.width * vls.height, 240000U);
  EXPECT_EQ(vls.height, 128U);
  EXPECT_NEAR(*std::max_element(vls.time_s.begin(), vls.time_s.end()), 0.0998, 2e-4);

  EXPECT_EQ(readCloud(sharedData("terrain-isprs/samp11-utm-ground.pcd")).size(), 21786U);
  EXPECT_EQ(readCloud(sharedData("malformed/ply/cube_binary.ply")).size(), 8U);
  EXPECT_EQ(
      readCloud(sharedData("velodyne-pcap/nebula_vlp32c_1713492677464078412.pcd.gz")).size(),
      26216U);
  const CloudFile sweep =
      readCloud(sharedData("argoverse2-2xVLP32C/315966265259836000_full.csv.gz"));
  EXPECT_EQ(sweep.size(), 99229U);
  EXPECT_EQ(*std::max_element(sweep.ring.begin(), sweep.ring.end()), 63);
  EXPECT_GT(*std::max_element(sweep.time_s.begin(), sweep.time_s.end()), 0.09F);
}

/** Every reader on bytes near a good file: it answers or throws FormatError. */
void readMutations(const std::string& good, CloudFile (*read)(std::string_view), unsigned seed)
{
  std::mt19937 random(seed);
  const auto below = [&](size_t n) { return static_cast<size_t>(random() % n); };
  for (int i = 0; i < 400; ++i)
  {
    std::string bytes = good;
    const size_t changes = 1 + below(4);
    for (size_t c = 0; c < changes; ++c)
    {
      // Mostly in the header, where lengths are.
      const size_t at = below(below(4) > 0 ? std::min<size_t>(bytes.size(), 400) : bytes.size());
      bytes[at] = below(2) == 0 ? static_cast<char>(random()) : "0123456789 \n-eF"[below(15)];
    }
    bytes.resize(below(3) == 0 ? below(bytes.size() + 1) : bytes.size());
    try
    {
      const CloudFile cloud = read(bytes);
      ASSERT_EQ(cloud.y.size(), cloud.size());
      ASSERT_TRUE(cloud.time_s.empty() || cloud.time_s.size() == cloud.size());
      ASSERT_TRUE(cloud.ring.empty() || cloud.ring.size() == cloud.size());
    }
    catch (const FormatError&)
    {
    }
  }
}

TEST(CloudFiles, NoBytesDoHarm)
{
  readMutations(kAsciiPcd, readPcd, 1);
  readMutations("ply\nformat ascii 1.0\n" + kPlyHead + "2 7 8\n0\n1.5 0 -2.25 1 2 3\n", readPly, 2);
  readMutations("x,y,z,i,time\n1,2,3,4,0.5\n5,6,7,8,0.6\n", readCloudCsv, 3);
  readMutations(std::string(64, '\7'), readCloudBin, 4);
  const auto left = sharedData("multilidar-top-left-right/left.pcd");
  TRAVERSE_NEEDS(left);
  readMutations(readFile(left, 1U << 30U), readPcd, 5);
  readMutations(readFile(sharedData("malformed/ply/cube_binary.ply"), 1U << 20U), readPly, 6);
}

TEST(CloudFiles, DamagedGzipIsTold)
{
  const ScratchFolder scratch;
  const std::string packed = gzip(std::string(1600, 'a'));
  writeText(scratch / "a.bin.gz", packed);
  EXPECT_EQ(readCloud(scratch / "a.bin.gz").size(), 100U);
  writeText(scratch / "a.bin.gz", packed.substr(0, packed.size() - 5));
  EXPECT_THROW(readCloud(scratch / "a.bin.gz"), FormatError);
  EXPECT_THROW(gunzip(packed, 1599), FormatError);
  EXPECT_EQ(gunzip(packed + packed, 4000).size(), 3200U);
}
}  // namespace
