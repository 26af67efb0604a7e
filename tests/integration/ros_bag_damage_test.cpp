// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <support/ros_bag_damage.h>

namespace
{
using namespace traverse::testing;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;
using traverse::importing::ImportError;

std::string refusalOf(const std::string& bytes)
{
  const ScratchFolder dir;
  writeText(dir / "damaged.bag", bytes);
  try
  {
    readBag(dir / "damaged.bag");
  }
  catch (const ImportError& e)
  {
    return e.what();
  }
  return "";
}

TEST(RosBagDamage, ABagThatWasCutOffSaysWhatToDo)
{
  const std::string good = bagBytes(rosbag::compression::Uncompressed);
  // Not closed: the header points to no index yet.
  std::string open = good;
  const size_t at = open.find("index_pos=");
  ASSERT_NE(at, std::string::npos);
  std::fill_n(open.begin() + static_cast<std::ptrdiff_t>(at) + 10, 8, '\0');
  EXPECT_THAT(refusalOf(open), HasSubstr("rosbag reindex"));
  EXPECT_THAT(refusalOf(good.substr(0, good.size() / 2)), HasSubstr("damaged.bag: "));
  EXPECT_THAT(refusalOf(good.substr(0, 20)), HasSubstr("damaged.bag: "));
  EXPECT_THAT(refusalOf(""), HasSubstr("is empty"));
}

TEST(RosBagDamage, WithinAChunkLosesThatChunkOnly)
{
  std::string bytes = bagBytes(rosbag::compression::BZ2);
  // The third chunk's data.
  size_t at = 0;
  for (int i = 0; i < 3; ++i)
  {
    at = bytes.find("BZh", at + 1);
  }
  ASSERT_NE(at, std::string::npos);
  std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at) + 40, 60, '\x55');
  const ScratchFolder dir;
  writeText(dir / "damaged.bag", bytes);
  const BagReading r = readBag(dir / "damaged.bag");
  EXPECT_THAT(r.report.damage, Not(IsEmpty()));
  EXPECT_GT(r.entries.size(), 45U);
  EXPECT_LT(r.entries.size(), 60U);
}

TEST(RosBagDamage, OfTransformsIsToldToo)
{
  BagFile bag(rosbag::compression::BZ2, 1);
  bag.writeTf(rosTransform(0, "base_link", "laser", 2, 0));
  bag.write("/scan", 1, rosLaser(1, 5));
  std::string bytes = bag.bytes();
  const size_t at = bytes.find("BZh");
  ASSERT_NE(at, std::string::npos);
  std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at) + 20, 40, '\x55');
  const ScratchFolder dir;
  writeText(dir / "damaged.bag", bytes);
  const BagReading r = readBag(dir / "damaged.bag");
  EXPECT_THAT(r.entries, SizeIs(1));
  EXPECT_THAT(r.report.damage, Contains(HasSubstr("/tf_static: a message of the bag")));
}

TEST(RosBagDamage, OfAnyKindNeitherCrashesNorSwellsThisProcess)
{
  DamagedBags plain = readMutations(rosbag::compression::Uncompressed, 1, 30);
  DamagedBags packed = readMutations(rosbag::compression::BZ2, 2, 20);
  EXPECT_GT(plain.refused + packed.refused, 5);
  EXPECT_GT(plain.complete + plain.partial, 5);
#ifndef TRAVERSE_SANITIZED
  EXPECT_LT(peakResident(), 400);
#endif
}

/** A message whose definition is not the one that we know. */
struct Changed
{
};
}  // namespace

namespace ros
{
namespace message_traits
{
template <>
struct MD5Sum<Changed>
{
  static const char* value(const Changed& /*m*/) { return "0123456789abcdef0123456789abcdef"; }
};

template <>
struct DataType<Changed>
{
  static const char* value(const Changed& /*m*/) { return "sensor_msgs/LaserScan"; }
};

template <>
struct Definition<Changed>
{
  static const char* value(const Changed& /*m*/) { return "float32 x"; }
};
}  // namespace message_traits

namespace serialization
{
template <>
struct Serializer<Changed>
{
  template <class Stream>
  static void write(Stream& stream, const Changed& /*m*/)
  {
    stream.next(1.0F);
  }

  static uint32_t serializedLength(const Changed& /*m*/) { return 4; }
};
}  // namespace serialization
}  // namespace ros

namespace
{
TEST(RosBagDamage, AChangedDefinitionIsRefusedByName)
{
  BagFile bag;
  bag.write("/scan", 0, Changed());
  const BagReading r = readBag(bag);
  EXPECT_THAT(r.entries, SizeIs(0));
  EXPECT_THAT(
      r.report.skipped, Contains(::testing::Key(
                            HasSubstr("/scan: its sensor_msgs/LaserScan has another definition"))));
}
}  // namespace
