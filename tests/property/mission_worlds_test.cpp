// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/simulating/scene_file.h>
#include <traverse/simulation/build.h>
#include <traverse/simulation/ray_caster.h>
#include <traverse/simulation/surroundings.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

// What holds for every world that is made for navigators: ini/scenes/*.ini of these names.
namespace
{
using namespace traverse;
using namespace traverse::simulation;

constexpr uint64_t kSeeds = 10;
constexpr uint64_t kFewSeeds = 3;

SceneParams asked(const std::string& name)
{
  SceneParams scene = simulating::readScene(config::IniDocument::fromFile(
      std::filesystem::path(TRAVERSE_SOURCE_DIR) / "ini/scenes" / (name + ".ini")));
  scene.folder.clear();  // it is none of a scene's text
  return scene;
}

SceneParams world(const std::string& name, uint64_t seed)
{
  return generate(asked(name), seed);
}

/** A disc 0.8 m across. */
geometry::Vehicle disc()
{
  constexpr int kCorners = 24;
  geometry::Vehicle vehicle;
  vehicle.footprint_xs_m.clear();
  vehicle.footprint_ys_m.clear();
  for (int i = 0; i < kCorners; ++i)
  {
    vehicle.footprint_xs_m.push_back(0.4 * std::cos(2 * M_PI * i / kCorners));
    vehicle.footprint_ys_m.push_back(0.4 * std::sin(2 * M_PI * i / kCorners));
  }
  vehicle.height_m = 1.2;
  return vehicle;
}

constexpr double kSpare_m = 0.3;
constexpr double kRounding_m = 0.06;  // a ditch is known to 5 cm; outlines are polygons

Scene withoutMovers(Scene scene)
{
  std::erase_if(scene.objects, [](const Object& o) { return o.motion.moves(); });
  return scene;
}

/** Cells of 0.2 m that a disc can reach from the start, with 0.3 m to spare. */
class Reach
{
 public:
  Reach(const Scene& scene, const geometry::Pose2& start) :
      area_(scene.area), around_(withoutMovers(scene), disc())
  {
    spread({columnOf(start.x_m), rowOf(start.y_m)});
  }

  bool has(const geometry::Pose2& place) const
  {
    return seen_.count({columnOf(place.x_m), rowOf(place.y_m)}) > 0;
  }

 private:
  using Cell = std::pair<int, int>;
  static constexpr double kCell_m = 0.2;

  int columnOf(double x) const { return static_cast<int>((x - area_.min_x_m) / kCell_m); }

  int rowOf(double y) const { return static_cast<int>((y - area_.min_y_m) / kCell_m); }

  bool isFree(const Cell& cell) const
  {
    const double x = area_.min_x_m + (cell.first + 0.5) * kCell_m;
    const double y = area_.min_y_m + (cell.second + 0.5) * kCell_m;
    const bool inside =
        x > area_.min_x_m && x < area_.max_x_m && y > area_.min_y_m && y < area_.max_y_m;
    return inside && around_.clearance_m({x, y, 0}, 0, 1) >= kSpare_m;
  }

  void spread(const Cell& start)
  {
    std::vector<Cell> open = {start};
    seen_.insert(start);
    while (!open.empty())
    {
      const auto [i, j] = open.back();
      open.pop_back();
      for (const Cell& next : {Cell{i + 1, j}, Cell{i - 1, j}, Cell{i, j + 1}, Cell{i, j - 1}})
      {
        if (seen_.count(next) == 0 && isFree(next))
        {
          seen_.insert(next);
          open.push_back(next);
        }
      }
    }
  }

  Area area_;
  Surroundings around_;
  std::set<Cell> seen_;
};

class MissionWorld : public ::testing::TestWithParam<const char*>
{
};

TEST_P(MissionWorld, IsTheSameForASeedAndReadsBackFromItsText)
{
  for (uint64_t seed = 1; seed <= kSeeds; ++seed)
  {
    const SceneParams scene = world(GetParam(), seed);
    EXPECT_EQ(scene, world(GetParam(), seed));
    const std::string text = simulating::sceneText(scene);
    EXPECT_EQ(scene, simulating::readScene(config::IniDocument::fromText(text, "text.ini")));
    EXPECT_EQ(generate(scene, seed + 1), scene);  // explicit now
  }
  EXPECT_NE(world(GetParam(), 1), world(GetParam(), 2));
}

TEST_P(MissionWorld, KeepsTheProposedWayFree)
{
  for (uint64_t seed = 1; seed <= kSeeds; ++seed)
  {
    const SceneParams words = world(GetParam(), seed);
    const Surroundings around(withoutMovers(buildScene(words)), disc());
    for (size_t i = 0; i < words.drive_xs_m.size(); ++i)
    {
      const geometry::Pose2 place{words.drive_xs_m[i], words.drive_ys_m[i], 0};
      EXPECT_GT(around.clearance_m(place, 0, 1), kSpare_m - kRounding_m) << seed << " " << i;
    }
    const geometry::Pose2 start = startOf(words.mission);
    EXPECT_EQ(start.x_m, words.drive_xs_m.front());
    EXPECT_EQ(start.y_m, words.drive_ys_m.front());
    EXPECT_EQ(goalsOf(words.mission).back().x_m, words.drive_xs_m.back());
  }
}

TEST_P(MissionWorld, HasAWayFromGoalToGoal)
{
  for (uint64_t seed = 1; seed <= kFewSeeds; ++seed)
  {
    const SceneParams words = world(GetParam(), seed);
    const Reach reach(buildScene(words), startOf(words.mission));
    for (const geometry::Pose2& goal : goalsOf(words.mission))
    {
      EXPECT_TRUE(reach.has(goal)) << seed;
    }
    // and not out of it
    EXPECT_FALSE(reach.has({words.extent.min_x_m + 0.1, words.extent.min_y_m + 0.1, 0})) << seed;
  }
}

TEST_P(MissionWorld, IsOfABoundedSize)
{
  for (uint64_t seed = 1; seed <= kFewSeeds; ++seed)
  {
    const Scene scene = buildScene(world(GetParam(), seed));
    EXPECT_LT(groundVertices(scene), 1000000U) << seed;
    EXPECT_LT(scene.objects.size(), 150U) << seed;
  }
}

TEST_P(MissionWorld, RefusesAnAreaThatIsTooSmall)
{
  SceneParams small = asked(GetParam());
  small.extent.min_x_m = small.extent.min_y_m = -5;
  small.extent.max_x_m = small.extent.max_y_m = 5;
  EXPECT_THROW(generate(small, 1), std::runtime_error);
}

INSTANTIATE_TEST_SUITE_P(
    All,
    MissionWorld,
    ::testing::Values("clutter", "park", "tunnel", "warehouse", "icy_lot"),
    [](const auto& info) { return std::string(info.param); });

TEST(Tunnel, IsTheOnlyWayAndAsNarrowAsItSays)
{
  for (uint64_t seed = 1; seed <= kFewSeeds; ++seed)
  {
    SceneParams words = world("tunnel", seed);
    const geometry::Pose2 goal = goalsOf(words.mission).back();
    // the drive's place that is nearest to the middle of the world is within the tunnel
    geometry::Pose2 middle{1e9, 0, 0};
    for (size_t i = 0; i < words.drive_xs_m.size(); ++i)
    {
      if (std::abs(words.drive_xs_m[i]) < std::abs(middle.x_m))
      {
        middle = {words.drive_xs_m[i], words.drive_ys_m[i], 0};
      }
    }
    const double narrow = Surroundings(buildScene(words), disc()).clearance_m(middle, 0, 5);
    EXPECT_LT(narrow, 2.8 / 2 - 0.4) << seed;
    EXPECT_GT(narrow, kSpare_m - kRounding_m) << seed;
    ObjectParams plug;
    plug.kind = ObjectKind::cylinder;
    plug.x_m = middle.x_m;
    plug.y_m = middle.y_m;
    plug.radius_m = 1.2;
    words.objects.push_back(plug);
    EXPECT_FALSE(Reach(buildScene(words), startOf(words.mission)).has(goal)) << seed;
  }
}

TEST(Warehouse, PeopleLeaveRoomBesideThem)
{
  for (uint64_t seed = 1; seed <= kFewSeeds; ++seed)
  {
    const Scene scene = buildScene(world("warehouse", seed));
    const Surroundings around(scene, disc());
    int people = 0;
    for (const Object& person : scene.objects)
    {
      for (double t_s = 0; person.motion.moves() && t_s < 120; t_s += 1.7)
      {
        const Eigen::Vector3d at = person.motion.at(t_s).translation();
        const double left = around.clearance_m({at.x(), at.y() + 1.6, 0}, t_s, 1);
        const double right = around.clearance_m({at.x(), at.y() - 1.6, 0}, t_s, 1);
        EXPECT_GT(std::max(left, right), kSpare_m) << seed << " " << person.name << " " << t_s;
      }
      people += person.motion.moves() ? 1 : 0;
    }
    EXPECT_GE(people, 2);
  }
}

TEST(Park, IsAsSteepAsItSays)
{
  for (uint64_t seed = 1; seed <= kFewSeeds; ++seed)
  {
    const SceneParams words = world("park", seed);
    const auto terrain = buildTerrain(words);
    double steepest = 0;
    for (int i = 0; i < 58 * 58; ++i)
    {
      const double x = -29 + i % 58;
      const double y = -29 + i / 58;
      const double here = terrain->at(x, y).base_m;
      const double east = terrain->at(x + 0.4, y).base_m - here;
      const double north = terrain->at(x, y + 0.4).base_m - here;
      steepest = std::max(steepest, std::hypot(east, north) / 0.4);
    }
    const double steepest_deg = std::atan(steepest) * 180 / M_PI;
    EXPECT_LT(steepest_deg, 12.5) << seed;  // fine unevenness is none of base_m
    EXPECT_GT(steepest_deg, 6) << seed;
  }
}

TEST(IcyLot, HasIceOnItsWay)
{
  size_t icy = 0;
  for (uint64_t seed = 1; seed <= kSeeds; ++seed)
  {
    const SceneParams words = world("icy_lot", seed);
    const auto terrain = buildTerrain(words);
    for (size_t i = 0; i < words.drive_xs_m.size(); ++i)
    {
      const GroundAt ground = terrain->at(words.drive_xs_m[i], words.drive_ys_m[i]);
      icy += ground.material == Material::ice ? 1 : 0;
      EXPECT_LT(std::abs(ground.height_m), 0.01);
    }
  }
  EXPECT_GT(icy, 10 * kSeeds / 5);
}
}  // namespace
