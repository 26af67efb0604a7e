// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// Our VLP-32C decoding against the reference cloud of nebula (TIER IV), made from the same capture.
// Its elevations, azimuth offsets and distances are compared point by point. Its azimuth at the
// time of firing is not the manual's, so it is undone first: it gives each of the 32 lasers a slot
// of 2.304 us of its own (73.7 us, where a sequence takes 55.3; the manual fires them in pairs),
// rounds to 0.01 degrees, and leaves the last block of a packet where it stands.
#include "support/data.h"
#include "support/velodyne_capture.h"

#include <traverse/points/velodyne_scan.h>
#include <traverse/sensors/velodyne_packet.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <numbers>
#include <string_view>

namespace traverse::testing
{
namespace
{

using Point = std::array<float, 3>;

std::vector<Point> referenceCloud(const std::filesystem::path& file)
{
  constexpr std::string_view kBeforeData = "DATA binary\n";
  const std::vector<uint8_t> bytes = bytesOf(file);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const size_t header = text.find(kBeforeData);
  if (header == std::string_view::npos)
  {
    return {};
  }
  const std::string_view data = text.substr(header + kBeforeData.size());
  std::vector<Point> cloud(data.size() / sizeof(Point));
  std::memcpy(cloud.data(), data.data(), cloud.size() * sizeof(Point));
  return cloud;
}

/** Where in the capture each of our points comes from. */
struct Origin
{
  int block = 0;
  int laser = 0;
  double step_hundredths = 0;
};

void appendOrigins(const sensors::VelodyneData& data, std::vector<Origin>& origins)
{
  for (int block = 0; block < sensors::kVelodyneBlocks; ++block)
  {
    for (int laser = 0; laser < sensors::kVelodyneRecords; ++laser)
    {
      if (data.record(block, laser).distance != 0)
      {
        origins.push_back({block, laser, static_cast<double>(data.azimuthStep(block))});
      }
    }
  }
}

std::vector<Origin> originsOf(const Capture& capture)
{
  std::vector<Origin> origins;
  for (const auto& packet : capture.packets)
  {
    if (const auto data = sensors::VelodyneData::check(packet))
    {
      appendOrigins(*data, origins);
    }
  }
  return origins;
}

/** From nebula's azimuth of a firing to the manual's, rad, clockwise. */
double correction(const Origin& at)
{
  const bool is_last = at.block == sensors::kVelodyneBlocks - 1;
  const double theirs = is_last ? 0 : std::round(at.step_hundredths * at.laser / 24.0);
  const int pair = at.laser / 2;
  const double manual = at.step_hundredths * pair / 24.0;  // 2.304 us of 55.296 a pair
  return (manual - theirs) * 0.01 * std::numbers::pi / 180;
}

double rangeOf(const Point& p)
{
  return std::hypot(p[0], p[1], p[2]);
}

TEST(NebulasVlp32c, IsDecodedAlike)
{
  const auto folder = sharedData("velodyne-pcap");
  TRAVERSE_NEEDS(folder / "nebula_vlp32c_front.pcap.gz");
  const auto capture = captureInPcap(folder / "nebula_vlp32c_front.pcap.gz");
  const auto reference = referenceCloud(folder / "nebula_vlp32c_1713492677464078412.pcd.gz");
  ASSERT_EQ(reference.size(), 26216U);
  const auto views = capture.views();
  points::VelodyneInput input;
  input.packets = views;
  const points::ScanBuffer ours = points::decodeVelodyne(input).scan;
  const std::vector<Origin> origin = originsOf(capture);
  ASSERT_EQ(origin.size(), ours.size());

  size_t i = 0;
  size_t skipped = 0;
  size_t elsewhere = 0;
  for (const Point& theirs : reference)
  {
    // The reference is one turn of the capture's five and leaves out a few blocks at its cut.
    while (i < ours.size() &&
           std::abs(rangeOf({ours.x[i], ours.y[i], ours.z[i]}) - rangeOf(theirs)) > 1e-3)
    {
      ++i;
      ++skipped;
    }
    ASSERT_LT(i, ours.size());
    const double turn = correction(origin[i]);
    const double x = theirs[0] * std::cos(turn) + theirs[1] * std::sin(turn);
    const double y = theirs[1] * std::cos(turn) - theirs[0] * std::sin(turn);
    // Half of 0.01 degrees by their rounding, twice (step and azimuth), and their float sines.
    const double tolerance_m = 2e-4 * rangeOf(theirs) + 1e-4;
    EXPECT_NEAR(ours.z[i], theirs[2], 1e-4);
    elsewhere += std::hypot(ours.x[i] - x, ours.y[i] - y) < tolerance_m ? 0 : 1;
    ++i;
  }
  EXPECT_LE(skipped, 120U);
  // At the edge of the 180 degrees that the sensor was told to look at, the azimuth jumps; nebula
  // takes the jump for rotation.
  EXPECT_LE(elsewhere, 2U);
}
}  // namespace
}  // namespace traverse::testing
