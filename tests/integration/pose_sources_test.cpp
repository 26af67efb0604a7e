// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/analytic_street.h"
#include "support/geodetic_path.h"
#include "support/synthetic_logs.h"
#include "support/traverse_map.h"

#include <traverse/logs/log_poses.h>

#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservationGPS.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

// icp_3d and ins from a rawlog, as traverse-map takes them.
namespace
{
using namespace traverse;
using namespace traverse::testing;
const geometry::Geodetic kHere{40.44, -79.99, 230};

Eigen::Isometry3d placeAtTime(double t_s)
{
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = poses::rotationBy(0.1 * t_s, Eigen::Vector3d::UnitZ());
  T.translation() << 6 * t_s, 0.3 * t_s * t_s, 0;
  return T;
}

/** What a lidar sees at once, as a cloud without times. */
std::string cloudAt(double t_s)
{
  SpinningLidar lidar;
  lidar.rings = 32;
  lidar.lowest_deg = -25;
  lidar.turn_s = 0;
  const points::ScanBuffer scan = lidar.scan(street(), placeAtTime, t_s, kLogStart);
  auto cloud = mrpt::maps::CSimplePointsMap::Create();
  for (size_t i = 0; i < scan.size(); ++i)
  {
    // The cloud is in its sensor's frame.
    cloud->insertPoint(scan.x[i], scan.y[i], scan.z[i] - static_cast<float>(lidar.height_m));
  }
  mrpt::obs::CObservationPointCloud observation;
  observation.sensorLabel = "LIDAR";
  observation.timestamp = observations::toTimePoint(scan.stamp);
  observation.sensorPose = mrpt::poses::CPose3D(0, 0, lidar.height_m, 0, 0, 0);
  observation.pointcloud = cloud;
  return serialised(observation);
}

std::string fixAt(double t_s, int quality)
{
  const geometry::Geodetic place = placeAt(kHere, placeAtTime(t_s) * Eigen::Vector3d(0.5, 0, 1.2));
  mrpt::obs::gnss::Message_NMEA_GGA gga;
  gga.fields.latitude_degrees = place.latitude_deg;
  gga.fields.longitude_degrees = place.longitude_deg;
  gga.fields.altitude_meters = place.height_m - 30;
  gga.fields.geoidal_distance = 30;
  gga.fields.fix_quality = static_cast<uint8_t>(quality);
  mrpt::obs::CObservationGPS gps;
  gps.setMsg(gga);
  gps.sensorLabel = "GPS";
  gps.timestamp = observations::toTimePoint(kLogStart + std::llround(t_s * 1e9));
  gps.sensorPose = mrpt::poses::CPose3D(0.5, 0, 1.2, 0, 0, 0);
  return serialised(gps);
}

/** An inertial unit that is mounted turned to the right. */
std::string imuAt(double t_s)
{
  mrpt::obs::CObservationIMU imu;
  imu.sensorLabel = "IMU";
  imu.timestamp = observations::toTimePoint(kLogStart + std::llround(t_s * 1e9));
  imu.sensorPose = mrpt::poses::CPose3D(0, 0, 0, -1.5, 0, 0);
  imu.set(mrpt::obs::IMU_YAW, 0.1 * t_s - 1.5);
  imu.set(mrpt::obs::IMU_PITCH, 0);
  imu.set(mrpt::obs::IMU_ROLL, 0);
  return serialised(imu);
}

std::string driveLog()
{
  std::string log = fixAt(-0.1, 0) + fixAt(-0.05, 6);
  for (int i = 0; i < 10; ++i)
  {
    const double t_s = 0.1 * i;
    log += fixAt(t_s, 4) + imuAt(t_s) + imuAt(t_s + 0.05) + cloudAt(t_s);
  }
  return log;
}

Finished mapWith(const ScratchFolder& scratch, const std::vector<std::string>& settings)
{
  std::vector<std::string> arguments = {
      ini("vlp16"),
      "--force",
      "--quiet",
      "--rawlog",
      scratch / "some.rawlog",
      "--output",
      scratch / "out",
      "--set",
      "traverse-map.pictures=false"};
  for (const std::string& setting : settings)
  {
    arguments.insert(arguments.end(), {"--set", setting});
  }
  return traverseMap(arguments);
}

/** The largest distance of poses to where the vehicle was, less where `first` was. */
double worst_m(const logs::PoseReading& reading, const Eigen::Isometry3d& T_map_street)
{
  double worst = 0;
  for (const poses::StampedPose& pose : reading.poses)
  {
    const double t_s = 1e-9 * static_cast<double>(pose.time - kLogStart);
    const Eigen::Vector3d truth = (T_map_street * placeAtTime(t_s)).translation();
    worst = std::max(worst, (pose.T_map_base.translation() - truth).norm());
  }
  return worst;
}

TEST(PoseSources, Icp3dAndInsGiveTheWayOfALog)
{
  const ScratchFolder scratch;
  writeText(scratch / "some.rawlog", driveLog());
  const auto icp = logs::readLogPoses(scratch / "some.rawlog", poses::PoseSource::icp_3d, {}, {});
  EXPECT_TRUE(icp.report.complete()) << icp.report.damage;
  ASSERT_EQ(icp.poses.size(), 10U);
  EXPECT_EQ(icp.poses.front().T_map_base.translation().norm(), 0);
  EXPECT_LT(worst_m(icp, placeAtTime(0).inverse()), 0.1) << "5.4 m of way";

  poses::PoseParams params;
  params.source = poses::PoseSource::ins;
  params.ins_origin = {kHere.latitude_deg, kHere.longitude_deg, kHere.height_m};
  const auto ins = logs::readLogPoses(scratch / "some.rawlog", params, {}, {});
  EXPECT_TRUE(ins.report.complete()) << ins.report.damage;
  EXPECT_EQ(ins.report.rejected.at("CObservationGPS: its fix is of quality 0"), 1U);
  EXPECT_EQ(ins.report.rejected.at("CObservationGPS: its fix is of quality 6"), 1U);
  EXPECT_EQ(ins.report.notes.count("origin"), 1U);
  EXPECT_GT(ins.poses.size(), 15U);
  // The last 50 ms have no fix behind them; a cubic's one-sided ends.
  EXPECT_LT(worst_m(ins, Eigen::Isometry3d::Identity()), 0.01);
}

TEST(PoseSources, TraverseMapMapsWithThem)
{
  for (const std::string source : {"icp_3d", "ins"})
  {
    const ScratchFolder scratch;
    writeText(scratch / "some.rawlog", driveLog());
    const Finished ran = mapWith(scratch, {"Poses.source=" + source});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const auto metrics = metricsOf(scratch / "out");
    EXPECT_EQ(metrics["pose_source"], source);
    EXPECT_GE(metrics["poses"]["kept"], 10);
    EXPECT_EQ(metrics["poses"]["segments"], 1);
    EXPECT_EQ(metrics["maps"][0]["scans_without_pose"], 0);
    EXPECT_EQ(metrics["pose_notes"].contains("origin"), source == "ins");
  }
}

TEST(PoseSources, ALogWithoutThemIsToldSo)
{
  const ScratchFolder scratch;
  writeText(scratch / "some.rawlog", cloudAt(0));
  for (const std::string source : {"icp_3d", "ins"})
  {
    const Finished ran = mapWith(scratch, {"Poses.source=" + source});
    EXPECT_NE(ran.exit_code, 0);
    EXPECT_THAT(ran.err, ::testing::HasSubstr("the log has no poses of source '" + source + "'"));
  }
}

TEST(PoseSources, WrongOptionsAreRefusedByName)
{
  const ScratchFolder scratch;
  writeText(scratch / "some.rawlog", laserLog(1));
  for (const auto& [setting, name] : std::vector<std::pair<std::string, std::string>>{
           {"Poses.source=icp3d", "icp_3d"},
           {"Poses.icp_3d_voxel_m=-1", "icp_3d_voxel_m"},
           {"Poses.icp_3d_max_range_m=0", "icp_3d_max_range_m"},
           {"Poses.ins_heading=north", "ins_heading"},
           {"Poses.ins_origin=1 2", "ins_origin"},
           {"Poses.ins_origin=91 2 3", "ins_origin"}})
  {
    const Finished ran = mapWith(scratch, {setting});
    EXPECT_EQ(ran.exit_code, 3) << setting;
    EXPECT_THAT(ran.err, ::testing::HasSubstr(name));
  }
}
}  // namespace
