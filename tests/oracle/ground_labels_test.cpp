// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The default classifier's ground against people's labels of real clouds, each by itself: above the
// best figure that a peer reached on the same clouds (doc/benchmarks.md has them all).
#include <gtest/gtest.h>

#include <support/data.h>
#include <support/ground_score.h>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using traversability_grid::ClassifierKind;
using traversability_grid::PointLabel;

constexpr double kPatchworkPlusPlusOnKitti = 0.9589;
constexpr double kGroundGridOnNuscenes = 0.979;

/** Every cloud after `change`, with a mount height that is off by mount_error_m. */
template <class F>
GroundScore scoreOf(Layout layout, const std::string& folder, F&& change, double mount_error_m = 0)
{
  GroundScore score;
  for (const auto& [points, labels] : labelledFiles(layout, sharedData(folder)))
  {
    LabelledCloud cloud = readLabelled(layout, points, labels);
    change(cloud);
    const double mount_m = mountHeight_m(layout) + mount_error_m;
    score.add(cloud, layout, labelsOf(cloud, ClassifierKind::standard, mount_m));
  }
  return score;
}

void asItIs(LabelledCloud& /*cloud*/) {}

TEST(GroundLabels, BeatThePeersOnKitti)
{
  TRAVERSE_NEEDS(sharedData("kitti-odo00-labelled"));
  EXPECT_GT(scoreOf(Layout::kitti, "kitti-odo00-labelled", asItIs).f1(), kPatchworkPlusPlusOnKitti);
}

TEST(GroundLabels, BeatThePeersOnNuscenes)
{
  TRAVERSE_NEEDS(sharedData("nuscenes-hdl32-labelled"));
  EXPECT_GT(
      scoreOf(Layout::nuscenes, "nuscenes-hdl32-labelled", asItIs).f1(), kGroundGridOnNuscenes);
}

TEST(GroundLabels, HoldForAMountHeightThatIsWrongByTwentyCentimetres)
{
  TRAVERSE_NEEDS(sharedData("kitti-odo00-labelled"));
  for (const double error_m : {-0.2, 0.2})
  {
    const GroundScore score = scoreOf(Layout::kitti, "kitti-odo00-labelled", asItIs, error_m);
    EXPECT_GT(score.f1(), kPatchworkPlusPlusOnKitti) << error_m;
  }
}

TEST(GroundLabels, HoldOnASlopeThatBeginsAheadOfTheVehicle)
{
  TRAVERSE_NEEDS(sharedData("kitti-odo00-labelled"));
  for (const float slope : {-0.1F, 0.1F})
  {
    const auto bend = [slope](LabelledCloud& cloud)
    {
      for (size_t i = 0; i < cloud.scan.size(); ++i)
      {
        cloud.scan.z[i] += slope * std::max(0.0F, cloud.scan.x[i] - 8);
      }
    };
    // A slope makes low vegetation harder to tell: some of the margin goes.
    EXPECT_GT(scoreOf(Layout::kitti, "kitti-odo00-labelled", bend).f1(), 0.95) << slope;
  }
}

TEST(GroundLabels, OfTheSameCloudInAnotherOrderAreTheSame)
{
  TRAVERSE_NEEDS(sharedData("nuscenes-hdl32-labelled"));
  const auto files = labelledFiles(Layout::nuscenes, sharedData("nuscenes-hdl32-labelled"));
  LabelledCloud cloud = readLabelled(Layout::nuscenes, files[0].first, files[0].second);
  const auto labels = labelsOf(cloud, ClassifierKind::standard, 1.84);
  for (auto* channel : {&cloud.scan.x, &cloud.scan.y, &cloud.scan.z})
  {
    std::reverse(channel->begin(), channel->end());
  }
  auto reversed = labelsOf(cloud, ClassifierKind::standard, 1.84);
  std::reverse(reversed.begin(), reversed.end());
  EXPECT_EQ(reversed, labels);
}
}  // namespace
