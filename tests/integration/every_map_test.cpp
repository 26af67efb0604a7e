// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What holds of every map, whatever it shows.
#include <traverse/formats/bytes.h>
#include <traverse/maps/CTraversabilityGridMap.h>
#include <traverse/maps/CWrappableMultiLidarGrid.h>

#include <mrpt/io/CMemoryStream.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt/serialization/CArchive.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <support/map_by_ini.h>
#include <support/mrpt_logs.h>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using mrpt::poses::CPose3D;
using ::testing::HasSubstr;

std::string bytesOf(const mrpt::serialization::CSerializable& object)
{
  mrpt::io::CMemoryStream stream;
  mrpt::serialization::archiveFrom(stream) << object;
  return {
      static_cast<const char*>(stream.getRawBufferData()),
      static_cast<size_t>(stream.getTotalBytesCount())};
}

template <class Map>
void readInto(Map& map, const std::string& bytes)
{
  mrpt::io::CMemoryStream stream;
  stream.Write(bytes.data(), bytes.size());
  stream.Seek(0);
  auto archive = mrpt::serialization::archiveFrom(stream);
  archive >> map;
}

template <class Map>
class EveryMap : public ::testing::Test
{
 protected:
  static Map full()
  {
    Map map;
    map.insertObservation(*firstOf(kVelodyneLog), CPose3D(1, 2, 0, 0.3, 0, 0));
    return map;
  }
};

using Maps = ::testing::Types<maps::CTraversabilityGridMap, maps::CWrappableMultiLidarGrid>;
TYPED_TEST_SUITE(EveryMap, Maps);

TYPED_TEST(EveryMap, IsEmptyUntilItTakesAScan)
{
  TypeParam map;
  EXPECT_TRUE(map.isEmpty());
  EXPECT_FALSE(map.insertObservation(mrpt::obs::CObservationComment()));
  EXPECT_TRUE(map.isEmpty());
  EXPECT_TRUE(map.layerSet().extent.empty());
  EXPECT_TRUE(map.insertObservation(*firstOf(kVelodyneLog)));
  EXPECT_FALSE(map.isEmpty());
  EXPECT_FALSE(map.layerSet().extent.empty());
}

TYPED_TEST(EveryMap, ComesBackFromMrptsArchives)
{
  TypeParam map = this->full();
  map.likelihoodOptions.worst = 7;
  map.renderOptions.show_axes = false;
  map.genericMapParams.enableObservationLikelihood = false;
  TypeParam read;
  readInto(read, bytesOf(map));
  EXPECT_EQ(read.archive(), map.archive());
  EXPECT_EQ(bytesOf(read), bytesOf(map));
  EXPECT_EQ(read.likelihoodOptions.worst, 7);
  EXPECT_FALSE(read.renderOptions.show_axes);
  EXPECT_FALSE(read.genericMapParams.enableObservationLikelihood);
}

TYPED_TEST(EveryMap, ATruncatedStreamIsRefused)
{
  const std::string bytes = bytesOf(this->full());
  for (const size_t length : {size_t{60}, size_t{200}, bytes.size() / 2, bytes.size() - 1})
  {
    TypeParam read;
    EXPECT_ANY_THROW(readInto(read, bytes.substr(0, length))) << length;
  }
}

TYPED_TEST(EveryMap, ACloneSharesNothing)
{
  TypeParam map = this->full();
  const std::string before = map.archive();
  const mrpt::rtti::CObject::Ptr clone = map.duplicateGetSmartPtr();
  map.clear();
  EXPECT_EQ(std::dynamic_pointer_cast<TypeParam>(clone)->archive(), before);
}

TYPED_TEST(EveryMap, ClearedAndFilledAgainIsTheSame)
{
  TypeParam map = this->full();
  const std::string before = map.archive();
  map.clear();
  EXPECT_TRUE(map.isEmpty());
  EXPECT_EQ(map.archive(), TypeParam().archive());
  map.insertObservation(*firstOf(kVelodyneLog), CPose3D(1, 2, 0, 0.3, 0, 0));
  EXPECT_EQ(map.archive(), before);
}

TYPED_TEST(EveryMap, TakesEverySensorOfTheStockLogs)
{
  for (const std::string& log : {kVelodyneLog, kLaserLog, mrptData("tests_rgbd.rawlog")})
  {
    TypeParam map;
    map.sensors.depth_image_step = 4;
    EXPECT_TRUE(map.insertObservation(*firstOf(log), CPose3D(1, 2, 0, 0.3, 0, 0))) << log;
  }
}

TYPED_TEST(EveryMap, RefusesArchivesOfOthersAndStaysAsItWas)
{
  TypeParam map = this->full();
  const std::string before = map.archive();
  for (const std::string& bytes : {std::string("nonsense"), std::string(), before.substr(1)})
  {
    EXPECT_THROW(map.setFromArchive(bytes), formats::FormatError);
  }
  EXPECT_EQ(map.archive(), before);
}

TYPED_TEST(EveryMap, MatchingDoesNotThrow)
{
  const TypeParam map = this->full();
  const mrpt::maps::CSimplePointsMap points;
  EXPECT_EQ(map.compute3DMatchingRatio(&points, CPose3D(), {}), 0);
}

TYPED_TEST(EveryMap, DrawsItselfUnlessTold)
{
  TypeParam map = this->full();
  mrpt::opengl::CSetOfObjects scene;
  map.getVisualizationInto(scene);
  EXPECT_FALSE(scene.empty());
  map.genericMapParams.enableSaveAs3DObject = false;
  mrpt::opengl::CSetOfObjects none;
  map.getVisualizationInto(none);
  EXPECT_TRUE(none.empty());
}

TYPED_TEST(EveryMap, HasAClassLayerWhoseEveryCodeIsInItsLegend)
{
  const layers::LayerSet set = this->full().layerSet();
  ASSERT_NE(set.find(set.class_layer), nullptr);
  uint64_t named = 0;
  for (const auto& [name, count] : layers::cellsByClass(set))
  {
    named += count;
  }
  EXPECT_EQ(named, set.size());
}
}  // namespace
