// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// Real recordings through traverse-import, read back by our reader and by stock rawlog-edit.
#include <traverse/logs/log_poses.h>
#include <traverse/poses/pose_track.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <support/log_reading.h>
#include <support/traverse_import.h>
#include <support/traverse_map.h>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

std::vector<poses::StampedPose> posesOf(const fs::path& log)
{
  return logs::readLogPoses(log, poses::PoseSource::robot_pose, {}, {}).poses;
}

class TraverseImport : public ::testing::Test
{
 protected:
  /** Imports and reads back; the program must be content. */
  LogReading import(const fs::path& input, const std::vector<std::string>& options = {}) const
  {
    const Finished ran = traverseImport(input, log_, options);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr(log_.string()));
    LogReading reading = readLog(log_);
    EXPECT_TRUE(reading.report.complete()) << reading.report.damage;
    EXPECT_EQ(reading.report.channels_damage, "");
    EXPECT_EQ(reading.report.backward_stamps, 0U) << "in the order of time";
    return reading;
  }

  ScratchFolder scratch_;
  fs::path log_ = scratch_ / "made.rawlog";
};

TEST_F(TraverseImport, KittiOdometryHasCloudsAndVehiclePoses)
{
  const fs::path input = sharedData("kitti-odo00-labelled");
  TRAVERSE_NEEDS(input);
  const LogReading reading = import(input);
  ASSERT_EQ(reading.scans.size(), 12U);
  EXPECT_GT(reading.scans[0].scan.size(), 45000U);
  EXPECT_EQ(reading.scans[0].scan.T_base_sensor.translation().z(), 1.73);
  const auto poses = posesOf(log_);
  ASSERT_EQ(poses.size(), 12U);
  EXPECT_NEAR(poses[1].T_map_base.translation().x(), 0.8588, 0.01) << "one step of the car";
  EXPECT_EQ(poses[3].time, reading.scans[3].scan.stamp);
  const std::string info = stockInfo(log_);
  EXPECT_THAT(info, HasSubstr("VELODYNE /     12 /10.000"));
  EXPECT_THAT(info, HasSubstr("POSE /     12"));
}

TEST_F(TraverseImport, PartOfARecordingBegins)
{
  const fs::path input = sharedData("kitti-odo00-labelled");
  TRAVERSE_NEEDS(input);
  const LogReading reading = import(
      input, {"--from", "0.25", "--to", "0.5", "--sensor-label", "TOP", "--sensor-pose",
              "0.5,0,1.6,90,0,0", "--start-time", "1317000000"});
  ASSERT_EQ(reading.scans.size(), 2U);
  EXPECT_EQ(reading.scans[0].scan.sensor_label, "TOP");
  EXPECT_EQ(reading.scans[0].scan.stamp, 1'317'000'000'300'000'000);
  const auto& T = reading.scans[0].scan.T_base_sensor;
  EXPECT_NEAR(T.translation().x(), 0.5, 1e-9);
  EXPECT_NEAR(T.linear()(1, 0), 1, 1e-9) << "yaw of a quarter turn";
}

TEST_F(TraverseImport, KittiRawHasPicturesWithTheirCameras)
{
  const fs::path input = sharedData("kitti-raw-consecutive");
  TRAVERSE_NEEDS(input);
  const LogReading reading = import(input);
  EXPECT_EQ(reading.scans.size(), 3U);
  EXPECT_GT(reading.scans[0].scan.size(), 110000U);
  EXPECT_THAT(stockInfo(log_), HasSubstr("CAMERA_2 /      3"));
}

TEST_F(TraverseImport, KittiRawDrivesHaveClockGpsAndImu)
{
  const fs::path drive = scratch_ / "day" / "drive";
  for (const char* sensor : {"velodyne_points", "oxts"})
  {
    fs::create_directories(drive / sensor / "data");
    writeText(
        drive / sensor / "timestamps.txt",
        "2011-09-26 13:02:25.500000000\n\n2011-09-26 13:02:25.700000000\n");
  }
  for (const char* frame : {"0", "1", "2"})
  {
    writeText(
        drive / "velodyne_points" / "data" / (std::string(frame) + ".bin"), std::string(32, '\1'));
    std::string oxts = "49.015 8.43 116.4 0.01 0.02 1.5";
    for (int i = 6; i < 30; ++i)
    {
      oxts += " " + std::to_string(i);
    }
    writeText(drive / "oxts" / "data" / (std::string(frame) + ".txt"), oxts);
  }
  writeText(scratch_ / "day" / "calib_imu_to_velo.txt", "R: 1 0 0 0 1 0 0 0 1\nT: -0.8 0.3 -0.8\n");
  const Finished ran = traverseImport(drive, log_);
  EXPECT_EQ(ran.exit_code, 5) << "frame 1 has no time: " << ran.err;
  const LogReading reading = readLog(log_);
  ASSERT_EQ(reading.scans.size(), 2U);
  EXPECT_EQ(reading.scans[1].scan.stamp, 1'317'042'145'700'000'000);
  const std::string info = stockInfo(log_);
  EXPECT_THAT(info, HasSubstr("GPS /      2"));
  EXPECT_THAT(info, HasSubstr("IMU /      2"));
}

TEST_F(TraverseImport, Argoverse2HasRingsAndPosesNearZero)
{
  const fs::path input = sharedData("argoverse2-2xVLP32C");
  TRAVERSE_NEEDS(input);
  const LogReading reading = import(input);
  ASSERT_EQ(reading.scans.size(), 4U);
  EXPECT_EQ(reading.report.channels.at("attached"), 4U);
  size_t points = 0;
  for (const points::Decoded& decoded : reading.scans)
  {
    const auto& ring = decoded.scan.ring;
    EXPECT_EQ(*std::max_element(ring.begin(), ring.end()), 31);
    EXPECT_TRUE(decoded.scan.time_s.empty()) << "its points are moved to one time already";
    points += decoded.scan.size();
  }
  EXPECT_EQ(points, 99229U + 99466U);
  const auto poses = posesOf(log_);
  ASSERT_EQ(poses.size(), 2706U);
  EXPECT_LT(poses.front().T_map_base.translation().norm(), 100);
  // Of two lasers the lower ring looks lower, whatever the order in which they fire.
  const points::ScanBuffer& scan = reading.scans[0].scan;
  const Eigen::Isometry3d T_sensor_base = scan.T_base_sensor.inverse();
  for (size_t i = 0; i < scan.size(); i += 100)
  {
    const Eigen::Vector3d p = T_sensor_base * Eigen::Vector3d(scan.x[i], scan.y[i], scan.z[i]);
    // -25 to 15 deg; coordinates were rounded to 16 bits: up to 0.2 m near 50 m.
    const double tangent = p.z() / p.head<2>().norm();
    if (scan.ring[i] == 0)
    {
      EXPECT_LT(tangent, -0.35);
    }
    if (scan.ring[i] == 31)
    {
      EXPECT_GT(tangent, 0.2);
    }
  }
}

TEST_F(TraverseImport, CloudsKeepTheirTimesAndOrder)
{
  const fs::path input = sharedData("multilidar-top-left-right");
  TRAVERSE_NEEDS(input);
  const LogReading reading = import(input);
  ASSERT_EQ(reading.scans.size(), 3U);
  EXPECT_EQ(reading.report.channels.at("attached"), 3U);
  EXPECT_EQ(reading.scans[0].scan.time_s.size(), reading.scans[0].scan.size());
  EXPECT_THAT(stockInfo(log_), HasSubstr("LIDAR /      3"));
}

TEST_F(TraverseImport, SurveyorsCoordinatesAreShiftedAndSaid)
{
  const fs::path input = sharedData("terrain-isprs/samp11-utm-ground.pcd");
  TRAVERSE_NEEDS(input);
  const Finished ran = traverseImport(input, log_);
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("5404000"));
  const LogReading reading = readLog(log_);
  ASSERT_EQ(reading.scans.size(), 1U);
  EXPECT_LT(std::abs(reading.scans[0].scan.y[0]), 1000.0F);
}

TEST_F(TraverseImport, CapturesBecomeTurnsOfEachModel)
{
  TRAVERSE_NEEDS(sharedData("velodyne-pcap"));
  const LogReading vlp16 = import(sharedData("velodyne-pcap/sample_velodyne_vlp16_gps.pcap"));
  // 293 packets are 3.9 turns that begin and end within one; all returns of all of them.
  ASSERT_EQ(vlp16.scans.size(), 5U);
  size_t points = 0;
  for (const points::Decoded& decoded : vlp16.scans)
  {
    points += decoded.scan.size();
    EXPECT_EQ(decoded.scan.time_s.size(), decoded.scan.size());
  }
  EXPECT_EQ(points, 73486U);
  // Periods of 200 packets and of 10 Hz.
  for (const auto& [file, period_s] :
       {std::pair("sample_velodyne_hdl32.pcap", 0.1106),
        std::pair("nebula_vlp32c_front.pcap.gz", 0.1)})
  {
    const LogReading other = import(sharedData(std::string("velodyne-pcap/") + file), {"--force"});
    ASSERT_GE(other.scans.size(), 4U) << file;
    EXPECT_GT(other.scans[2].scan.size(), 20000U) << file;
    EXPECT_NEAR(
        poses::secondsBetween(other.scans[1].scan.stamp, other.scans[2].scan.stamp), period_s,
        0.002);
  }
}

TEST_F(TraverseImport, MapsAreDeskewedByTheTimesBesideTheLog)
{
  const fs::path input = sharedData("multilidar-top-left-right/left.pcd");
  TRAVERSE_NEEDS(input);
  const LogReading reading = import(input);
  const double stamp_s = static_cast<double>(reading.scans.at(0).scan.stamp) * 1e-9;
  std::string track;
  for (const int step : {-1, 0, 1})
  {
    track += std::to_string(stamp_s + step) + " " + std::to_string(10 * step) + " 0 0 0 0 0 1\n";
  }
  writeText(scratch_ / "drive.tum", track);
  writeText(
      scratch_ / "car.ini", "[Maps]\nCTraversabilityGridMap_count = 1\n[Poses]\nsource = file\n");
  const auto map = [&](const std::string& folder)
  {
    return traverseMap(
        {scratch_ / "car.ini", "--rawlog", log_, "--output", scratch_ / folder, "--set",
         "Poses.file=" + (scratch_ / "drive.tum").string(), "--set",
         "traverse-map.pictures=false"});
  };
  const Finished with = map("with");
  ASSERT_EQ(with.exit_code, 0) << with.err;
  EXPECT_EQ(metricsOf(scratch_ / "with")["deskew"]["corrected"], 1);
  const std::string side = readText(log_.string() + ".channels");
  writeText(log_.string() + ".channels", side.substr(0, side.size() / 2));
  const Finished damaged = map("damaged");
  EXPECT_EQ(damaged.exit_code, 5) << "mapped, but without what was lost";
  EXPECT_THAT(damaged.err, HasSubstr("made.rawlog.channels is damaged"));
  EXPECT_EQ(metricsOf(scratch_ / "damaged")["deskew"].count("corrected"), 0U);
}

TEST_F(TraverseImport, SevenScenesSeesTheFloorWhereItIs)
{
  const fs::path input = sharedData("rgbd-redkitchen");
  TRAVERSE_NEEDS(input);
  const LogReading reading = import(input, {"--to", "0.3"});
  const auto poses = posesOf(log_);
  ASSERT_EQ(reading.scans.size(), 5U) << "every second frame of 30 per second";
  ASSERT_EQ(poses.size(), 5U);
  // The plane in the recording's world, from its notes: the floor is 19 to 27 % of the pixels.
  const Eigen::Vector3d normal(0.01059, -0.89397, -0.44799);
  for (size_t i = 0; i < poses.size(); ++i)
  {
    const points::ScanBuffer& scan = reading.scans[i].scan;
    size_t on_floor = 0;
    for (size_t k = 0; k < scan.size(); ++k)
    {
      const Eigen::Vector3d p =
          poses[i].T_map_base * Eigen::Vector3d(scan.x[k], scan.y[k], scan.z[k]);
      on_floor += std::abs(normal.dot(p) + 1.51601) < 0.04 ? 1 : 0;
    }
    EXPECT_GT(on_floor * 100, scan.size() * 15) << "frame " << i;
  }
}

TEST_F(TraverseImport, TumFoldersAssociateByTime)
{
  const fs::path data = sharedData("rgbd-open3d-5frames");
  TRAVERSE_NEEDS(data);
  const fs::path folder = scratch_ / "tum";
  fs::create_directory(folder);
  std::string depth = "# depth maps\n";
  std::string colour;
  for (const char digit : {'0', '1', '2'})
  {
    const std::string name = std::string("0000") + digit;
    fs::copy(data / (name + ".png"), folder / (name + ".png"));
    fs::copy(data / (name + ".jpg"), folder / (name + ".jpg"));
    depth += std::string("1305031102.1") + digit + "0000 " + name + ".png\n";
    colour += std::string("1305031102.1") + digit + "5000 " + name + ".jpg\n";
  }
  writeText(folder / "depth.txt", depth + "1305031103.0 ../../secret.png\n");
  writeText(folder / "rgb.txt", colour);
  writeText(folder / "groundtruth.txt", "1305031102.10 1 2 3 0 0 0 1\n");
  const LogReading reading = import(folder);
  ASSERT_EQ(reading.scans.size(), 3U) << "and none from outside the folder";
  EXPECT_EQ(reading.scans[1].scan.stamp, 1'305'031'102'110'000'000);
  EXPECT_GT(reading.scans[0].scan.size(), 100000U);
  EXPECT_EQ(reading.scans[0].scan.rgb.size(), reading.scans[0].scan.size());
  const auto poses = posesOf(log_);
  ASSERT_EQ(poses.size(), 1U);
  // The camera looks along the world's z: so does the vehicle's x.
  EXPECT_TRUE(poses[0].T_map_base.linear().col(0).isApprox(Eigen::Vector3d::UnitZ(), 1e-9));
  EXPECT_THAT(stockInfo(log_), HasSubstr("RGBD /      3"));
}
}  // namespace
