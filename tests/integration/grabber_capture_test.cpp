// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// Real VLP-16 packets over UDP, recorded live by stock rawlog-grabber in a network namespace of
// this test's own, mapped by traverse-map; also after kill -9 of the grabber.

#include "support/data.h"
#include "support/process.h"

#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/obs/CObservationVelodyneScan.h>
#include <mrpt/serialization/CArchive.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <arpa/inet.h>
#include <chrono>
#include <csignal>
#include <net/if.h>
#include <nlohmann/json.hpp>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

namespace
{
using namespace traverse::testing;
using namespace std::chrono_literals;
using Packet = mrpt::obs::CObservationVelodyneScan::TVelodyneRawPacket;

constexpr uint16_t kVelodynePort = 2368;
constexpr auto kPacketPeriod =
    std::chrono::microseconds(1327);  // 75 packets in 99.5 ms, as the sensor sends
constexpr int kTurns = 40;

std::vector<Packet> realPackets()
{
  mrpt::io::CFileGZInputStream file(mrptData("test_velodyne_VLP16.rawlog"));
  const auto object = mrpt::serialization::archiveFrom(file).ReadObject();
  return std::dynamic_pointer_cast<mrpt::obs::CObservationVelodyneScan>(object)->scan_packets;
}

/** Puts this process into a network of its own with nothing but a loopback. */
bool enterNetworkOfItsOwn()
{
  if (unshare(CLONE_NEWNET) != 0 && unshare(CLONE_NEWUSER | CLONE_NEWNET) != 0)
  {
    return false;
  }
  const int s = socket(AF_INET, SOCK_DGRAM, 0);
  ifreq request{};
  std::strncpy(request.ifr_name, "lo", IFNAMSIZ - 1);
  request.ifr_flags = IFF_UP | IFF_RUNNING;
  const bool up = ioctl(s, SIOCSIFFLAGS, &request) == 0;
  close(s);
  return up;
}

void sendTurns(const std::vector<Packet>& packets, int turns)
{
  const int s = socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(kVelodynePort);
  to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  auto next = std::chrono::steady_clock::now();
  for (int turn = 0; turn < turns; ++turn)
  {
    for (const Packet& packet : packets)
    {
      // A MRPT raw packet is the sensor's 1206 bytes, field by field.
      sendto(s, &packet, 1206, 0, reinterpret_cast<const sockaddr*>(&to), sizeof(to));
      next += kPacketPeriod;
      std::this_thread::sleep_until(next);
    }
  }
  close(s);
}

void writeGrabberIni(const ScratchFolder& folder)
{
  writeText(
      folder / "grab.ini",
      "[global]\nrawlog_prefix = " + (folder / "capture").string() +
          "\ntime_between_launches = 100\nuse_sensoryframes = false\nGRABBER_PERIOD_MS = 500\n"
          "[Velodyne1]\ndriver = CVelodyneScanner\nprocess_rate = 1000\nsensorLabel = "
          "Velodyne1\nmodel = VLP16\n"
          "pose_x = 0\npose_y = 0\npose_z = 0.09\npose_yaw = 0\npose_pitch = 0\npose_roll = 0\n");
}

std::filesystem::path captureIn(const ScratchFolder& folder)
{
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
  {
    if (entry.path().extension() == ".rawlog")
    {
      return entry.path();
    }
  }
  return {};
}

Finished mapCapture(const ScratchFolder& folder)
{
  const std::string bin = std::string(TRAVERSE_BINARY_DIR) + "/bin/traverse-map";
  return run(
      {bin, std::string(TRAVERSE_SOURCE_DIR) + "/ini/vlp16.ini", "--rawlog", captureIn(folder),
       "--output", folder / "out", "--quiet"});
}

nlohmann::json metricsIn(const ScratchFolder& folder)
{
  return nlohmann::json::parse(readText(folder / "out" / "metrics.json"));
}

class GrabberCapture : public ::testing::Test
{
 protected:
  void SetUp() override
  {
    TRAVERSE_NEEDS(mrptData("test_velodyne_VLP16.rawlog"));
    if (!enterNetworkOfItsOwn())
    {
      GTEST_SKIP() << "SKIPPED: no network namespace can be made here";
    }
    packets_ = realPackets();
    ASSERT_EQ(packets_.size(), 75U);
    writeGrabberIni(folder_);
  }

  ScratchFolder folder_;
  std::vector<Packet> packets_;
};

TEST_F(GrabberCapture, IsMappedFromEndToEnd)
{
  Process grabber({"rawlog-grabber", folder_ / "grab.ini"}, {}, true);
  std::this_thread::sleep_for(1500ms);
  sendTurns(packets_, kTurns);
  grabber.type("q\n");
  grabber.wait(20s);

  const Finished mapped = mapCapture(folder_);
  EXPECT_EQ(mapped.exit_code, 0) << mapped.err;
  const auto metrics = metricsIn(folder_);
  // The grabber itself loses the last observations of its queue (half of it at the end).
  EXPECT_GE(metrics["observations"]["CObservationVelodyneScan"].get<int>(), kTurns * 3 / 4);
  const double per_scan = metrics["points"].get<double>() / metrics["scans"].get<double>();
  EXPECT_NEAR(per_scan, 22591, 0.02 * 22591)
      << "every valid return, at most a packet or two lost per turn";
}

TEST_F(GrabberCapture, IsSalvagedAfterKill9)
{
  Process grabber({"rawlog-grabber", folder_ / "grab.ini"}, {}, true);
  std::this_thread::sleep_for(1500ms);
  sendTurns(packets_, kTurns);
  grabber.signal(SIGKILL);
  grabber.wait(20s);

  const Finished mapped = mapCapture(folder_);
  EXPECT_EQ(mapped.exit_code, 5) << mapped.err;
  EXPECT_THAT(mapped.err, ::testing::HasSubstr(captureIn(folder_).filename().string()));
  const auto metrics = metricsIn(folder_);
  EXPECT_FALSE(metrics["complete"].get<bool>());
  EXPECT_GE(metrics["scans"].get<int>(), kTurns / 2);
}
}  // namespace
