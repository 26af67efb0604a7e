// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/sensors/exact_angle.h>
#include <traverse/sensors/velodyne.h>
#include <traverse/sensors/velodyne_timing.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace traverse::sensors
{
namespace
{
/** Elevations of the manuals' tables, by laser number, thousandths of a degree. */
constexpr std::array<int, 32> kHdl32eElevations = {
    -30670, -9330,  -29330, -8000,  -28000, -6670,  -26670, -5330,  -25330, -4000,  -24000,
    -2670,  -22670, -1330,  -21330, 0,      -20000, 1330,   -18670, 2670,   -17330, 4000,
    -16000, 5330,   -14670, 6670,   -13330, 8000,   -12000, 9330,   -10670, 10670};

constexpr std::array<int, 16> kVlp16Elevations = {-15000, 1000,  -13000, 3000, -11000, 5000,
                                                  -9000,  7000,  -7000,  9000, -5000,  11000,
                                                  -3000,  13000, -1000,  15000};

constexpr std::array<int, 32> kVlp32cElevations = {
    -25000, -1000, -1667, -15639, -11310, 0,     -667,  -8843, -7254, 333,   -333,
    -6148,  -5333, 1333,  667,    -4000,  -4667, 1667,  1000,  -3667, -3333, 3333,
    2333,   -2667, -3000, 7000,   4667,   -2333, -2000, 15000, 10333, -1333};

/** The VLP-32C's lasers stand in four columns that look 1.4 and 4.2 degrees to either side;
 * thousandths of a degree. */
constexpr std::array<int, 32> kVlp32cAzimuths = {
    1400,  -4200, 1400,  -1400, 1400,  -1400, 4200,  -1400, 1400,  -4200, 1400,
    -1400, 4200,  -1400, 4200,  -1400, 1400,  -4200, 1400,  -4200, 4200,  -1400,
    1400,  -1400, 1400,  -1400, 1400,  -4200, 4200,  -1400, 1400,  -1400};

template <size_t N>
VelodyneCalibration withElevations(const std::array<int, N>& elevations_mdeg)
{
  VelodyneCalibration calibration;
  for (const int elevation : elevations_mdeg)
  {
    calibration.lasers.push_back({0, elevation * 1e-3 * kRadPerDegree, 0, 0, 0});
  }
  return calibration;
}

VelodyneCalibration vlp32c()
{
  VelodyneCalibration calibration = withElevations(kVlp32cElevations);
  calibration.distance_unit_m = 0.004;
  for (size_t i = 0; i < calibration.lasers.size(); ++i)
  {
    calibration.lasers[i].azimuth_offset_rad = kVlp32cAzimuths[i] * 1e-3 * kRadPerDegree;
  }
  return calibration;
}

bool within(double value, double limit)
{
  return std::isfinite(value) && std::abs(value) <= limit;
}

bool isSane(const VelodyneCalibration::Laser& laser)
{
  constexpr double kMaxOffsetMetres = 10;
  return within(laser.azimuth_offset_rad, 2 * kPi) && within(laser.elevation_rad, kPi / 2) &&
         within(laser.distance_offset_m, kMaxOffsetMetres) &&
         within(laser.vertical_offset_m, kMaxOffsetMetres) &&
         within(laser.horizontal_offset_m, kMaxOffsetMetres);
}
}  // namespace

std::string_view nameOf(VelodyneModel model)
{
  constexpr std::array<std::string_view, kVelodyneModels> kNames = {"HDL-32E", "VLP-16", "VLP-32C"};
  return kNames.at(static_cast<size_t>(model));
}

const VelodyneCalibration& factoryCalibration(VelodyneModel model)
{
  static const std::array<VelodyneCalibration, kVelodyneModels> tables = {
      withElevations(kHdl32eElevations), withElevations(kVlp16Elevations), vlp32c()};
  return tables.at(static_cast<size_t>(model));
}

bool fits(const VelodyneCalibration& calibration, VelodyneModel model)
{
  const auto needed = static_cast<size_t>(timingOf(model).lasers);
  return calibration.lasers.size() >= needed && within(calibration.distance_unit_m, 0.1) &&
         calibration.distance_unit_m > 0 &&
         std::all_of(
             calibration.lasers.begin(),
             calibration.lasers.begin() + static_cast<std::ptrdiff_t>(needed), isSane);
}

std::vector<uint16_t> ringsOf(const VelodyneCalibration& calibration, VelodyneModel model)
{
  std::vector<uint16_t> by_elevation(static_cast<size_t>(timingOf(model).lasers));
  std::iota(by_elevation.begin(), by_elevation.end(), uint16_t{0});
  std::stable_sort(
      by_elevation.begin(), by_elevation.end(),
      [&](uint16_t a, uint16_t b)
      { return calibration.lasers.at(a).elevation_rad < calibration.lasers.at(b).elevation_rad; });
  std::vector<uint16_t> ring(by_elevation.size());
  for (size_t i = 0; i < by_elevation.size(); ++i)
  {
    ring[by_elevation[i]] = static_cast<uint16_t>(i);
  }
  return ring;
}
}  // namespace traverse::sensors
