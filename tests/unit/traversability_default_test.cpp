// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What classifier = default knows beyond a cell's own features.
#include <traverse/traversability_grid/point_labels.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <support/grid_scenes.h>

namespace
{
using namespace traverse;
using namespace traverse::traversability_grid;
using namespace traverse::testing;

const geometry::Vehicle kCar;  // 2 m high, its frame on the ground

Params growing(ClassifierKind classifier = ClassifierKind::standard)
{
  Params params;
  params.extent = Extent::growing;
  params.classifier = classifier;
  return params;
}

/** Points 4 cm apart at a height over a rectangle. */
void addLevel(points::ScanBuffer& scan, double x0, double y0, double x1, double y1, double z)
{
  constexpr double kStep_m = 0.04;
  const auto columns = static_cast<int>(std::lround((x1 - x0) / kStep_m));
  const auto rows = static_cast<int>(std::lround((y1 - y0) / kStep_m));
  for (int column = 0; column < columns; ++column)
  {
    for (int row = 0; row < rows; ++row)
    {
      addPoint(scan, x0 + (column + 0.5) * kStep_m, y0 + (row + 0.5) * kStep_m, z);
    }
  }
}

/** A street with a car's roof, seen from 1.8 m. */
points::ScanBuffer street()
{
  points::ScanBuffer scan;
  scan.T_base_sensor.translation().z() = 1.8;
  addLevel(scan, -8, -8, 4, 8, 0);
  addLevel(scan, 4, -1, 6, 1, 1.5);
  addLevel(scan, 6, -8, 8, 8, 0);
  return scan;
}

Class classAt(const State& state, double x_m, double y_m)
{
  const Cell* cell = state.cells.get(
      state.lattice.cellOf(geometry::toMillimetres(x_m), geometry::toMillimetres(y_m)));
  return cell == nullptr ? Class::undefined : cell->of;
}

State mapOf(const points::ScanBuffer& scan, const Params& params)
{
  State state = makeState(params, kCar);
  update(state, scan.view(), atPlace(0, 0), params, kCar);
  return state;
}

TEST(Default, ARoofIsAnObstacleThatThePaperTakesForFlat)
{
  EXPECT_EQ(classAt(mapOf(street(), growing(ClassifierKind::paper)), 5.1, 0.1), Class::flat);
  const State state = mapOf(street(), growing());
  EXPECT_EQ(classAt(state, 5.1, 0.1), Class::obstacle);
  EXPECT_EQ(classAt(state, 2.1, 0.1), Class::flat);
  EXPECT_EQ(classAt(state, 7.1, 0.1), Class::flat) << "the ground goes on behind the car";
}

TEST(Default, WhatALevelLaserMeetsIsAnObstacleThatThePaperTakesForFlat)
{
  points::ScanBuffer scan;
  scan.T_base_sensor.translation().z() = 0.3;
  for (int i = -300; i < 300; ++i)
  {
    addPoint(scan, 3.1, 0.01 * i, 0.3);
  }
  EXPECT_EQ(classAt(mapOf(scan, growing()), 3.1, 0.1), Class::obstacle);
  Params paper = growing(ClassifierKind::paper);
  EXPECT_NE(classAt(mapOf(scan, paper), 3.1, 0.1), Class::obstacle);
}

TEST(Default, AFalseReturnFromBelowDoesNotHideWhatStands)
{
  points::ScanBuffer scan = street();
  addPoint(scan, 2.1, 0.1, -3);             // as deep as the vehicle is high, and more
  addLevel(scan, 2.2, 0.0, 2.4, 0.2, 0.8);  // a box with level ground around
  addPoint(scan, 2.3, 0.1, -3);
  const State state = mapOf(scan, growing());
  EXPECT_EQ(classAt(state, 2.1, 0.1), Class::flat);
  EXPECT_EQ(classAt(state, 2.3, 0.1), Class::obstacle);
}

TEST(Default, WhatHangsAboveTheVehicleSaysNothingOfTheGround)
{
  points::ScanBuffer scan = street();
  addLevel(scan, 9, -1, 10, 1, 2.6);
  const State state = mapOf(scan, growing());
  EXPECT_EQ(classAt(state, 9.5, 0.1), Class::undefined);
}

TEST(Default, OneFloorAboveTheOtherDoesNotTakeTheLowerOnesGround)
{
  const Params params = growing();
  State state = makeState(params, kCar);
  const points::ScanBuffer scan = street();
  update(state, scan.view(), atPlace(0, 0), params, kCar);
  update(state, scan.view(), atPlace(0, 0, 4), params, kCar);  // the floor above
  update(state, scan.view(), atPlace(0, 0), params, kCar);
  EXPECT_EQ(classAt(state, 2.1, 0.1), Class::flat);
  EXPECT_EQ(classAt(state, 5.1, 0.1), Class::obstacle);
}

TEST(Labels, CallNothingGroundThatLiesFarBelowTheKnownGround)
{
  points::ScanBuffer scan = street();
  const size_t first = scan.size();
  addLevel(scan, 12, -1, 14, 1, -3);  // a car on ground lower still, past an edge
  const Params params = growing();
  const State state = mapOf(scan, params);
  const auto labels = labelsOfLastScan(state, scan.view(), atPlace(0, 0), params);
  for (size_t i = first; i < labels.size(); ++i)
  {
    ASSERT_NE(labels[i], PointLabel::ground);
  }
}

TEST(Labels, OfARefusedScanAreUndefined)
{
  const Params params = growing();
  State state = makeState(params, kCar);
  const points::ScanBuffer scan = street();
  update(state, scan.view(), atPlace(0, 0), params, kCar);
  ASSERT_TRUE(update(state, scan.view(), atPlace(1e300, 0), params, kCar).no_pose);
  for (const PointLabel label : labelsOfLastScan(state, scan.view(), atPlace(0, 0), params))
  {
    ASSERT_EQ(label, PointLabel::undefined);
  }
}

TEST(Default, MapsWithCellsFarApartAreArchivedAndRead)
{
  const Params params = growing();
  State state = makeState(params, kCar);
  update(state, street().view(), atPlace(0, 0), params, kCar);
  update(state, street().view(), atPlace(500'000, -300'000), params, kCar);
  const Map map = fromArchive(archive(state, params, kCar));
  EXPECT_EQ(map.state.occupied, state.occupied);
  EXPECT_EQ(classAt(map.state, 5.1, 0.1), Class::obstacle);
  EXPECT_EQ(classAt(map.state, 500'005.1, -299'999.9), Class::obstacle);
}

TEST(Labels, AreGroundObstacleAndOverhangingInTheOrderOfThePoints)
{
  points::ScanBuffer scan = street();
  const size_t first = scan.size();
  addPoint(scan, 2.1, 0.1, 0.01);
  addPoint(scan, 5.1, 0.1, 1.5);
  addPoint(scan, 2.1, 0.1, 2.5);
  addPoint(scan, 500, 0, 0);  // outside the window
  const Params params = growing();
  const State state = mapOf(scan, params);
  const auto labels = labelsOfLastScan(state, scan.view(), atPlace(0, 0), params);
  ASSERT_EQ(labels.size(), scan.size());
  EXPECT_THAT(
      std::vector<PointLabel>(labels.begin() + static_cast<std::ptrdiff_t>(first), labels.end()),
      ::testing::ElementsAre(
          PointLabel::ground, PointLabel::obstacle, PointLabel::overhanging,
          PointLabel::undefined));
}

TEST(Default, FilesShowTheSameWhateverTheOrderOfTheScans)
{
  std::mt19937 random(4);
  std::vector<points::ScanBuffer> scans;
  for (int i = 0; i < 6; ++i)
  {
    scans.push_back(street());
    for (float& z : scans.back().z)
    {
      z += 0.002F * static_cast<float>(random() % 20);
    }
    scans.back().stamp += i;
  }
  const Params params = growing();
  const auto shown = [&]
  {
    State state = makeState(params, kCar);
    for (const points::ScanBuffer& scan : scans)
    {
      const double x = static_cast<double>(scan.stamp - street().stamp);
      update(state, scan.view(), atPlace(0.7 * x, 0), params, kCar);
    }
    return layerSet(state, params, kCar);
  };
  const layers::LayerSet before = shown();
  std::shuffle(scans.begin(), scans.end(), random);
  const layers::LayerSet after = shown();
  EXPECT_EQ(
      std::get<std::vector<uint8_t>>(before.find("traversability_class")->data),
      std::get<std::vector<uint8_t>>(after.find("traversability_class")->data));
}

TEST(Default, TheNoiseOfAFarSensorIsNoRoughness)
{
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 0.03);  // 0.03 degrees at 57 m
  points::ScanBuffer scan;
  scan.T_base_sensor.translation() = Eigen::Vector3d(-57, 0, 1.8);
  for (int i = 0; i < 2000; ++i)
  {
    addPoint(
        scan, 0.2 * (i % 10) + 0.02 + 0.0016 * static_cast<double>(random() % 100), 0.1,
        noise(random));
  }
  const auto share_of_flat = [&](double angle_noise_deg)
  {
    Params params = growing();
    params.angle_noise_deg = angle_noise_deg;
    const State state = mapOf(scan, params);
    int flat = 0;
    for (int i = 0; i < 10; ++i)
    {
      flat += static_cast<int>(classAt(state, 0.2 * i + 0.1, 0.1) == Class::flat);
    }
    return flat;
  };
  EXPECT_EQ(share_of_flat(0), 0) << "200 points with 3 cm of noise span more than flat allows";
  EXPECT_GE(share_of_flat(0.03), 8);
}
}  // namespace
