// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// Recordings in ini files, and simulated events as observations.
#include "support/simulated_turns.h"

#include <traverse/observations/to_scan.h>
#include <traverse/simulating/observations.h>
#include <traverse/simulating/recording_file.h>
#include <traverse/simulating/truth_section.h>

#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <gtest/gtest.h>

namespace traverse::testing
{
namespace
{
using mrpt::obs::CObservationVelodyneScan;
using simulation::RecordingParams;

RecordingParams unusualRecording()
{
  RecordingParams params;
  params.vehicle.height_m = 1.7;
  params.drive.xs_m = {0.1, 2, 30};
  params.drive.ys_m = {0, -1.0 / 3, 5};
  params.lidars.resize(2);
  params.lidars[0].label = "LEFT";
  params.lidars[0].model = sensors::VelodyneModel::vlp32c;
  params.lidars[1].label = "RIGHT";
  params.lidars[1].mode = sensors::ReturnMode::last;
  params.lidars[1].repeat_every = 7;
  params.ins.clock_offset_s = 0.015;
  params.odometry.rate_hz = 0;
  return params;
}

TEST(RecordingFile, SaysEverything)
{
  const RecordingParams params = unusualRecording();
  const auto ini = config::IniDocument::fromText(simulating::recordingText(params), "text");
  EXPECT_EQ(simulating::readRecording(ini), params);
}

TEST(RecordingFile, RefusesToWriteATextThatAnIniWouldGiveBackOtherwise)
{
  RecordingParams params;
  params.lidars[0].label = "ROOF//LEFT";  // the rest of the line would be a comment
  EXPECT_THROW(simulating::recordingText(params), config::ConfigError);
}

TEST(RecordingFile, WithoutSectionsIsOneHdl32e)
{
  const auto ini = config::IniDocument::fromText("", "text");
  EXPECT_EQ(simulating::readRecording(ini), RecordingParams{});
}

TEST(TruthSection, SaysEverything)
{
  simulating::TruthSection section;
  section.cells.cell_size_m = 0.1;
  section.cells.large_max_m = 0.3;
  section.at_s = {0.5, 2};
  const auto ini = config::IniDocument::fromText(simulating::truthText(section), "text");
  EXPECT_EQ(simulating::readTruthSection(ini), section);
  const auto usual = config::IniDocument::fromText(simulating::truthText({}), "text");
  EXPECT_EQ(simulating::readTruthSection(usual), simulating::TruthSection());
}

TEST(TruthSection, NamesThePlaceOfWhatItRefuses)
{
  const auto refusal = [](const std::string& text)
  {
    try
    {
      simulating::readTruthSection(config::IniDocument::fromText(text, "scene.ini"));
    }
    catch (const config::ConfigError& e)
    {
      return std::string(e.what());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(
      refusal("[Truth]\nat_s = 3 2\n"),
      "scene.ini:2: [Truth] at_s = '3 2': allowed: times that grow");
  EXPECT_EQ(
      refusal("[Truth]\nflat_m = 1\n").rfind("scene.ini:2: [Truth] unknown key 'flat_m'", 0), 0U);
}

TEST(SimulatedObservation, OfALidarCarriesMrptsOwnCalibration)
{
  for (const auto& [model, name] :
       {std::pair{sensors::VelodyneModel::hdl32e, "HDL32"},
        std::pair{sensors::VelodyneModel::vlp16, "VLP16"}})
  {
    RecordingParams params;
    params.lidars = {perfectLidar(model)};
    simulation::Scene scene = planeScene();
    scene.area = {-5, -5, 5, 5};
    const auto observation = std::dynamic_pointer_cast<CObservationVelodyneScan>(
        simulating::toObservation(turnIn(scene, params.lidars.front()), params));
    ASSERT_TRUE(observation);
    const auto& theirs = mrpt::obs::VelodyneCalibration::LoadDefaultCalibration(name);
    const auto& ours = observation->calibration;
    ASSERT_EQ(ours.laser_corrections.size(), theirs.laser_corrections.size()) << name;
    for (size_t i = 0; i < ours.laser_corrections.size(); ++i)
    {
      const auto& a = ours.laser_corrections[i];
      const auto& b = theirs.laser_corrections[i];
      EXPECT_NEAR(a.verticalCorrection, b.verticalCorrection, 0.005) << name << i;  // 0.01 degree
      EXPECT_NEAR(a.sinVertCorrection, b.sinVertCorrection, 1e-4) << name << i;
      EXPECT_NEAR(a.cosVertCorrection, b.cosVertCorrection, 1e-4) << name << i;
      EXPECT_EQ(a.azimuthCorrection, b.azimuthCorrection) << name << i;
      EXPECT_EQ(a.sinVertOffsetCorrection, b.sinVertOffsetCorrection) << name << i;
      EXPECT_EQ(a.cosVertOffsetCorrection, b.cosVertOffsetCorrection) << name << i;
    }
  }
}

TEST(SimulatedObservation, OfALidarGivesAScanWithTheTruthsPoints)
{
  for (const auto model :
       {sensors::VelodyneModel::hdl32e, sensors::VelodyneModel::vlp16,
        sensors::VelodyneModel::vlp32c})
  {
    RecordingParams params;
    params.lidars = {perfectLidar(model)};
    simulation::Scene scene = planeScene();
    scene.area = {-20, -20, 20, 20};
    const simulation::LidarTurn turn = turnIn(scene, params.lidars.front());
    observations::ObservationParams sensors;
    sensors.min_range_m = 0;
    const auto scan =
        observations::toScan(*simulating::toObservation(turn, params), sensors).decoded.scan;
    const auto direct = decodeTurn(turn).scan;
    EXPECT_EQ(scan.x, direct.x);
    EXPECT_EQ(scan.z, direct.z);
    EXPECT_EQ(scan.stamp, turn.stamp);
    EXPECT_EQ(scan.sensor_label, "LIDAR");
    EXPECT_EQ(scan.size(), turn.returns.size());
  }
}

TEST(SimulatedObservation, OfPosesSaysWhereTheVehicleIs)
{
  const RecordingParams params = unusualRecording();
  simulation::InsPose ins{simulation::kRecordingStart, simulation::kRecordingStart, "INS", {}};
  ins.T_map_base = Eigen::Isometry3d(Eigen::Translation3d(1, 2, 3));
  const auto pose = std::dynamic_pointer_cast<mrpt::obs::CObservationRobotPose>(
      simulating::toObservation(ins, params));
  ASSERT_TRUE(pose);
  EXPECT_EQ(pose->pose.mean.y(), 2);
  EXPECT_NEAR(pose->pose.cov(2, 2), 0.02 * 0.02, 2e-6);
  const simulation::OdometryPose wheels{
      simulation::kRecordingStart, simulation::kRecordingStart, "ODO", 1, 2, 0.5};
  const auto odometry = std::dynamic_pointer_cast<mrpt::obs::CObservationOdometry>(
      simulating::toObservation(wheels, params));
  ASSERT_TRUE(odometry);
  EXPECT_EQ(odometry->odometry.phi(), 0.5);
  EXPECT_EQ(odometry->sensorLabel, "ODO");
}
}  // namespace
}  // namespace traverse::testing
