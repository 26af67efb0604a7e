// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// A surveyed street, scanned by the simulated VLP-32C from where a real one was: as many ground
// points in each range band as the real sweep has, in the directions where nothing stood in its way
// (the survey knows no cars and houses).
#include "support/data.h"
#include "support/simulated_turns.h"
#include "support/velodyne_capture.h"

#include <traverse/config/ini_document.h>
#include <traverse/simulating/scene_file.h>
#include <traverse/simulation/build.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

namespace traverse::testing
{
namespace
{
constexpr const char* kSweep = "315966265259836000";
constexpr size_t kBands = 10;
constexpr double kBand_m = 5;
constexpr size_t kSectors = 120;

const Eigen::Vector3d kSensor(1.35018, 0, 1.64042);  // of egovehicle_SE3_sensor.csv, yaw -0.583 deg

std::filesystem::path dataFile(const std::string& name)
{
  return sharedData("argoverse2-2xVLP32C/" + name);
}

/** The rows of a gzipped table, without its header. */
std::vector<std::vector<std::string>> rowsOf(const std::string& name)
{
  const std::vector<uint8_t> bytes = bytesOf(dataFile(name));
  std::istringstream lines(std::string(bytes.begin(), bytes.end()));
  std::vector<std::vector<std::string>> rows;
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line))
  {
    std::istringstream cells(line);
    std::vector<std::string> row;
    std::string cell;
    while (std::getline(cells, cell, ','))
    {
      row.push_back(cell);
    }
    rows.push_back(row);
  }
  return rows;
}

struct RealPoint
{
  Eigen::Vector3d p_base = Eigen::Vector3d::Zero();
  bool ground = false;
};

/** Of the upper lidar. */
std::vector<RealPoint> realPoints()
{
  const auto points = rowsOf(std::string(kSweep) + "_full.csv.gz");
  const auto labels = rowsOf(std::string(kSweep) + "_flow_ground_labels.csv.gz");
  std::vector<RealPoint> upper;
  for (size_t i = 0; i < points.size() && i < labels.size(); ++i)
  {
    if (std::stoi(points[i].at(4)) < 32)
    {
      const auto number = [&](size_t column) { return std::stod(points[i].at(column)); };
      upper.push_back({{number(0), number(1), number(2)}, labels[i].at(5) == "true"});
    }
  }
  return upper;
}

/** R_city_base and place, at the sweep's time. */
Eigen::Isometry3d realPose()
{
  for (const auto& row : rowsOf("city_SE3_egovehicle.csv.gz"))
  {
    if (std::stoll(row.at(0)) >= std::stoll(kSweep))
    {
      const auto number = [&](size_t column) { return std::stod(row.at(column)); };
      Eigen::Isometry3d T_city_base = Eigen::Isometry3d::Identity();
      T_city_base.linear() =
          Eigen::Quaterniond(number(1), number(2), number(3), number(4)).toRotationMatrix();
      T_city_base.translation() = Eigen::Vector3d(number(5), number(6), number(7));
      return T_city_base;
    }
  }
  throw std::runtime_error("no pose at the sweep's time");
}

double rangeOf(const Eigen::Vector3d& p_base)
{
  return std::hypot(p_base.x() - kSensor.x(), p_base.y() - kSensor.y());
}

size_t sectorOf(const Eigen::Vector3d& p_base)
{
  const double part =
      (std::atan2(p_base.y() - kSensor.y(), p_base.x() - kSensor.x()) + std::numbers::pi) /
      (2 * std::numbers::pi);
  return std::min(static_cast<size_t>(part * kSectors), kSectors - 1);
}

/** How far each direction is free of all but ground. */
std::array<double, kSectors> freeRanges(const std::vector<RealPoint>& points)
{
  std::array<double, kSectors> free_m{};
  free_m.fill(1e9);
  for (const RealPoint& point : points)
  {
    const double range_m = rangeOf(point.p_base);
    if (!point.ground && point.p_base.z() < 2 && range_m > 2.5)  // not the car itself, not crowns
    {
      double& nearest = free_m.at(sectorOf(point.p_base));
      nearest = std::min(nearest, range_m);
    }
  }
  return free_m;
}

/** Height of the vehicle frame over the ground, by the real ground points nearby. */
double baseHeight(const std::vector<RealPoint>& points)
{
  std::vector<double> heights;
  for (const RealPoint& point : points)
  {
    if (point.ground && rangeOf(point.p_base) < 8)
    {
      heights.push_back(-point.p_base.z());
    }
  }
  const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
  std::nth_element(heights.begin(), middle, heights.end());
  return *middle;
}

simulation::Scene surveyedGround(const Eigen::Vector3d& origin)
{
  std::ostringstream ini;
  ini.precision(12);
  ini << "[Scene]\nmin_x_m = -80\nmax_x_m = 80\nmin_y_m = -80\nmax_y_m = 80\n"
      << "ground_material = asphalt\n[Terrain_00]\nkind = raster\n"
      << "file = " << dataFile("ground_height_785x880_float32.raw.gz").string() << "\n"
      << "transform_file = "
      << dataFile("7fab2350-7eaf-3b7e-a39d-6937a4c1bede___img_Sim2_city.json").string() << "\n"
      << "origin_x_m = " << origin.x() << "\norigin_y_m = " << origin.y() << "\n";
  return simulation::buildScene(
      simulating::readScene(config::IniDocument::fromText(ini.str(), "survey")));
}

points::ScanBuffer simulatedScan(double base_height_m)
{
  const Eigen::Isometry3d T_city_base = realPose();
  const simulation::Scene scene = surveyedGround(T_city_base.translation());
  simulation::TimedPose pose;
  pose.T_map_body.linear() = T_city_base.linear();
  pose.T_map_body.translation().z() = scene.terrain->at(0, 0).height_m + base_height_m;
  simulation::LidarParams params;
  params.model = sensors::VelodyneModel::vlp32c;
  params.x_m = kSensor.x();
  params.z_m = kSensor.z();
  params.yaw_deg = -0.583;
  return decodeTurn(simulation::Lidar(params, 1).turn(
                        0, simulation::RayCaster(scene), simulation::Motion({pose})))
      .scan;
}

using Bands = std::array<double, kBands>;

void count(const Eigen::Vector3d& p_base, const std::array<double, kSectors>& free_m, Bands& bands)
{
  const auto band = static_cast<size_t>(rangeOf(p_base) / kBand_m);
  if (band < kBands && free_m.at(sectorOf(p_base)) > kBand_m * static_cast<double>(band + 1))
  {
    bands.at(band) += 1;
  }
}

TEST(SimulatedGround, HasTheDensityOfARealScan)
{
  TRAVERSE_NEEDS(dataFile("city_SE3_egovehicle.csv.gz"));
  const std::vector<RealPoint> points = realPoints();
  const auto free_m = freeRanges(points);
  Bands real{};
  for (const RealPoint& point : points)
  {
    if (point.ground)
    {
      count(point.p_base, free_m, real);
    }
  }
  const points::ScanBuffer scan = simulatedScan(baseHeight(points));
  Bands simulated{};
  for (size_t i = 0; i < scan.size(); ++i)
  {
    const Eigen::Vector3d p(
        static_cast<double>(scan.x[i]), static_cast<double>(scan.y[i]),
        static_cast<double>(scan.z[i]));
    count(p, free_m, simulated);
  }
  double all_real = 0;
  double all_simulated = 0;
  for (size_t band = 0; band < kBands; ++band)
  {
    ::testing::Test::RecordProperty(
        "band_" + std::to_string(band),
        std::to_string(real[band]) + " " + std::to_string(simulated[band]));
    all_real += real[band];
    all_simulated += simulated[band];
    // A ring that is a little nearer or farther changes bands with all its points: far bands have
    // a few rings only, in a few directions.
    if (real[band] >= 300)
    {
      EXPECT_NEAR(simulated[band] / real[band], 1, 0.3) << "band " << band;
    }
  }
  EXPECT_GT(all_real, 5000);
  EXPECT_NEAR(all_simulated / all_real, 1, 0.1);
}
}  // namespace
}  // namespace traverse::testing
