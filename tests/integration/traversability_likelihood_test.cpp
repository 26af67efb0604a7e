// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/maps/CTraversabilityGridMap.h>
#include <traverse/observations/to_scan.h>
#include <traverse/plugin/register.h>

#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <support/data.h>
#include <support/mrpt_logs.h>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using maps::CTraversabilityGridMap;
using mrpt::poses::CPose3D;

/** Poses off the true one by 0.3 and 0.5 m along and across, and by 5 degrees. */
std::vector<CPose3D> displacements()
{
  std::vector<CPose3D> all;
  for (const double off : {-0.5, -0.3, 0.3, 0.5})
  {
    all.emplace_back(off, 0, 0, 0, 0, 0);
    all.emplace_back(0, off, 0, 0, 0, 0);
  }
  all.emplace_back(0, 0, 0, mrpt::DEG2RAD(5.0), 0, 0);
  all.emplace_back(0, 0, 0, mrpt::DEG2RAD(-5.0), 0, 0);
  return all;
}

TEST(Likelihood, PrefersTheTruePoseOfA3dScan)
{
  const auto scan = firstOf(kVelodyneLog);
  const CPose3D truth(3, -2, 0.2, 0.7, 0.02, -0.01);
  CTraversabilityGridMap map;
  map.insertObservation(*scan, truth);
  const double at_truth = map.computeObservationLikelihood(*scan, truth);
  for (const CPose3D& off : displacements())
  {
    EXPECT_LT(map.computeObservationLikelihood(*scan, truth + off), at_truth - 10) << off;
  }
  EXPECT_EQ(CTraversabilityGridMap().computeObservationLikelihood(*scan, truth), 0);
}

TEST(Likelihood, PrefersTheTruePoseForPointsThatAreNotInTheMap)
{
  const auto decoded = observations::toScan(*firstOf(kVelodyneLog), {}).decoded;
  points::ScanBuffer odd;
  points::ScanBuffer even;
  for (size_t i = 0; i < decoded.scan.size(); ++i)
  {
    points::ScanBuffer& half = i % 2 == 0 ? even : odd;
    half.x.push_back(decoded.scan.x[i]);
    half.y.push_back(decoded.scan.y[i]);
    half.z.push_back(decoded.scan.z[i]);
  }
  const traversability_grid::Params params;
  const geometry::Vehicle vehicle;
  auto state = traversability_grid::makeState(params, vehicle);
  update(state, even.view(), Eigen::Isometry3d::Identity(), params, vehicle);
  const auto at = [&](double x, double y)
  {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.translation() << x, y, 0;
    return logLikelihood(state, odd.view(), T, {});
  };
  for (const double off : {-0.5, -0.3, 0.3, 0.5})
  {
    EXPECT_LT(at(off, 0), at(0, 0) - 10) << off;
    EXPECT_LT(at(0, off), at(0, 0) - 10) << off;
  }
}

TEST(Likelihood, PrefersTheTruePoseOfA2dScanOnAMapOfItsNeighbours)
{
  const std::vector<LoggedObservation> log = readStockLog(kLaserLog);
  CTraversabilityGridMap map;
  constexpr size_t kHeldOut = 4;  // mapped are the eight scans around it, not the scan itself
  for (size_t i = 0; i < 9; ++i)
  {
    if (i != kHeldOut)
    {
      map.insertObservation(*log[i].observation, log[i].pose);
    }
  }
  const LoggedObservation& held_out = log[kHeldOut];
  const double at_truth = map.computeObservationLikelihood(*held_out.observation, held_out.pose);
  for (const CPose3D& off : displacements())
  {
    EXPECT_LT(
        map.computeObservationLikelihood(*held_out.observation, held_out.pose + off), at_truth)
        << off;
  }
}
}  // namespace
