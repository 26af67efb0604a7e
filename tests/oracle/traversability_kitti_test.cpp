// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The map against a slow and obvious one: a std::map from cell to its points, features in two
// passes of doubles as the paper writes them, on real clouds along a real drive.
#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <support/data.h>
#include <support/grid_scenes.h>
#include <zlib.h>

namespace
{
using namespace traverse;
using namespace traverse::traversability_grid;
using namespace traverse::testing;

const geometry::Vehicle kCar;

using CellKey = std::pair<int64_t, int64_t>;
using PointMm = std::array<int64_t, 3>;
using NaiveMap = std::map<CellKey, std::vector<PointMm>>;

points::ScanBuffer kittiCloud(const std::filesystem::path& file)
{
  points::ScanBuffer scan;
  gzFile in = gzopen(file.c_str(), "rb");
  std::array<float, 4> p{};
  while (in != nullptr && gzread(in, p.data(), sizeof p) == static_cast<int>(sizeof p))
  {
    addPoint(scan, p[0], p[1], p[2]);
  }
  gzclose(in);
  return scan;
}

std::vector<Eigen::Isometry3d> kittiPoses(const std::filesystem::path& file)
{
  std::ifstream in(file);
  std::vector<Eigen::Isometry3d> poses;
  int frame = 0;
  while (in >> frame)
  {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    for (int i = 0; i < 12; ++i)
    {
      in >> T.matrix()(i / 4, i % 4);
    }
    poses.push_back(T);
  }
  return poses;
}

int64_t floorOf(int64_t a, int64_t b)
{
  return static_cast<int64_t>(std::floor(static_cast<double>(a) / static_cast<double>(b)));
}

void addNaively(NaiveMap& map, const points::ScanBuffer& scan, const Eigen::Isometry3d& T)
{
  const int64_t rx = floorOf(std::llround(T.translation().x() * 1000), 200);
  const int64_t ry = floorOf(std::llround(T.translation().y() * 1000), 200);
  for (size_t i = 0; i < scan.size(); ++i)
  {
    const Eigen::Vector3d p = T * Eigen::Vector3d(scan.x[i], scan.y[i], scan.z[i]);
    const PointMm mm = {
        std::llround(p.x() * 1000), std::llround(p.y() * 1000), std::llround(p.z() * 1000)};
    const CellKey cell{floorOf(mm[0], 200), floorOf(mm[1], 200)};
    const bool is_near = cell.first >= rx - 375 && cell.first < rx + 375 &&
                         cell.second >= ry - 375 && cell.second < ry + 375;
    if (is_near && std::abs(p.z() - T.translation().z()) <= 30)
    {
      map[cell].push_back({mm[0] - cell.first * 200, mm[1] - cell.second * 200, mm[2]});
    }
  }
}

/** The cell's points from the lowest up to the first gap of the vehicle's height. */
std::vector<PointMm> underTheGap(std::vector<PointMm> points)
{
  std::sort(
      points.begin(), points.end(), [](const PointMm& a, const PointMm& b) { return a[2] < b[2]; });
  for (size_t i = 1; i < points.size(); ++i)
  {
    if (points[i][2] - points[i - 1][2] >= 2000)
    {
      points.resize(i);
    }
  }
  return points;
}

struct NaiveFeatures
{
  double mean = 0, deviation = 0, variance = 0, slope_deg = 0;
  bool has_plane = false;
};

Eigen::Vector3d metres(const PointMm& p)
{
  return Eigen::Vector3d(
             static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])) /
         1000;
}

NaiveFeatures naiveFeatures(const std::vector<PointMm>& points)
{
  NaiveFeatures f;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const PointMm& p : points)
  {
    centre += metres(p) / static_cast<double>(points.size());
  }
  Eigen::Matrix2d M = Eigen::Matrix2d::Zero();
  Eigen::Vector2d v = Eigen::Vector2d::Zero();
  for (const PointMm& p : points)
  {
    const Eigen::Vector3d d = metres(p) - centre;
    f.deviation = std::max(f.deviation, std::abs(d.z()));
    f.variance += d.z() * d.z() / static_cast<double>(points.size());
    M += d.head<2>() * d.head<2>().transpose();
    v += d.head<2>() * d.z();
  }
  f.mean = centre.z();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> spread(M);
  f.has_plane = spread.eigenvalues()(0) > 1e-9 * spread.eigenvalues()(1);
  const Eigen::Vector2d plane = M.fullPivLu().solve(v);
  f.slope_deg = std::acos(1 / std::sqrt(plane.squaredNorm() + 1)) * 180 / std::numbers::pi;
  return f;
}

int naiveClass(const std::vector<PointMm>& points, const NaiveFeatures& f, const Params& p)
{
  if (points.size() < 3)
  {
    return 0;
  }
  const auto worst = [](double value, double a, double b, double c)
  {
    // A deviation of exactly 30 mm, a slope of exactly 45 degrees: this arithmetic rounds to either
    // side of the limit; what is on it is within.
    const double eps = 1e-9 * a;
    return value <= a + eps ? 1 : value <= b + eps ? 2 : value <= c + eps ? 3 : 4;
  };
  const int others = std::max(
      worst(
          f.deviation, p.flat.deviation_m, p.small_roughness.deviation_m,
          p.large_roughness.deviation_m),
      worst(
          f.variance, p.flat.variance_m2, p.small_roughness.variance_m2,
          p.large_roughness.variance_m2));
  if (!f.has_plane)
  {
    return others == 4 ? 4 : 0;
  }
  return std::max(
      others,
      worst(
          f.slope_deg, p.flat.slope_deg, p.small_roughness.slope_deg, p.large_roughness.slope_deg));
}

void compare(const NaiveMap& naive, const layers::LayerSet& set, const Params& params)
{
  const auto& codes = std::get<std::vector<uint8_t>>(set.find("traversability_class")->data);
  const auto& counts = std::get<std::vector<uint32_t>>(set.find("point_count")->data);
  const auto& means = std::get<std::vector<float>>(set.find("height_mean")->data);
  size_t mismatches = 0;
  for (const auto& [cell, all] : naive)
  {
    const std::vector<PointMm> points = underTheGap(all);
    const NaiveFeatures f = naiveFeatures(points);
    const auto i = static_cast<size_t>(
        (cell.second - set.extent.min.y) * set.extent.width() + cell.first - set.extent.min.x);
    const int expected = naiveClass(points, f, params);
    mismatches += codes[i] == expected ? 0 : 1;
    EXPECT_EQ(codes[i], expected) << "n " << points.size() << ", deviation " << f.deviation
                                  << ", variance " << f.variance << ", slope " << f.slope_deg
                                  << (f.has_plane ? "" : ", no plane");
    ASSERT_EQ(counts[i], points.size());
    ASSERT_NEAR(means[i], f.mean, 1e-5) << "a float's resolution at 100 m";
  }
  EXPECT_EQ(mismatches, 0U) << "of " << naive.size() << " cells";
  size_t occupied = 0;
  for (const uint32_t n : counts)
  {
    occupied += n > 0 ? 1 : 0;
  }
  EXPECT_EQ(occupied, naive.size());
}

TEST(Oracle, SingleCloudsHaveTheNaiveClasses)
{
  const auto folder = sharedData("kitti-odo00-labelled/full_resolution");
  TRAVERSE_NEEDS(folder);
  Params params;
  params.classifier = ClassifierKind::paper;
  params.mode = Mode::single_cloud;
  State state = makeState(params, kCar);
  for (const char* name : {"000000.bin.gz"})
  {
    const points::ScanBuffer scan = kittiCloud(folder / name);
    ASSERT_GT(scan.size(), 100'000U);
    update(state, scan.view(), atPlace(0, 0), params, kCar);
    NaiveMap naive;
    addNaively(naive, scan, atPlace(0, 0));
    ASSERT_GT(naive.size(), 15'000U);
    compare(naive, layerSet(state, params, kCar), params);
  }
}

TEST(Oracle, AnAccumulatedDriveHasTheNaiveClasses)
{
  const auto folder = sharedData("kitti-odo00-labelled");
  TRAVERSE_NEEDS(folder);
  Params params;
  params.classifier = ClassifierKind::paper;
  params.extent = Extent::growing;
  State state = makeState(params, kCar);
  NaiveMap naive;
  const std::vector<Eigen::Isometry3d> poses = kittiPoses(folder / "poses_velodyne_world.txt");
  ASSERT_GE(poses.size(), 12U);
  for (int i = 0; i < 12; i += 6)
  {
    const std::string number = std::to_string(1'000'000 + i).substr(1);
    const points::ScanBuffer scan = kittiCloud(folder / "velodyne" / (number + ".bin.gz"));
    const layers::UpdateStats stats =
        update(state, scan.view(), poses[static_cast<size_t>(i)], params, kCar);
    EXPECT_GT(stats.points, 40'000U);
    addNaively(naive, scan, poses[static_cast<size_t>(i)]);
  }
  compare(naive, layerSet(state, params, kCar), params);
}
}  // namespace
