// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The truth of cells against rays from above, a centimetre apart, and against itself turned.
#include <traverse/poses/pose_track.h>
#include <traverse/simulation/random.h>
#include <traverse/simulation/ray_caster.h>
#include <traverse/simulation/truth.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <support/truth_scenes.h>

namespace
{
using namespace traverse;
using namespace traverse::simulation;
using namespace traverse::testing;

constexpr int kCells = 40;    // along an edge of the 8 x 8 m scene
constexpr int kPerCell = 20;  // rays

/** Tilted boxes and balls on level ground. */
Scene cluttered(uint64_t seed)
{
  Random random(seed);
  Scene scene = levelScene();
  for (int i = 0; i < 14; ++i)
  {
    Object object = boxObject({{-0.5F, -0.3F, -0.2F}, {0.5F, 0.3F, 0.6F}});
    TimedPose pose;
    pose.T_map_body.linear() =
        poses::rotationBy(random.uniform(0, 6), Eigen::Vector3d::UnitZ()) *
        poses::rotationBy(random.uniform(-0.5, 0.5), Eigen::Vector3d::UnitX());
    pose.T_map_body.translation() =
        Eigen::Vector3d(random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(0, 0.3));
    object.motion = Motion({pose});
    if (i % 4 == 0)
    {
      object.parts.clear();
      object.balls.push_back({{0, 0, 0}, 0.4F, Material::snow});
    }
    scene.objects.push_back(std::move(object));
  }
  return scene;
}

/** Height over the ground that a ray from above meets. */
std::vector<float> seenFromAbove(const Scene& scene)
{
  constexpr double kAbove_m = 10;
  constexpr int kRays = kCells * kPerCell;
  const RayCaster caster(scene);
  std::vector<float> heights;
  heights.reserve(size_t{kRays} * kRays);
  for (int y = 0; y < kRays; ++y)
  {
    for (int x = 0; x < kRays; ++x)
    {
      const Eigen::Vector3d from(-4 + (x + 0.5) * 0.01, -4 + (y + 0.5) * 0.01, kAbove_m);
      const Hit hit = caster.cast({from, -Eigen::Vector3d::UnitZ(), 0}, 2 * kAbove_m);
      heights.push_back(static_cast<float>(kAbove_m - hit.range_m));
    }
  }
  return heights;
}

/** Highest of the rays of a cell and of those up to `margin` rays beside it. */
float highest(const std::vector<float>& heights, int cell_x, int cell_y, int margin)
{
  constexpr int kRays = kCells * kPerCell;
  float height = -1;
  for (int y = cell_y * kPerCell - margin; y < (cell_y + 1) * kPerCell + margin; ++y)
  {
    for (int x = cell_x * kPerCell - margin; x < (cell_x + 1) * kPerCell + margin; ++x)
    {
      if (x >= 0 && y >= 0 && x < kRays && y < kRays)
      {
        height = std::max(height, heights[static_cast<size_t>(y) * kRays + static_cast<size_t>(x)]);
      }
    }
  }
  return height;
}

TEST(CellTruthOracle, TopsAreThoseThatRaysMeet)
{
  const Scene scene = cluttered(5);
  const layers::LayerSet truth = cellTruth(scene, {}, {}, 0, {-3.9, -3.9});
  const auto& steps = std::get<std::vector<float>>(truth.find("truth_step")->data);
  const std::vector<float> heights = seenFromAbove(scene);
  int raised = 0;
  for (int y = 0; y < kCells; ++y)
  {
    for (int x = 0; x < kCells; ++x)
    {
      const float step = steps[static_cast<size_t>(y * kCells + x)];
      // rays miss what reaches less than a centimetre into a cell, and meet tilted sides up to a
      // centimetre lower: by 1 cm / tan(0.5 rad)
      EXPECT_GE(step, highest(heights, x, y, 0) - 0.002F) << x << " " << y;
      EXPECT_LE(step, highest(heights, x, y, 2) + 0.02F) << x << " " << y;
      raised += step > 0.1F ? 1 : 0;
    }
  }
  EXPECT_GT(raised, 100);
}

/** The scene mirrored at the line x = y. */
Scene mirrored(Scene scene)
{
  for (Object& object : scene.objects)
  {
    const Eigen::Isometry3d T = object.motion.at(0);
    for (Part& part : object.parts)
    {
      for (Eigen::Vector3f& v : part.vertices)
      {
        const Eigen::Vector3d p = T * v.cast<double>();
        v = Eigen::Vector3d(p.y(), p.x(), p.z()).cast<float>();
      }
    }
    for (Ball& ball : object.balls)
    {
      const Eigen::Vector3d p = T * ball.centre.cast<double>();
      ball.centre = Eigen::Vector3d(p.y(), p.x(), p.z()).cast<float>();
    }
    object.motion = Motion();
  }
  return scene;
}

TEST(CellTruthOracle, MirroredWorldHasMirroredTruth)
{
  for (uint64_t seed = 1; seed <= 5; ++seed)
  {
    const Scene scene = cluttered(seed);
    const layers::LayerSet truth = cellTruth(scene, {}, {}, 0, {-3.9, -3.9});
    const layers::LayerSet turned = cellTruth(mirrored(scene), {}, {}, 0, {-3.9, -3.9});
    const auto& a = std::get<std::vector<float>>(truth.find("truth_roughness")->data);
    const auto& b = std::get<std::vector<float>>(turned.find("truth_roughness")->data);
    int different = 0;
    for (size_t i = 0; i < a.size(); ++i)
    {
      different += std::abs(a[i] - b[i % kCells * kCells + i / kCells]) > 1e-4F ? 1 : 0;
    }
    // vertices are rounded to floats in another frame: what ends near an edge may cross it
    EXPECT_LE(different, 1) << seed;
  }
}
}  // namespace
